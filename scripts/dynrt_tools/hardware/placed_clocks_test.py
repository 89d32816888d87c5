# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How placed clocks are read, chosen and written as C++."""

import json
import pathlib
import tempfile
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import (
    place,
    place_record,
    placed_clocks,
    placed_clocks_header,
    placing,
    rtl_files,
    synthesis,
)
from dynrt_tools.project import Json


class Reading(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.runs: Json = {}

    def write(self, name: str, mhz: float, config: str, grade: str = "6", **more: object) -> None:
        """Keeps a placement and its command."""
        core = {"MHz, median": mhz, "range low": mhz - 1, "range high": mhz + 2}
        core |= {"placer": "nextpnr-ecp5 0.7", "verilog": "0123"}  # type: ignore[dict-item]
        data: Json = {"device": "ecp5-85", "grade": grade, "config": config, "seeds": 3}
        data["units"] = {rtl_files.CORE: core}
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
        self.assertEqual(first.where, "Lattice LFE5U-85F, grade 6")
        self.assertEqual(placed_clocks.of("boxed", clocks).mhz, 90)
        self.assertEqual(placed_clocks.of("full", clocks), first)

    def test_a_configuration_without_a_placement_is_named(self) -> None:
        self.write("place_core", 100, "thesis")
        clock = placed_clocks.load(self.folder)[0]
        placed = "at 100 MHz, placed: thesis on Lattice LFE5U-85F, grade 6"
        self.assertEqual(clock.of_core("thesis"), placed)
        self.assertEqual(clock.of_core("full"), f"{placed}; full was not placed and may miss it")

    def test_data_that_are_not_whole_are_refused(self) -> None:
        self.refused(r"has no place_core\*\.json; scripts/place --record writes one")
        self.write("place_core", 100, "thesis", units={})
        self.refused("place_core.json: has no placement of dynrt_core; 'place place_core' makes it")
        self.write("place_core", 100, "thesis", units={"dynrt_core": {"MHz, median": 3}})
        self.refused("place_core.json: has no 'range low'; 'place place_core' writes it")
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
            '.placer = "nextpnr-ecp5 0.7", .verilog = "0123", .command = "place place_core", '
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
        self.assertRegex(first.verilog, r"^[0-9a-f]{16}$")
        self.assertLessEqual(first.lowest_mhz, first.mhz)
        self.assertLessEqual(first.mhz, first.highest_mhz)

    def test_rates_are_what_a_clock_decides(self) -> None:
        rates: Json = {"clock": {"mhz": 1}, "clock_hz": 1, "frames_per_second": 2}
        rates |= {"frames per second, placed": 3, "frames per second at 85 MHz": 4}
        counted: Json = {"clocks per frame": 5, "clock_ns": 6, "rays_per_clock": 7}
        self.assertEqual(
            placed_clocks.without_rates({"a": [{**rates, **counted}]}), {"a": [counted]}
        )


class Recorded(unittest.TestCase):
    """What scripts/place --record writes of the core."""

    def test_it_can_be_read(self) -> None:
        subject = placing.Subject(rtl_files.CORE, rtl_files.core_files())
        row = place.Row(rtl_files.CORE, {"unit": rtl_files.CORE}, subject)
        seeds = {1: 101.4, 2: 108.2, 3: 99.8}
        row.placed = [
            {"seed": seed, "mhz": mhz, "cells": 9, "too_slow": 1, "placer": "nextpnr-0.11"}
            for seed, mhz in seeds.items()
        ]
        row.finish()
        run = {"config": "full", "device": "ecp5-85", "grade": "8", "clock_ns": 8.33, "copies": 1}
        record = place_record.summary(run | {"complete": True, "units": [row.data]}, len(seeds))
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            project.write_json(folder / "place_core_full.json", record)
            project.write_json(folder / "runs.json", {"place_core_full": {"command": "place"}})
            (clock,) = placed_clocks.load(folder)
        self.assertEqual((clock.configuration, clock.grade, clock.seeds), ("full", "8", 3))
        self.assertEqual((clock.lowest_mhz, clock.mhz, clock.highest_mhz), (100, 101, 108))
        self.assertEqual(clock.placer, "nextpnr-ecp5 0.11")
        digest = synthesis.verilog_digest(rtl_files.CORE, rtl_files.core_files())
        self.assertEqual(clock.verilog, digest)


class Digest(testing.InFolder):
    def test_comments_do_not_change_it(self) -> None:
        file = self.folder / "m.v"
        digests = []
        for text in ("module m;\nendmodule\n", "module m;  // why\nendmodule\n", "module m(a);\n"):
            file.write_text(text, encoding="utf-8")
            synthesis._text.cache_clear()  # pylint: disable=protected-access
            synthesis._meaning.cache_clear()  # pylint: disable=protected-access
            digests.append(synthesis.verilog_digest("m", [file]))
        self.assertEqual(digests[0], digests[1])
        self.assertNotEqual(digests[0], digests[2])


if __name__ == "__main__":
    unittest.main()
