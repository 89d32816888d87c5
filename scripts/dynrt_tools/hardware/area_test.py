# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The area of a core: the sum of its units and of the Verilog that joins them."""

import unittest
from unittest import mock

from dynrt_tools import testing
from dynrt_tools.hardware import area, synthesis


class Area(testing.InFolder):
    VERILOG = (
        "// Generated from one (a.h)\nmodule one #(\n  parameter N = 8\n) (\n"
        "  input wire [N-1:0] a,  // a.h:7\n  output wire b\n);\n  assign b = ^a;\nendmodule\n"
    )

    REPORT = (
        "clock      10.00 ns\nstages     2\n\nstage  registers  longest path, ns  "
        "operations\n    0                      4.45  1 and\n    1         30        "
        "      9.90  2 eq\n\nThe longest path of each stage ends at\n    0  'both'\n"
    )

    def test_black_box(self) -> None:
        box = area.black_box(self.VERILOG)
        self.assertIn("input wire [N-1:0] a,", box)
        self.assertNotIn("assign", box)
        self.assertNotIn("//", box)

    def test_a_core_is_the_sum_of_its_units_and_of_what_joins_them(self) -> None:
        folder = self.folder
        (folder / "one.v").write_text(self.VERILOG, encoding="utf-8")
        (folder / "one.txt").write_text(self.REPORT, encoding="utf-8")
        (folder / "dynrt_core.vh").write_text("", encoding="utf-8")
        (folder / "dynrt_core.v").write_text(
            "module dynrt_core (\n  input wire [7:0] a,\n  input wire clk,\n"
            "  output reg [1:0] b\n);\n  wire [1:0] c;\n  one u_one_0 (\n    .a(a), .b(c[0]));\n"
            "  one u_one_1 (\n    .a(~a), .b(c[1]));\n  always @(posedge clk) b <= c;\nendmodule\n",
            encoding="utf-8",
        )
        with mock.patch.object(synthesis, "KEPT", folder / "kept"):
            figures = area.hardware(folder)
            one, join = figures["units"]["one"], figures["units"]["dynrt_core"]
            with mock.patch.object(synthesis, "run_yosys", side_effect=AssertionError):
                self.assertEqual(area.hardware(folder), figures)
        self.assertEqual((one["instances"], one["area"]["FF"], join["area"]["FF"]), (2, 0, 2))
        self.assertGreaterEqual(one["area"]["LUT"], 2)
        self.assertEqual(figures["area"]["LUT"], 2 * one["area"]["LUT"] + join["area"]["LUT"])
        self.assertEqual(figures["takes"]["FF"], 2)
        self.assertEqual(
            (figures["schedule"], one["longest_path_ns"]), ({"stages": 2, "clock_ns": 10.0}, 9.9)
        )


if __name__ == "__main__":
    unittest.main()
