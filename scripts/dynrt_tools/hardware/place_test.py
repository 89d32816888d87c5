# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place reads and writes around the tools, and what it says without them."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import area, placing

SCRIPTS = project.SCRIPTS
UNIT = """\
// A comment with input wire none,
module sum #(
  parameter DEPTH = 8
) (
  input  wire clk_i,
  input  wire rst_ni,
  input  wire [3:0] a_i,
  input  wire b_i,
  output wire [4:0] sum_o
);
  reg [4:0] sum_q;
  always @(posedge clk_i) sum_q <= rst_ni ? a_i + b_i : 5'd0;
  assign sum_o = sum_q;
endmodule
"""
REPORT = """\
unit       dynrt::List<dynrt::config::thesis>
clock      10.00 ns (Lattice ECP5, speed grade 6)
stages     2
registers  27 bits between stages, 0 of state

stage  registers  longest path, ns  operations
    0          0              4.00  1 not
    1         27              9.60  1 add, 12 and

The longest path of each stage ends at
    0  the read of 'last', units/list.h:17
"""


class Placing(unittest.TestCase):
    def test_schedule_report(self) -> None:
        self.assertEqual(area.schedule(REPORT), {"stages": 2, "longest_path_ns": 9.6})

    def test_the_wrapper_keeps_every_bit(self) -> None:
        # Registers of both sides: 5 bits in and 1 for the way, 5 out, twice, 1 for the fold, 1
        # reset; and the unit's own 5. What nobody could see would be gone.
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name, "sum.v")
            path.write_text(UNIT + placing.wrap("sum", UNIT), encoding="utf-8")
            result = subprocess.run(
                [
                    "yosys",
                    "-p",
                    f"read_verilog {path}; hierarchy -check -top placed; proc; flatten; "
                    "opt -full; splitnets; techmap; opt_clean; stat",
                ],
                capture_output=True,
                text=True,
                check=False,
            )
        self.assertEqual(result.returncode, 0, result.stderr)
        flip_flops = sum(
            int(line.split()[1])
            for line in result.stdout[result.stdout.rindex("Number of cells") :].splitlines()
            if "DFF" in line
        )
        self.assertEqual(flip_flops, 6 + 5 + 6 + 1 + 5)

    def test_no_build_is_said(self) -> None:
        with self.assertRaisesRegex(project.Failed, "no build with hlsc is in /nowhere"):
            placing.find_build(pathlib.Path("/nowhere"))

    def test_unknown_device_lists_those_that_there_are(self) -> None:
        result = subprocess.run(
            [SCRIPTS / "place", "--device", "virtex2-6000"],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr,
            "place: there is no way to place on 'virtex2-6000'; the "
            "devices are ice40-hx8k, ecp5-85\n",
        )

    @unittest.skipIf(shutil.which("nextpnr-ecp5"), "nextpnr-ecp5 is there")
    def test_a_missing_tool_is_said(self) -> None:
        result = subprocess.run(
            [SCRIPTS / "place", "--device", "ecp5-85", "--build", "/nowhere"],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertIn(
            "place: nextpnr-ecp5 is not on the PATH (Debian 12 has no package of it", result.stderr
        )


if __name__ == "__main__":
    unittest.main()
