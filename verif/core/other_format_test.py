#!/usr/bin/env python3
# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A core in an odd number format, truncated: its RTL gives the model's frame, and takes the very
clocks that the model counts by hlsc's schedules. The formats of an error report are judged by the
model alone; this is one of them through the Verilog.

Usage: other_format_test.py PROGRAM BUILD
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
FRAME = ("blocks", "--size", "48x32", "--packets", "8")


def run(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{command}: {result.stdout}{result.stderr}")
    return result.stdout.strip()


def configuration(kind):
    return run(
        HERE.parents[1] / "scripts" / "configuration",
        HERE / "other_format.json",
        kind,
        "--build",
        BUILD,
    )


def cycles(*flags):
    with tempfile.TemporaryDirectory() as folder:
        figures = pathlib.Path(folder) / "figures.json"
        run(
            PROGRAM,
            "render",
            *FRAME,
            *flags,
            "--out",
            pathlib.Path(folder) / "frame.png",
            "--json",
            figures,
        )
        return json.loads(figures.read_text(encoding="utf-8"))["frame"]["cycles"]


class OtherFormat(unittest.TestCase):
    def test_the_rtl_is_the_model_bits_and_clocks(self):
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
