# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the gate rule against netlists counted by hand, and the report against its own reader."""

import collections
import subprocess
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import gate_report, gate_rule, gate_units
from dynrt_tools.hardware.gate_rule import Memory


def cell(kind: str, **ends: list[int | str]) -> project.Json:
    return {
        "type": kind,
        "connections": ends,
        "parameters": {},
        "port_directions": {p: "output" if p in ("O", "Q", "P") else "input" for p in ends},
    }


def ram(rows: int, width: int, read: list[int], write: list[int] | None = None) -> project.Json:
    address = len(read)
    return {
        "type": "$mem_v2",
        "connections": {"RD_ADDR": read, "WR_ADDR": write or []},
        "parameters": {
            "MEMID": "\\u.torn.rows",
            "SIZE": f"{rows:b}",
            "WIDTH": f"{width:b}",
            "ABITS": f"{address:b}",
            "RD_PORTS": "1",
            "WR_PORTS": "1" if write else "0",
        },
    }


class Rule(testing.InFolder):
    def gates(self, *cells: project.Json) -> float:
        return gate_rule.count({f"c{i}": c for i, c in enumerate(cells)}).logic

    def test_luts_by_their_inputs(self) -> None:
        self.assertEqual(
            self.gates(
                cell("LUT4", O=[9]), cell("LUT3", O=[8]), cell("LUT2", O=[7]), cell("INV", O=[6])
            ),
            9 + 6 + 6 + 1,
        )

    def test_flip_flops(self) -> None:
        plain = cell("FDRE", Q=[5], D=[4], C=[3], CE=["1"], R=["0"])
        enabled = cell("FDRE", Q=[6], D=[4], C=[3], CE=[2], R=["0"])
        reset = cell("FDSE", Q=[7], D=[4], C=[3], CE=["1"], S=[2])
        self.assertEqual(self.gates(plain), 6)
        self.assertEqual(self.gates(plain, enabled, reset), 6 + 8 + 8)

    def test_an_adder_of_two_bits_is_two_full_adders(self) -> None:
        bits = [
            cell("LUT2", I0=[1], I1=[2], O=[10]),
            cell("MUXCY", S=[10], DI=[1], CI=["0"], O=[20]),
            cell("XORCY", LI=[10], CI=["0"], O=[30]),
            cell("LUT2", I0=[3], I1=[4], O=[11]),
            cell("XORCY", LI=[11], CI=[20], O=[31]),
        ]
        self.assertEqual(self.gates(*bits), 2 * 9)

    def test_what_more_a_lut_computes_counts(self) -> None:
        # An addend that is selected by a third input; and a LUT whose output goes elsewhere too.
        self.assertEqual(
            self.gates(cell("LUT3", O=[10]), cell("XORCY", LI=[10], CI=["0"], O=[30])), 6 + 9
        )
        self.assertEqual(
            self.gates(
                cell("LUT2", O=[10]),
                cell("XORCY", LI=[10], CI=["0"], O=[30]),
                cell("LUT4", I0=[10], O=[40]),
            ),
            6 + 9 + 9,
        )

    def test_multipliers(self) -> None:
        self.assertEqual(self.gates(cell("MULT18X18", P=[1]), cell("MULT18X18S", P=[2])), 14000)

    def test_memory_bits(self) -> None:
        def bits(memory: project.Json) -> tuple[Memory, ...]:
            return gate_rule.count({"m": memory}).memories

        self.assertEqual(bits(ram(32, 5, [1, 2], [1, 2])), (Memory("u", 32, 5, 1),))
        self.assertEqual(bits(ram(32, 5, [1, 2], [3, 4]))[0].bits, 2 * 160)
        self.assertEqual(bits(ram(4, 8, [1, 2]))[0].bits, 32, "a table that nobody writes")
        two = ram(4, 8, [1, 2, 3, 4], [5, 6])
        two["parameters"] |= {"ABITS": "10", "RD_PORTS": "10"}
        self.assertEqual(bits(two)[0].bits, 2 * 64, "two readers: two copies")
        one = ram(1, 8, [])
        self.assertEqual(bits(one)[0].bits, 8, "one row: a register")

    def test_an_unknown_cell_is_refused(self) -> None:
        with self.assertRaisesRegex(gate_rule.Uncounted, "no gates for the cell c0 of type DSP48"):
            self.gates(cell("DSP48", P=[1]))

    def test_yosys_agrees_with_the_hand(self) -> None:
        # 8 enabled flip-flops, an adder of 8 bits in front of them, a dual-port RAM of 16 x 4.
        source = """module top(input c, input e, input [7:0] a, output reg [7:0] q,
                      input [3:0] w, input [3:0] r, input [3:0] d, output [3:0] o);
          reg [3:0] rows[0:15]; assign o = rows[r];
          always @(posedge c) begin if (e) q <= q + a; rows[w] <= d; end
        endmodule"""
        synth = (
            "synth_xilinx -family xc2v -flatten -nowidelut -noiopad -noclkbuf -nosrl -top top -run "
        )
        path, netlist = self.folder / "top.v", self.folder / "top.json"
        path.write_text(source, encoding="utf-8")
        script = (
            f"read_verilog {path}; {synth}begin:map_memory; {synth}fine:check; write_json {netlist}"
        )
        subprocess.run(["yosys", "-q", "-p", script], check=True, capture_output=True)
        module = project.read_json(netlist)["modules"]["top"]
        counted = gate_rule.count(module["cells"])
        self.assertEqual(counted.logic, 8 * 8 + 8 * 9)
        self.assertEqual(counted.bits, 2 * 64)


class Report(unittest.TestCase):
    def test_the_fit_finds_a_plane(self) -> None:
        points = [(32, 512), (64, 512), (8, 512), (32, 64)]
        values = [1000 + 50 * p + 3 * c for p, c in points]
        for found, wanted in zip(gate_rule.fit(points, values), (1000, 50, 3)):
            self.assertAlmostEqual(found, wanted, places=6)
        with self.assertRaisesRegex(ValueError, "on a line"):
            gate_rule.fit([(1, 1), (2, 2), (3, 3)], [1, 2, 3])

    def test_the_thesis_adds_up(self) -> None:
        self.assertEqual(sum(u.logic for u in gate_units.PACKET_UNITS), 487020)
        self.assertEqual(sum(u.bits for u in gate_units.PACKET_UNITS), 14007)
        self.assertEqual(sum(u.logic for u in gate_units.CACHE_UNITS), 17803)
        self.assertEqual(gate_units.gates(32, 512) + 17803, 2807671)
        units = {
            u.name: (u.bits, 512 if u in gate_units.CACHE_UNITS else 32)
            for u in gate_report.TABULATED
        }
        for name, rows in gate_units.COMPLEXITY_ROWS.items():
            kilobytes = sum(units[r][0] * units[r][1] for r in rows) / 8 / 1024
            self.assertLess(abs(kilobytes - gate_units.COMPLEXITY[name][4]), 0.07, name)

    def test_what_is_written_is_what_is_read(self) -> None:
        def core(packets: int, lines: int) -> dict[str, gate_rule.Count]:
            count = gate_rule.Count
            return {
                "join": count(
                    collections.Counter({"LUT4": 10}),
                    (Memory("ray_0_ram_0", 2 * packets, 144, 2), Memory("queue", packets, 3, 2)),
                ),
                "list": count(
                    collections.Counter({"flip-flop": packets}),
                    (Memory("request_fifo", packets, 25, 2),),
                ),
                "node_lookup": count(collections.Counter({"LUT3": 7}), ()),
                "node_fill": count(
                    collections.Counter(), (Memory("node_lines_ram_0", lines, 84, 2),)
                ),
            }

        counts = {point: core(*point) for point in ((32, 512), (64, 512), (32, 64), (8, 512))}
        text = gate_report.document(counts)
        figures = gate_report.figures(text)
        self.assertEqual(figures, gate_report.summary(counts[32, 512]))
        self.assertEqual(figures["DynamicRTC gates"], 90)
        self.assertEqual(figures["TraversalSlice0 bits"], 64 * 144 * 2)
        self.assertIn("| `TraversalSlice0` | 43,107 | 0 | 2,352 | 576 |", text)
        self.assertIn("ours     Bits_RTC(P, CL) = 0 + 632 P + 168 CL", text)


if __name__ == "__main__":
    unittest.main()
