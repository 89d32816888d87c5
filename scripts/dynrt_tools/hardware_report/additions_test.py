# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The cores that the additions are judged by, and what a row says of two of them."""

import unittest

from dynrt_tools.build import configs
from dynrt_tools.hardware_report import additions, figures, points
from dynrt_tools.hardware_report.additions import ADDITIONS, Addition
from dynrt_tools.hardware_report.figure import Point
from dynrt_tools.project import Json


class Additions(unittest.TestCase):
    def test_each_core_is_one_that_there_can_be(self) -> None:
        known = configs.load_configurations()
        listed = known.listed()
        for one in ADDITIONS:
            for point in one.points(listed[one.configuration]):
                if point == points.made_point(listed[one.configuration]):
                    continue
                core = points.core_at(listed[one.configuration], point)
                known.checked("one", core)
            self.assertTrue(one.made or one.without != one.having, one.name)

    def run_at(self, point: Point, rate: float, gates: int, index: float) -> Json:
        figures_ = {figures.RATE: rate, "C_AU + C_IM": gates, "QHW": index, "QGHW": index / 100}
        return {"scene": "lamps", "configuration": "wide", "flags": dict(point), **figures_}

    def test_by_hand(self) -> None:
        configuration: Json = {"packets": 4, "lines": 2, "curves": True}
        ways = Addition("two ways", "wide", {"ways": 1})
        without, having = ways.points(configuration)
        self.assertEqual(points.keys_of(without), {"ways": 1})
        self.assertEqual(points.keys_of(having), {})
        runs = [self.run_at(without, 20, 1000, 4), self.run_at(having, 30, 1100, 5)]
        row = additions.row_of(runs, "lamps", ways, configuration)
        self.assertAlmostEqual(row["frame rate gained"], 50)
        self.assertAlmostEqual(row["gates added"], 10)
        self.assertEqual((row["QHW without"], row["QHW with"]), (4, 5))
        self.assertEqual((row["QGHW without"], row["QGHW with"]), (0.04, 0.05))
        self.assertEqual(set(row), set(additions.COLUMNS))

    def test_what_no_walk_says_is_unknown(self) -> None:
        configuration: Json = {"packets": 4, "lines": 2, "curves": True}
        ways = Addition("two ways", "wide", {"ways": 1})
        alone = [self.run_at(ways.points(configuration)[1], 30, 1100, 5)]
        row = additions.row_of(alone, "lamps", ways, configuration)
        self.assertIsNone(row["frame rate gained"])
        self.assertIsNone(row["QHW without"])
        self.assertEqual(row["QHW with"], 5)


if __name__ == "__main__":
    unittest.main()
