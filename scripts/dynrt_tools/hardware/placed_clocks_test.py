# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How placed clocks are read, chosen and written."""

import dataclasses
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import place_record, placed_clocks
from dynrt_tools.project import Json


class Clocks(testing.InFolder):
    """Those of the project, and a copy with others."""

    def setUp(self) -> None:
        super().setUp()
        self.path = self.folder / "clocks.json"
        self.path.write_text(placed_clocks.FILE.read_text(encoding="utf-8"), encoding="utf-8")
        self.first = placed_clocks.load()[0]

    def test_the_default_is_the_slowest_grade(self) -> None:
        self.assertEqual(self.first.key, ("ecp5-85", "6", "thesis"))
        for clock in placed_clocks.load():
            self.assertRegex(clock.placer, r"^nextpnr-ecp5 \S")
            self.assertRegex(clock.verilog, r"^[0-9a-f]{64}$")
            self.assertTrue(clock.lowest_mhz <= clock.mhz <= clock.highest_mhz)
            self.assertRegex(clock.day, r"^\d+ [A-Z][a-z]+ 20\d\d$")

    def test_each_is_of_the_placement_that_is_recorded(self) -> None:
        records = [project.read_json(p) for p in place_record.DATA.glob("place_core*.json")]
        recorded = {place_record.clock_of(record).key: record for record in records}
        for clock in placed_clocks.load():
            self.assertEqual(clock, place_record.clock_of(recorded[clock.key]))

    def test_another_placement_takes_the_place_of_the_one_before(self) -> None:
        again = dataclasses.replace(self.first, mhz=99.5)
        other = dataclasses.replace(self.first, mhz=200.5, configuration="other")
        for clock in (again, other):
            placed_clocks.write(clock, self.path)
        clocks = placed_clocks.load(self.path)
        self.assertEqual(clocks, [again, *placed_clocks.load()[1:], other])
        self.assertEqual(placed_clocks.of("other", clocks), other)
        self.assertEqual(placed_clocks.of("deep", clocks), again)  # the slowest

    def test_a_file_that_is_not_whole_is_refused(self) -> None:
        text = self.path.read_text(encoding="utf-8")
        for wrong, said in (
            ("[", "clocks.json: cannot be read"),
            (text.replace('"mhz"', '"ghz"'), "unexpected keyword argument 'ghz'"),
            (text.replace('"fast"', '"thesis"'), "two clocks of ecp5-85, 6, thesis; keep one"),
        ):
            self.path.write_text(wrong, encoding="utf-8")
            with self.assertRaisesRegex(project.Failed, said):
                placed_clocks.load(self.path)

    def test_a_configuration_without_a_placement_is_named(self) -> None:
        clock = dataclasses.replace(self.first, mhz=100)
        placed = "at 100 MHz, placed: thesis on Lattice LFE5U-85F, grade 6"
        self.assertEqual(clock.of_core("thesis"), placed)
        self.assertEqual(clock.of_core("full"), f"{placed}; full was not placed and may miss it")

    def test_rates_are_what_a_clock_decides(self) -> None:
        rates: Json = {"clock": {"mhz": 1}, "clock_hz": 1, "frames_per_second": 2}
        rates |= {"frames per second, placed": 3, "frames per second at 85 MHz": 4}
        counted: Json = {"clocks per frame": 5, "clock_ns": 6, "rays_per_clock": 7}
        self.assertEqual(
            placed_clocks.without_rates({"a": [{**rates, **counted}]}), {"a": [counted]}
        )


if __name__ == "__main__":
    unittest.main()
