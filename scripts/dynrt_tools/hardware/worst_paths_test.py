# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The longest paths of an SDF file, and the unit, signal and source line of their ends."""

import pathlib
import re
import shutil
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import (
    block_registers,
    source_names,
    synthesis,
    timing_graph,
    worst_paths,
    wrapper,
)
from dynrt_tools.hardware.placed_example import SDF, with_second_bit

SUM = """\
module sum (input clk_i, input rst_ni, input [3:0] a_i, input [3:0] b_i, output [3:0] sum_o);
  wire [3:0] added_s0 = a_i + b_i;  // units/sum.h:12
  reg [3:0] added_s1;
  always @(posedge clk_i)
    added_s1 <= added_s0;
  reg valid_q;
  always @(posedge clk_i)
    valid_q <= rst_ni;
  assign sum_o = valid_q ? added_s1 : 4'd0;
endmodule
module dynrt_core (input clk_i, input rst_ni, input [3:0] a_i, input [3:0] b_i, output [3:0] o);
  sum u_adder (
    .clk_i(clk_i), .rst_ni(rst_ni), .a_i(a_i), .b_i(b_i), .sum_o(o));
endmodule
"""

SCALED = """\
module scaled (input clk_i, input rst_ni, input [17:0] a_i, input [17:0] b_i, output [17:0] o);
  reg [17:0] a_s1, b_s1, estimate_s2;
  wire [35:0] mul_s1 = a_s1 * b_s1;  // units/scaled.h:8
  wire [17:0] estimate_s1 = mul_s1[35:18];  // units/scaled.h:9
  always @(posedge clk_i) begin
    a_s1 <= a_i;
    b_s1 <= b_i;
    estimate_s2 <= estimate_s1;
  end
  assign o = estimate_s2;
endmodule
"""


class Paths(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def graph(self, text: str = SDF) -> timing_graph.Graph:
        path = self.folder / "timing.sdf"
        path.write_text(text, encoding="utf-8")
        return timing_graph.read_sdf(path)

    def test_the_longest_path_and_its_parts(self) -> None:
        timing = timing_graph.Timing(self.graph())
        ((ns, end),) = timing.endpoints()
        self.assertEqual(end, ("end[0]", "D"))
        self.assertAlmostEqual(ns, 4.1)
        hops = timing.path(end)
        self.assertEqual([h.cell for h in hops], ["start", "g", "f", "end[0]"])
        self.assertEqual([h.into for h in hops], ["CLK", "A", "B", "D"])
        self.assertEqual([h.fanout for h in hops], [2, 1, 2, 0])
        self.assertAlmostEqual(sum(h.wire_ns for h in hops), 3.0)

    def test_a_clock_that_comes_late(self) -> None:
        late = SDF.replace("start/CLK (0:0:0)", "start/CLK (400:400:400)")
        late = late.replace("end\\[0\\]/CLK (0:0:0)", "end\\[0\\]/CLK (100:100:100)")
        for skew, expected in ((False, 4.1), (True, 4.1 + 0.4 - 0.1)):
            timing = timing_graph.Timing(self.graph(late), skew)
            self.assertAlmostEqual(timing.endpoints()[0][0], expected)

    def test_a_file_that_says_nothing_is_refused(self) -> None:
        with self.assertRaisesRegex(project.Failed, "names no wires"):
            self.graph("(DELAYFILE\n)\n")

    def names(self, module: str, joins: bool) -> tuple[source_names.Names, list[str]]:
        source = self.folder / "sum.v"
        source.write_text(SUM, encoding="utf-8")
        outer = self.folder / "placed.v"
        ports = wrapper.ports(module, [source], self.folder)
        outer.write_text(wrapper.wrap(module, ports, 2), encoding="utf-8")
        netlist = self.folder / "netlist.json"
        synthesis.run_yosys(
            [
                f"read_verilog {source} {outer}",
                "synth_ice40 -top placed",
                f"write_json {netlist}",
            ],
            self.folder,
            module,
        )
        cells = project.read_json(netlist)["modules"]["placed"]["cells"]
        registers = [c for c, cell in cells.items() if "DFF" in cell["type"]]
        return source_names.Names(netlist, self.folder, module, joins), registers

    def origins(self, module: str, joins: bool) -> set[source_names.Origin]:
        names, registers = self.names(module, joins)
        return {names.origin(f"{r}_DFFLC", "Q") for r in registers}

    def test_registers_have_the_line_of_the_value_that_they_keep(self) -> None:
        for module, joins, unit in (("sum", False, "sum"), ("dynrt_core", True, "adder")):
            found = self.origins(module, joins)
            for copy in (0, 1):
                self.assertIn(
                    source_names.Origin(
                        f"{unit} of copy {copy}", "added_s1[2]", "hls/units/sum.h:12"
                    ),
                    found,
                )
            self.assertIn(source_names.Origin("wrapper", "rst_q", "placed.v:7"), found)

    def test_a_flip_flop_behind_a_lut_of_its_name_is_found(self) -> None:
        names, registers = self.names("sum", False)
        cells = project.read_json(self.folder / "netlist.json")["modules"]["placed"]["cells"]
        luts = {
            cell["connections"]["O"][0]: lut
            for lut, cell in cells.items()
            if cell["type"] == "SB_LUT4"
        }
        packed = [
            (register, luts[bit])
            for register in registers
            if (bit := cells[register]["connections"]["D"][0]) in luts
        ]
        self.assertGreater(len(packed), 3)
        for register, lut in packed:
            self.assertEqual(names.register(f"{lut}_LC"), names.register(f"{register}_DFFLC"))
        signals = {names.register(f"{register}_DFFLC").signal for register in registers}
        self.assertIn("added_s1[2]", signals)

    def test_a_path_ends_at_the_flip_flop_that_is_packed_behind_a_lut(self) -> None:
        names, registers = self.names("sum", False)
        cells = project.read_json(self.folder / "netlist.json")["modules"]["placed"]["cells"]
        behind = {cells[r]["connections"]["D"][0]: r for r in registers}
        lut, register = next(
            (name, behind[cell["connections"]["O"][0]])
            for name, cell in cells.items()
            if cell["type"] == "SB_LUT4" and cell["connections"]["O"][0] in behind
        )
        escaped = re.sub(r"(\W)", r"\\\1", f"{lut}_LC")
        text = SDF.replace("end\\[0\\]", escaped)
        worst = worst_paths.worst(timing_graph.Timing(self.graph(text)), names, 5.0)
        path = worst["paths"][0]
        said = names.register(f"{register}_DFFLC")
        for end in (path["to"], path["hops"][-1]):
            self.assertEqual((end["unit"], end["signal"]), (said.unit, said.signal))
            self.assertEqual(end["source"], said.source)
        self.assertNotEqual(said, names.origin(f"{lut}_LC"))

    def test_without_a_cplusplus_line_the_verilog_s_is_named(self) -> None:
        names, registers = self.names("sum", False)
        found = [names.origin(r, "Q") for r in registers if "valid_q" in r]
        self.assertTrue(found)
        for origin in found:
            self.assertEqual(origin.source, "sum.v:6")

    def test_a_register_in_a_multiplier_has_the_name_of_its_lowest_bit(self) -> None:
        source = self.folder / "scaled.v"
        source.write_text(SCALED, encoding="utf-8")
        ports = wrapper.ports("scaled", [source], self.folder)
        outer = self.folder / "placed.v"
        outer.write_text(wrapper.wrap("scaled", ports), encoding="utf-8")
        netlist = self.folder / "netlist.json"
        synthesis.run_yosys(
            [
                f"read_verilog {source} {outer}",
                "synth_ecp5 -nowidelut -top placed",
                f"write_json {netlist}",
            ],
            self.folder,
            "scaled",
        )
        moved = block_registers.pack(netlist)
        self.assertEqual(moved, {block_registers.MULTIPLIER: 1})
        cells = project.read_json(netlist)["modules"]["placed"]["cells"]
        names = source_names.Names(netlist, self.folder, "scaled")
        (multiplier,) = (
            name for name, cell in cells.items() if cell["type"] == block_registers.MULTIPLIER
        )
        self.assertEqual(
            names.register(multiplier),
            source_names.Origin("scaled", "estimate_s2[0]", "hls/units/scaled.h:8"),
            "a path ends at the product",
        )

    def test_a_memory_s_cells_are_its_declaration(self) -> None:
        source = project.ROOT / "rtl" / "lib" / "hls_fifo.v"
        ports = wrapper.ports("hls_fifo", [source], self.folder)
        outer = self.folder / "placed.v"
        outer.write_text(wrapper.wrap("hls_fifo", ports), encoding="utf-8")
        shutil.copyfile(source, self.folder / source.name)
        netlist = self.folder / "netlist.json"
        synthesis.run_yosys(
            [
                f"read_verilog {source} {outer}",
                "synth_ecp5 -nowidelut -top placed",
                f"write_json {netlist}",
            ],
            self.folder,
            "hls_fifo",
        )
        cells = project.read_json(netlist)["modules"]["placed"]["cells"]
        names = source_names.Names(netlist, self.folder, "hls_fifo")
        rams = [name for name, cell in cells.items() if cell["type"] == "TRELLIS_DPR16X4"]
        self.assertTrue(rams)
        lines = source.read_text(encoding="utf-8").splitlines()
        for ram in rams:
            origin = names.origin(f"{ram}$DPRAM_COMB2", "F")
            self.assertEqual((origin.unit, origin.signal), ("hls_fifo", "rows"))
            file, _, line = origin.source.partition(":")
            self.assertEqual(file, "rtl/lib/hls_fifo.v")
            self.assertRegex(lines[int(line) - 1], r"reg .*rows +\[")

    def test_bits_of_one_path_are_one(self) -> None:
        text = with_second_bit()
        worst = worst_paths.worst(
            timing_graph.Timing(self.graph(text)), self.names("sum", False)[0], 4.0
        )
        self.assertEqual((worst["endpoints"], worst["too_slow"]), (2, 2))
        self.assertEqual(len(worst["paths"]), 1)
        path = worst["paths"][0]
        self.assertEqual((path["endpoints"], path["levels"]), (2, 2))
        self.assertEqual((path["logic_ns"], path["wire_ns"]), (1.1, 3.0))


if __name__ == "__main__":
    unittest.main()
