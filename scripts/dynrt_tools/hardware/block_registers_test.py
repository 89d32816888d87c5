# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which registers move into multipliers and block RAM, by what Yosys makes of small modules. That such
a block does the same is the test netlist.cells."""

import pathlib
import tempfile
import unittest
from collections import Counter
from typing import Any
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import block_registers, synthesis
from dynrt_tools.hardware.block_registers import BLOCK_RAM, FLIP_FLOP, MULTIPLIER

MODULE = """\
module blocks (
  input clk_i, other_i, en_i, rst_ni, write_i, input [8:0] a_i, b_i, input [10:0] to_i, from_i,
  input [35:0] row_i, output reg [17:0] product_o, more_o, output reg [35:0] row_o);
{body}
endmodule
"""
# A RAM whose output is `row`, on any clocks.
RAM = """\
  (* no_rw_check *) reg [{width}-1:0] rows[0:{rows}-1];
  reg [{width}-1:0] row;
  always @(posedge {write_clock}) if (write_i) rows[to_i] <= row_i;
  always @({read_clock}) if (en_i) row <= rows[from_i];
{body}"""
SHAPES = {9: 2048, 36: 512}  # rows by the width of a row; the wider takes the outputs of both ports


class Blocks(unittest.TestCase):
    block = ""  # the type of those that take registers, or not

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.netlist = self.folder / "netlist.json"

    def synthesized(self, body: str) -> None:
        source = self.folder / "blocks.v"
        source.write_text(MODULE.format(body=body), encoding="utf-8")
        synthesis.run_yosys(
            [
                *synthesis.read_commands([source]),
                "synth_ecp5 -nowidelut -top blocks",
                f"write_json {self.netlist}",
            ],
            self.folder,
            "blocks",
        )

    def cells(self) -> list[Any]:
        return list(project.read_json(self.netlist)["modules"]["blocks"]["cells"].values())

    def packed(self) -> tuple[int, Counter[str]]:
        """How many registers have moved, and the cells after that."""
        moved = block_registers.pack(self.netlist)
        cells = self.cells()
        registered = [
            cell
            for cell in cells
            if cell["parameters"].get("REG_OUTPUT_CLK") == "CLK0"
            or cell["parameters"].get("REGMODE_B") == "OUTREG"
        ]
        self.assertEqual(Counter(cell["type"] for cell in registered), moved)
        return moved[self.block], Counter(cell["type"] for cell in cells)

    def assert_stays(self, body: str, registers: int = 18) -> None:
        """There is one block, and what may be behind it stays in as many flip-flops."""
        self.synthesized(body)
        moved, cells = self.packed()
        self.assertEqual((moved, cells[self.block]), (0, 1))
        self.assertGreaterEqual(cells[FLIP_FLOP], registers)


class Version(unittest.TestCase):
    def test_it_is_of_the_text(self) -> None:
        present = block_registers.version()
        with mock.patch.object(pathlib.Path, "read_bytes", lambda _: b"another"):
            self.assertNotEqual(block_registers.version(), present)


class Multipliers(Blocks):
    block = MULTIPLIER

    def test_a_register_behind_a_product_moves(self) -> None:
        self.synthesized(
            "always @(posedge clk_i) begin product_o <= a_i * b_i; more_o <= product_o; end"
        )
        moved, cells = self.packed()
        self.assertEqual((moved, cells[MULTIPLIER], cells[FLIP_FLOP]), (1, 1, 18))

    def test_part_of_a_product_moves(self) -> None:
        self.synthesized(
            "wire [17:0] p = a_i * b_i;\n"
            "always @(posedge clk_i) begin product_o <= p[17:9]; more_o <= 18'd0; end"
        )
        moved, cells = self.packed()
        self.assertEqual((moved, cells[FLIP_FLOP]), (1, 0))

    def test_an_initial_value_of_zero_moves(self) -> None:
        self.synthesized(
            "initial product_o = 18'd0;\nalways @(posedge clk_i) product_o <= a_i * b_i;"
        )
        self.assertEqual(self.packed()[0], 1)

    def test_a_flip_flop_that_does_not_name_its_enable_moves(self) -> None:
        self.synthesized("always @(posedge clk_i) product_o <= a_i * b_i;")
        design = project.read_json(self.netlist)
        left_out = [
            cell["parameters"].pop("CEMUX")
            for cell in design["modules"]["blocks"]["cells"].values()
            if cell["type"] == FLIP_FLOP
        ]
        self.assertEqual(len(left_out), 18)
        project.write_json(self.netlist, design)
        self.assertEqual(self.packed()[0], 1)

    def test_a_product_that_something_else_reads_stays(self) -> None:
        self.assert_stays(
            "wire [17:0] p = a_i * b_i;\n"
            "always @(posedge clk_i) begin product_o <= p; more_o <= p + 1; end"
        )

    def test_a_register_with_an_enable_stays(self) -> None:
        self.assert_stays("always @(posedge clk_i) if (en_i) product_o <= a_i * b_i;")

    def test_a_register_with_a_reset_stays(self) -> None:
        self.assert_stays("always @(posedge clk_i) product_o <= rst_ni ? a_i * b_i : 18'd0;")

    def test_an_initial_value_of_ones_stays(self) -> None:
        self.assert_stays(
            "initial product_o = 18'h3ffff;\nalways @(posedge clk_i) product_o <= a_i * b_i;"
        )

    def test_a_register_on_the_falling_edge_stays(self) -> None:
        self.assert_stays("always @(negedge clk_i) product_o <= a_i * b_i;")

    def test_a_product_of_two_clocks_stays(self) -> None:
        self.assert_stays(
            "wire [17:0] p = a_i * b_i;\n"
            "always @(posedge clk_i) product_o <= {9'd0, p[8:0]};\n"
            "always @(posedge other_i) more_o <= {9'd0, p[17:9]};"
        )


class BlockRams(Blocks):
    block = BLOCK_RAM

    def ram(
        self, width: int, body: str, write_clock: str = "clk_i", read_clock: str = "posedge clk_i"
    ) -> str:
        return RAM.format(
            width=width,
            rows=SHAPES[width],
            body=body,
            write_clock=write_clock,
            read_clock=read_clock,
        )

    def assert_all_stay(self, body: str, **clocks: str) -> None:
        for width in SHAPES:
            with self.subTest(width=width):
                self.assert_stays(self.ram(width, body, **clocks), width)

    def test_a_register_behind_a_ram_moves(self) -> None:
        for width in SHAPES:
            with self.subTest(width=width):
                self.synthesized(self.ram(width, "  always @(posedge clk_i) row_o <= row;"))
                moved, cells = self.packed()
                self.assertEqual((moved, cells[BLOCK_RAM], cells[FLIP_FLOP]), (1, 1, 0))
                (ram,) = (cell for cell in self.cells() if cell["type"] == BLOCK_RAM)
                modes = [ram["parameters"][f"REGMODE_{port}"] for port in "AB"]
                self.assertEqual(modes, ["OUTREG" if width == 36 else "NOREG", "OUTREG"])
                enables = [ram["connections"][f"OCE{port}"] for port in "AB"]
                self.assertEqual(enables, [["1"], ["1"]])

    def test_a_row_that_something_else_reads_stays(self) -> None:
        self.assert_all_stay("  always @(posedge clk_i) begin row_o <= row; more_o[0] <= ^row; end")

    def test_a_register_with_an_enable_stays(self) -> None:
        self.assert_all_stay("  always @(posedge clk_i) if (rst_ni) row_o <= row;")

    def test_a_register_with_a_reset_stays(self) -> None:
        self.assert_all_stay("  always @(posedge clk_i) row_o <= rst_ni ? row : 36'd0;")

    def test_an_initial_value_of_ones_stays(self) -> None:
        self.assert_all_stay(
            "  initial row_o = 36'hfffffffff;\n  always @(posedge clk_i) row_o <= row;"
        )

    def test_a_register_on_the_other_edge_stays(self) -> None:
        self.assert_all_stay("  always @(negedge clk_i) row_o <= row;")
        self.assert_all_stay("  always @(posedge clk_i) row_o <= row;", read_clock="negedge clk_i")

    def test_a_register_of_another_clock_stays(self) -> None:
        self.assert_all_stay("  always @(posedge other_i) row_o <= row;")

    def test_a_wide_row_written_with_another_clock_stays(self) -> None:
        body = "  always @(posedge clk_i) row_o <= row;"
        self.assert_stays(self.ram(36, body, write_clock="other_i"), 36)
        self.synthesized(self.ram(9, body, write_clock="other_i"))
        self.assertEqual(self.packed()[0], 1)


if __name__ == "__main__":
    unittest.main()
