# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How placed clocks are read, chosen and written as C++."""

import json
import pathlib
import tempfile
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import (
    kept_placement,
    placed_clocks,
    placed_clocks_header,
    rtl_files,
)
from dynrt_tools.project import Json


class Reading(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.runs: Json = {}

    def write(self, name: str, mhz: float, config: str, grade: str = "6", **more: object) -> None:
        """Keeps a placement and its command."""
        data: Json = {"device": "ecp5-85", "grade": grade, "config": config, "seeds": 3}
        data["mhz"] = [mhz + 2, mhz - 1.04, mhz]
        data |= {"placer": "0.7", "verilog": "0123"}
        data["units"] = {rtl_files.CORE: {}}
        (self.folder / f"{name}.json").write_text(json.dumps(data | more), encoding="utf-8")
        self.runs[name] = {"command": f"place {name}", "measured": "today"}
        (self.folder / "runs.json").write_text(json.dumps(self.runs), encoding="utf-8")

    def refused(self, sentence: str) -> None:
        with self.assertRaisesRegex(project.Failed, sentence):
            placed_clocks.load(self.folder)

    def test_the_default_comes_first(self) -> None:
        self.write("place_core_8", 130, "thesis", grade="8")
        self.write("place_core_boxed", 90, "boxed")
        self.write("place_core", 100, "thesis")
        self.write("place_8ns", 200, "thesis")  # of units
        self.write("place_core_twice", 80, "thesis", copies=2)
        clocks = placed_clocks.load(self.folder)
        self.assertEqual(
            [(c.grade, c.configuration, c.mhz) for c in clocks],
            [("6", "thesis", 100), ("6", "boxed", 90), ("8", "thesis", 130)],
        )
        first = clocks[0]
        self.assertEqual((first.lowest_mhz, first.highest_mhz, first.seeds), (99, 102, 3))
        self.assertEqual(first.command, "place place_core")
        self.assertTrue(first.earlier, "of another Verilog than the one that is checked in")
        self.assertEqual(first.where, "Lattice LFE5U-85F, grade 6")
        self.assertEqual(placed_clocks.of("boxed", clocks).mhz, 90)
        self.assertEqual(placed_clocks.of("thesis", clocks), first)
        self.assertEqual(placed_clocks.of("full", clocks).configuration, "boxed")  # the slowest

    def test_a_configuration_without_a_placement_is_named(self) -> None:
        self.write("place_core", 100, "thesis")
        clock = placed_clocks.load(self.folder)[0]
        placed = "at 100 MHz, placed: thesis on Lattice LFE5U-85F, grade 6"
        self.assertEqual(clock.of_core("thesis"), placed)
        self.assertEqual(clock.of_core("full"), f"{placed}; full was not placed and may miss it")

    def test_data_that_are_not_whole_are_refused(self) -> None:
        self.refused(r"has no place_core\*\.json; scripts/place --keep writes one")
        self.write("place_core", 100, "thesis", units={})
        self.refused("place_core.json: has no placement of dynrt_core; 'place place_core' makes it")
        self.write("place_core", 100, "thesis")
        data = project.read_json(self.folder / "place_core.json")
        del data["mhz"]
        project.write_json(self.folder / "place_core.json", data)
        self.refused("place_core.json: has no 'mhz'; 'place place_core' writes it")
        self.write("place_core", 100, "thesis")
        self.write("place_core_2", 101, "thesis")
        self.refused("two files of .* have a placement of thesis on ecp5-85, grade '6'; keep one")
        (self.folder / "runs.json").write_text("{}", encoding="utf-8")
        self.refused("runs.json names no command that measured it; add one")

    def test_the_header_has_every_field(self) -> None:
        self.write("place_core", 100.5, "thesis")
        text = placed_clocks_header.header(placed_clocks.load(self.folder))
        self.assertIn(
            '    {.device = "ecp5-85", .grade = "6", .configuration = "thesis", .mhz = 100.5, '
            ".lowest_mhz = 99.5, .highest_mhz = 102.5, .seeds = 3, "
            '.placer = "nextpnr-ecp5 0.7", .verilog = "0123", .earlier = true, '
            '.command = "place place_core", '
            '.where = "Lattice LFE5U-85F, grade 6"},\n};\n',
            text,
        )


class Kept(unittest.TestCase):
    """The data of the project."""

    def test_the_default_is_the_slowest_grade(self) -> None:
        first = placed_clocks.load()[0]
        self.assertEqual((first.device, first.grade), ("ecp5-85", "6"))
        self.assertEqual(first.configuration, "thesis")
        self.assertRegex(first.placer, r"^nextpnr-ecp5 \d")
        self.assertRegex(first.verilog, r"^[0-9a-f]{64}$")
        self.assertLessEqual(first.lowest_mhz, first.mhz)
        self.assertLessEqual(first.mhz, first.highest_mhz)

    def test_rates_are_what_a_clock_decides(self) -> None:
        rates: Json = {"clock": {"mhz": 1}, "clock_hz": 1, "frames_per_second": 2}
        rates |= {"frames per second, placed": 3, "frames per second at 85 MHz": 4}
        counted: Json = {"clocks per frame": 5, "clock_ns": 6, "rays_per_clock": 7}
        self.assertEqual(
            placed_clocks.without_rates({"a": [{**rates, **counted}]}), {"a": [counted]}
        )


class KeptByPlace(unittest.TestCase):
    """What scripts/place --keep writes of the core."""

    def test_it_can_be_read(self) -> None:
        about = {"unit": rtl_files.CORE, "config": "full", "device": "ecp5-85", "grade": "8"}
        kept: Json = {
            **about,
            **{"placer": "0.11", "seeds": 3, "copies": 1, "verilog": "4f" * 32},
            "mhz": [108.04, 100, 101.26],
            "units": {rtl_files.CORE: {}},
            "ends": [],
        }
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            kept_placement.write(folder / "place_core_full.json", kept)
            project.write_json(folder / "runs.json", {"place_core_full": {"command": "place"}})
            (clock,) = placed_clocks.load(folder)
        self.assertEqual((clock.configuration, clock.grade, clock.seeds), ("full", "8", 3))
        self.assertEqual((clock.lowest_mhz, clock.mhz, clock.highest_mhz), (100, 101.3, 108))
        self.assertEqual((clock.placer, clock.verilog), ("nextpnr-ecp5 0.11", "4f" * 32))


if __name__ == "__main__":
    unittest.main()
