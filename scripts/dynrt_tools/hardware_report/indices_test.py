# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The thesis's indices, by numbers that are computed by hand."""

import unittest
from collections import Counter

from dynrt_tools.hardware import gate_rule, gate_units, rtl_files
from dynrt_tools.hardware_report import example, gates, indices, rows
from dynrt_tools.project import Json

SLICES = [f"slice_{i}" for i in range(8)]


class Indices(unittest.TestCase):
    def test_by_hand(self) -> None:
        found = indices.indices(self.gates(4, 2), example.mean_frame(4, 2))
        # The slice works in 0.4 of the clocks with 300 gates, the intersection in 0.2 with 100.
        use = (300 * 0.4 + 100 * 0.2) / 400
        logic, memory = 1040, 860
        self.assertAlmostEqual(found["U_AU"], 100 * use)
        self.assertAlmostEqual(found["QHW"], 100 * use * logic / (logic + memory))
        self.assertAlmostEqual(found["QGHW"], 1e6 * (768 / 19200) / (logic + memory))
        self.assertEqual(found["C_AU + C_IM"], logic + memory)

    def test_the_thesis_s_own_gates(self) -> None:
        found = indices.indices({**self.gates(32, 512)}, example.mean_frame(32, 512))
        self.assertEqual(found["thesis's C_RTC"], 487020 + 56028 * 32 + 996 * 512)

    def gates(self, packets: int, lines: int) -> Json:
        own = example.configuration(packets, lines)["keys"]
        cores = gates.cores("one", own, True).values()
        counted = [(core, example.gates(core["packets"], core["lines"])) for core in cores]
        return gates.of_core(own, counted[0][1], gates.split(counted))

    def test_gates_of_other_packets_and_lines(self) -> None:
        known = self.gates(64, 512)
        for packets, lines in ((1, 512), (24, 512), (64, 16), (64, 512)):
            cost = indices.costs(known, packets, lines)
            assert cost
            self.assertAlmostEqual(cost[0], 1000 + 10 * packets, 4)
            self.assertAlmostEqual(cost[1], 200 * packets + 30 * lines, 4)

    def test_the_parts_of_the_gates(self) -> None:
        parts = self.gates(64, 512)["split"]
        for part, (logic, memory) in {
            "fixed": (1000, 0),
            "packet": (10, 200),
            "line": (0, 30),
        }.items():
            self.assertAlmostEqual(parts[part]["logic"], logic, 4)
            self.assertAlmostEqual(parts[part]["memory"], memory, 4)

    def test_without_smaller_cores_only_its_own_gates_are_known(self) -> None:
        known = {**self.gates(4, 2), "split": None}
        self.assertEqual(indices.costs(known, 4, 2), (1040, 860))
        self.assertIsNone(indices.costs(known, 2, 2))
        self.assertNotIn("QGHW", rows.figures_of(example.mean_frame(2, 2), known))
        self.assertIsNone(gates.split([({"packets": 4, "lines": 2}, example.gates(4, 2))]))

    def test_several_pipelines(self) -> None:
        """Each has the gates of one, and all of them a quarter of the clocks."""
        one = rows.figures_of(example.mean_frame(4, 2), self.gates(4, 2))
        keys: Json = {"packets": 4, "lines": 2, "pipelines": 4}
        counted = gates.of_core(keys, example.gates_of(keys), None)
        four = rows.figures_of(example.mean_frame(4, 2, keys=keys), counted)
        for figure in ("U_AU", "QHW", "QGHW"):
            self.assertAlmostEqual(four[figure], one[figure])
        for figure in ("C_AU + C_IM", "thesis's C_RTC", "rays per clock"):
            self.assertAlmostEqual(four[figure], 4 * one[figure])

    def test_bytes(self) -> None:
        found = rows.figures_of(example.mean_frame(4, 2), None)
        self.assertAlmostEqual(found["bytes read per ray"], (200 * 8 + 50 * 4 + 100 * 12) / 768)
        self.assertEqual(found["bytes written per ray"], 28)


class Gates(unittest.TestCase):
    def arithmetic(self, configuration: str) -> list[str]:
        """The arithmetic units among the instances of the checked-in Verilog."""
        core = rtl_files.ALL_GENERATED / configuration / f"{rtl_files.CORE}.v"
        count = gate_rule.Count(Counter({"LUT4": 1}), ())
        counts = {part.name: count for part in rtl_files.instances(core)} | {"join": count}
        return sorted(gates.figures(counts)["arithmetic"])

    def test_the_arithmetic_units_are_those_of_table_7_3(self) -> None:
        others = ["collect_hits", "intersection", "transformation"]
        self.assertEqual(self.arithmetic("thesis"), sorted(SLICES[:4] + others))

    def test_units_that_the_fast_core_has_more(self) -> None:
        others = ["collect_hits", "intersection", "transformation"]
        more = ["camera_rays", "plane_offset", "ray_reciprocal", "world_box"]
        self.assertEqual(self.arithmetic("fast"), sorted(SLICES + others + more))

    def test_the_parts_of_pipelines_count_as_those_of_one(self) -> None:
        def count(cells: int, memory: str) -> gate_rule.Count:
            return gate_rule.Count(Counter({"LUT4": cells}), (gate_rule.Memory(memory, 8, 4, 2),))

        units = {"slice_0": count(10, "rows"), "shading": count(1000, "pixels")}
        joins = {"join": count(0, "ray_0_ram"), "frame_writer": count(1000, "fifo")}
        one = gates.figures({**units, "join": count(0, "ray_0_ram")})
        two = gates.figures(
            {f"p{i}_{name}": unit for i in (0, 11) for name, unit in units.items()} | joins
        )
        self.assertEqual(two["logic"], 2 * one["logic"])
        self.assertEqual(two["arithmetic"], {"slice_0": 2 * one["arithmetic"]["slice_0"]})
        self.assertEqual(two["memory"], 4 * 3 * 64)
        self.assertEqual(gate_units.owner("p11_ray_0_ram_0"), "TraversalSlice0")
        self.assertEqual(gate_units.owner("p0_pixel_position_ram"), "(ray generation)")

    def test_a_port_and_its_second_level_count(self) -> None:
        memory = gate_rule.Memory("second_rows_ram", 8, 4, 2)
        counts = {
            "memory_lookup": gate_rule.Count(Counter({"LUT4": 10}), ()),
            "join": gate_rule.Count(Counter(), (memory,)),
        }
        found = gates.figures(counts)
        self.assertEqual(found, {"logic": 90, "memory": 4 * 64, "arithmetic": {}})

    def test_logic_and_memory(self) -> None:
        memory = gate_rule.Memory("rows", 8, 4, 2)
        counts = {
            "slice_0": gate_rule.Count(Counter({"LUT4": 10}), (memory,)),
            "shading": gate_rule.Count(Counter({"LUT4": 1000}), (memory,)),
            "a_new_unit": gate_rule.Count(Counter({"LUT4": 1}), ()),
        }
        self.assertEqual(
            gates.figures(counts),
            {"logic": 9 * 11, "memory": 4 * 64, "arithmetic": {"slice_0": 90}},
        )


if __name__ == "__main__":
    unittest.main()
