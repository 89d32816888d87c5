# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The steps from `full` to `fast`, and the figures of a frame."""

import os
import pathlib
import unittest
from unittest import mock

from dynrt_tools.bench import levers
from dynrt_tools.bench.run import RunFailed
from dynrt_tools.hardware import area
from dynrt_tools.project import ROOT, Failed, Json, read_json

CONFIGURATIONS: list[Json] = [
    {"name": "full", "packets": 64},
    {"name": "fast", "like": "full", "about": "a", "rtl": False, "lines": 8, "lights": 2},
    {"name": "fast_watertight", "like": "fast", "triangle_test": "watertight"},
]
MEASURED = {
    "clocks": 4000,
    "counters": {"list.transactions": 10, "slice_0.transactions": 3000, "step.tokens": 9000},
    "measures": {"primary": {"wrong_share": 0.01}},
}


class Levers(unittest.TestCase):
    def test_each_step_has_one_key_more(self) -> None:
        steps = levers.levers(CONFIGURATIONS)
        self.assertEqual(
            [step.name for step in steps], ["full", "lines", "lights", "triangle_test"]
        )
        self.assertEqual(steps[2].keys, {"lines": 8, "lights": 2})
        self.assertEqual(steps[3].keys, {"lines": 8, "lights": 2, "triangle_test": "watertight"})

    def test_fast_comes_from_full(self) -> None:
        with self.assertRaisesRegex(RunFailed, "fast is like thesis, not like full"):
            levers.levers([{"name": "fast", "like": "thesis"}])

    def test_one_of_the_steps_is_fast(self) -> None:
        shipped = read_json(ROOT / "hls" / "configs" / "configs.json")
        fast = next(one for one in shipped if one["name"] == "fast")
        own = {key: value for key, value in fast.items() if key not in levers.NO_LEVER}
        self.assertTrue(own)
        self.assertIn(own, [step.keys for step in levers.levers(shipped)])

    def test_figures_are_of_the_unit_with_most_transactions(self) -> None:
        frame = levers.frame_of("40x30", MEASURED)
        self.assertEqual(frame["busiest unit"], "slice_0")
        self.assertEqual(frame["use"], 0.75)
        self.assertEqual(frame["rays per clock"], 0.3)
        self.assertEqual(frame["wrong hits"], 0.01)

    def test_the_table_has_a_line_for_each_step(self) -> None:
        frame = levers.frame_of("40x30", MEASURED)
        rows: list[Json] = [
            {
                "lever": name,
                "value": value,
                "room": {"LUT4": 12345, "FF": 2, "block RAM": 95, "multiplier": 4},
                **{scene: frame for scene in levers.SCENES},
            }
            for name, value in (("full", None), ("lines", 8))
        ]
        lines = levers.table(rows).splitlines()
        self.assertEqual(len(lines), 3)
        self.assertIn("office", lines[0])
        self.assertIn("lines 8", lines[2])
        self.assertIn("0.3000", lines[2])
        self.assertIn("block RAMs", lines[0])
        self.assertRegex(lines[2], r" 12,345 +2 +95 +4$")

    def test_the_room_is_that_of_its_units(self) -> None:
        taken = {"LUT4": 7, "FF": 5, "block RAM": 3, "multiplier": 2, "pin": 1}
        with mock.patch.object(area, "hardware", return_value={"takes": taken}) as hardware:
            room = levers.room_of(pathlib.Path("core"))
        hardware.assert_called_once_with(pathlib.Path("core"), jobs=os.cpu_count())
        self.assertEqual(room, {"LUT4": 7, "FF": 5, "block RAM": 3, "multiplier": 2})
        with mock.patch.object(area, "hardware", side_effect=Failed("list: no room")):
            with self.assertRaisesRegex(RunFailed, "^list: no room$"):
                levers.room_of(pathlib.Path("core"))


if __name__ == "__main__":
    unittest.main()
