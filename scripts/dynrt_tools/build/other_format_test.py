# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A core in an odd number format, truncated: its RTL gives the model's frame, and takes the very
clocks that the model counts by hlsc's schedules. The model alone judges the formats of an error
report; this is one of them through the Verilog, scheduled as a report schedules it.

Usage: python3 -m dynrt_tools.build.other_format_test PROGRAM BUILD
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from dynrt_tools import project

PROGRAM, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
STATED = project.ROOT / "verif" / "core" / "other_format.json"
FRAME = ("blocks", "--size", "48x32", "--packets", "8")


def run(*command: str | pathlib.Path) -> str:
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{command}: {result.stdout}{result.stderr}")
    return result.stdout.strip()


def configuration(kind: str) -> str:
    """The file of the core, a library."""
    script = project.SCRIPTS / "configuration"
    return run(script, STATED, kind, "--clock-ns", "least", "--build", BUILD)


def cycles(*flags: str) -> int:
    """The clocks of the frame."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        figures = folder / "figures.json"
        outputs = ("--out", folder / "frame.png", "--json", figures)
        run(PROGRAM, "render", *FRAME, *flags, *outputs)
        clocks: int = project.read_json(figures)["frame"]["cycles"]
        return clocks


class OtherFormat(unittest.TestCase):
    def test_the_rtl_is_the_model_bits_and_clocks(self) -> None:
        core = configuration("--rtl")
        self.assertIn("0 + 0 + 0 differ", run(PROGRAM, "compare", *FRAME, "--config", core))
        rtl = cycles("--config", core, "--board", "rtl")
        model = cycles(
            "--config", core, "--board", "model", "--schedule", configuration("--verilog")
        )
        self.assertGreater(rtl, 1000)
        self.assertEqual(rtl, model)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
