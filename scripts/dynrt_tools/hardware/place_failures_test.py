# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place does around a placer that fails, in the ways that one can."""

import argparse
import errno
import gzip
import shutil
import unittest
from typing import Any
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import place_row
from dynrt_tools.hardware.place_stand_in import StandIn


class Fails(StandIn):
    def fails(self, mode: str, sentence: str, **flags: Any) -> None:
        """One seed fails: it is named with tool and unit, and all else is there."""
        code, output, errors, data = self.called(f"{mode}:2", names=("sum", "wide"), **flags)
        self.assertEqual(code, 1)
        for name in ("sum", "wide"):
            self.assertIn(f"place: nextpnr-ecp5 placed no {name} with seed 2: {sentence}", errors)
            self.assertRegex(output, rf"{name} +2 +3.00 +40 +244")
        self.assertTrue(data["complete"])
        for row in data["units"]:
            self.assertEqual([p["seed"] for p in row["placed"]], [1, 3])
            self.assertEqual([f["seed"] for f in row["failures"]], [2])

    def test_a_design_that_is_not_routed(self) -> None:
        self.fails("no route", "Failed to route arc 3 of net 'a', from X1Y2 to X3Y4.")

    def test_a_placer_that_runs_out_of_time(self) -> None:
        self.fails("slow", "nextpnr-ecp5 ran out of time, 5 seconds", timeout=5 / 60)

    def test_a_report_that_reads_otherwise(self) -> None:
        self.fails(
            "other report",
            "the report of this version of nextpnr-ecp5 reads otherwise than that of 0.4 to 0.11: "
            "it has no 'fmax'",
        )

    def test_a_report_that_is_not_there(self) -> None:
        self.fails("silent", "nextpnr-ecp5 wrote no report")

    def test_delays_that_are_not_there(self) -> None:
        code, _, errors, _ = self.called("no delays", seeds=1)
        self.assertEqual(code, 1)
        self.assertRegex(
            errors, "placed no sum with seed 1: .*/timing.sdf: No such file or directory\n"
        )

    def test_a_full_disk_is_said_as_such(self) -> None:
        full = OSError(errno.ENOSPC, "No space left on device")
        with mock.patch.object(gzip, "open", side_effect=full):
            code, _, errors, _ = self.called(seeds=1)
        self.assertEqual(code, 1)
        self.assertRegex(
            errors, "placed no sum with seed 1: the disk that holds the cache .* is full"
        )

    def test_delays_that_read_otherwise(self) -> None:
        self.fails(
            "other delays",
            "the longest path in the SDF file of nextpnr-ecp5 takes 4.10 ns, and its report says "
            "7.50",
        )

    def test_a_failure_is_not_kept(self) -> None:
        self.called("no route", seeds=1)
        self.assertEqual(self.called(seeds=1)[0], 0)

    def test_a_design_that_is_too_large_is_not_placed(self) -> None:
        code, output, errors, data = self.called("full", seeds=1)
        self.assertEqual(code, 1)
        self.assertIn("not placed are 1 of 1 rows: sum (does not fit: Unable to place", errors)
        self.assertIn("does not fit: Unable to place cell 'x'", output)
        self.assertEqual(data["units"][0]["logic_ns"], 2.5)
        record = project.read_json(self.folder / "record.json")
        self.assertEqual((record["units"], record["longest path by Yosys, ns"]), ({}, 2.5))
        self.assertIn("does not fit", record["not placed"]["sum"]["reason"])

    def test_a_seed_that_does_not_fit_is_an_error_and_limits_nothing(self) -> None:
        code, output, errors, data = self.called("full:2")
        self.assertEqual(code, 1)
        self.assertIn("placed no sum with seed 2: does not fit: Unable to place cell", errors)
        self.assertIn("place: not every seed was placed\n", errors)
        self.assertEqual(len(data["units"][0]["placed"]), 2)
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertEqual(project.read_json(self.folder / "record.json")["ends"], [])

    @unittest.skipIf(shutil.which("nextpnr-ecp5", path="/usr/bin:/bin"), "nextpnr-ecp5 is there")
    def test_without_a_placer_the_rows_have_the_timing_of_yosys(self) -> None:
        code, output, errors, _ = self.called(without=True)
        self.assertEqual(code, 1)
        self.assertIn("place: nextpnr-ecp5 is not on the PATH", errors)
        self.assertIn("cells alone 2.50 ns on 7-series", output)

    def test_a_row_that_cannot_be_prepared_leaves_the_others(self) -> None:
        prepare = self.prepare

        def broken(name: str, args: argparse.Namespace, build: object) -> place_row.Row:
            if name == "wide":
                raise project.Failed("wide: Yosys failed")
            return prepare(name, args, build)

        with mock.patch.object(self, "prepare", broken):
            code, output, errors, data = self.called(names=("wide", "sum"), seeds=1)
        self.assertEqual(code, 1)
        self.assertEqual(
            errors,
            "place: wide: Yosys failed\n"
            "place: not placed are 1 of 2 rows: wide (failed: wide: Yosys failed)\n",
        )
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertEqual(data["units"][0]["note"], "failed: wide: Yosys failed")

    def test_a_row_without_yosys_s_timing_leaves_the_others(self) -> None:
        refused = mock.Mock(side_effect=project.Failed("wide: Yosys failed"))
        code, output, errors, data = self.called(
            "full", names=("wide", "sum"), timing=refused, seeds=1
        )
        self.assertEqual(code, 1)
        self.assertIn("place: no timing of wide by Yosys: wide: Yosys failed", errors)
        self.assertRegex(output, "\nwide .*\nsum ")
        self.assertTrue(data["complete"])


if __name__ == "__main__":
    unittest.main()
