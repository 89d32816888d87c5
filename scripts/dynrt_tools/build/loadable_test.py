# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""CMake configures a configuration alone, whichever part of its core is asked for: no folder that it
takes asks for what only the whole project has.

Usage: python3 -m dynrt_tools.build.loadable_test BUILD
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from dynrt_tools.build import configuration
from dynrt_tools.build.configs import read_file
from dynrt_tools.project import ROOT

BUILD = pathlib.Path(sys.argv[1]).resolve()
STATED = ROOT / "verif" / "core" / "other_format.json"


class Loadable(unittest.TestCase):
    def test_each_kind_is_configured(self) -> None:
        build = configuration.find_build(BUILD)
        for kind, made in configuration.KINDS.items():
            with self.subTest(kind), tempfile.TemporaryDirectory() as name:
                builder = configuration.Builder(kind, read_file(STATED), build, 1, lambda _: None)
                clock = build["variables"][configuration.CLOCK]
                tree = builder.configure(pathlib.Path(name), clock)
                listed = subprocess.run(
                    ["cmake", "--build", tree, "--target", "help"],
                    capture_output=True,
                    text=True,
                    check=True,
                )
                self.assertRegex(listed.stdout, rf"(?m)^{made['target']}: ")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
