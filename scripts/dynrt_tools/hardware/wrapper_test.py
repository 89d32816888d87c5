# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The module around what is placed: it must keep every bit, of every copy, on one clock."""

import pathlib
import subprocess
import tempfile
import unittest

from dynrt_tools.hardware import wrapper

SUM = """\
// A comment with input wire none,
`define WIDTH 4
module sum #(
  parameter DEPTH = 8
) (
  input  wire clk_i,
  input  wire core_clk_i,
  input  wire rst_ni,
  input  wire [`WIDTH-1:0] a_i,
  input  wire b_i,
  output wire [DEPTH-4:0] sum_o
);
  reg [4:0] sum_q;
  always @(posedge core_clk_i) sum_q <= rst_ni ? a_i + b_i : 5'd0;
  assign sum_o = sum_q;
endmodule
"""


class Wrapper(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.source = self.folder / "sum.v"
        self.source.write_text(SUM, encoding="utf-8")
        self.ports = wrapper.ports("sum", [self.source], self.folder)

    def flip_flops(self, copies: int) -> int:
        path = self.folder / "all.v"
        path.write_text(SUM + wrapper.wrap("sum", self.ports, copies), encoding="utf-8")
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
        return sum(
            int(line.split()[1])
            for line in result.stdout[result.stdout.rindex("Number of cells") :].splitlines()
            if "DFF" in line
        )

    def test_widths_are_those_of_the_parameters_and_macros(self) -> None:
        found = {p.name: (p.direction, p.width) for p in self.ports}
        self.assertEqual(found["a_i"], ("input", 4))
        self.assertEqual(found["sum_o"], ("output", 5))

    def test_every_clock_of_the_module_is_the_wrapper_s(self) -> None:
        text = wrapper.wrap("sum", self.ports)
        self.assertIn(".clk_i(clk_i), .core_clk_i(clk_i), .rst_ni(rst_q)", text)

    def test_it_keeps_every_bit(self) -> None:
        # Registers of both sides: 5 bits in and 1 for the way, 5 out, twice, 1 for the fold, 1
        # reset; and the unit's own 5. What nobody could see would be gone.
        self.assertEqual(self.flip_flops(1), 6 + 5 + 6 + 1 + 5)

    def test_copies_are_not_merged(self) -> None:
        self.assertEqual(self.flip_flops(3), 3 * 5 + 1 + 3 * 5 + 3 * 5 + 1 + 1 + 3 * 5)


if __name__ == "__main__":
    unittest.main()
