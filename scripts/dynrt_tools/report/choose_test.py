# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Chooses among the variants of a report whose figures are known."""

import argparse
import math
import pathlib
import re
import unittest

from dynrt_tools import project
from dynrt_tools.project import Failed
from dynrt_tools.report import choose

EXAMPLE = project.read_json(pathlib.Path(__file__).resolve().parent / "example.json")


class Choose(unittest.TestCase):
    def chosen(self, measure: str, bound: float) -> tuple[list[str], list[str]]:
        runs, holding = choose.choose(EXAMPLE, measure, bound)
        return [r["variant"] for r in runs], [r["variant"] for r in holding]

    def test_cheapest_first(self) -> None:
        self.assertEqual(self.chosen("primary.t_p99", 1e-3), (["m10", "m16"], ["m10", "m16"]))
        self.assertEqual(self.chosen("primary.t_p99", 1e-4)[1], ["m16"])
        self.assertEqual(self.chosen("primary.t_p99", 1e-9)[1], [])

    def test_cost_is_the_largest_part_of_the_device_times_the_time(self) -> None:
        part, resource = choose.part_of_device(EXAMPLE["variants"]["m16"])
        self.assertEqual((round(part, 4), resource), (round(24560 / 83640, 4), "LUT4"))
        self.assertEqual(
            choose.cost(EXAMPLE["variants"]["m16"], EXAMPLE["runs"][1]), (part * 0.40188, 19980)
        )

    def test_the_table_says_the_period_of_each_variant(self) -> None:
        runs, _ = choose.choose(EXAMPLE, "primary.t_p99", 1e-3)
        heads, *rows = (
            re.split("  +", line)
            for line in choose.table(EXAMPLE, runs, "primary.t_p99", 1e-3).splitlines()
        )
        at = heads.index("clock, ns")
        self.assertEqual([(row[0], row[at]) for row in rows], [("m10", "8.5"), ("m16", "10")])

    def test_of_a_psnr_more_is_better_and_none_means_no_difference(self) -> None:
        self.assertEqual(self.chosen("image.psnr", 60)[1], ["m16"])
        self.assertTrue(choose.holds("image.psnr", None, 60))
        self.assertFalse(choose.holds("primary.t_p99", None, 60))

    def test_unknown_measure(self) -> None:
        with self.assertRaisesRegex(
            Failed,
            "^--measure x: this scene has none; its measures are "
            "primary.missed, primary.false, .*, image.largest$",
        ):
            self.chosen("x", 1)

    def test_what_is_wrong_is_said_before_anything_is_measured(self) -> None:
        for flags, sentence in (
            (("x", 1.0), "^--measure x: unknown; the measures are primary.missed, "),
            (("image.rms", math.nan), "^--max-error nan: must be a number$"),
        ):
            args = argparse.Namespace(measure=flags[0], max_error=flags[1])
            with self.assertRaisesRegex(Failed, sentence):
                choose.check_bound(args)


if __name__ == "__main__":
    unittest.main()
