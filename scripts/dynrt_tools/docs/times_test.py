# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The tables of times that runs print, as the data of a page."""

import json
import pathlib
import shutil
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.docs import times

DEMO = """\
== seconds
packages           6.0 s
in all             6.0 s
compared    5 pixels
== seconds
packages          60.0 s
build            120.5 s
  compile        200.0 s in 140 steps, the longest 24.3 s
  other            0.3 s in 28 steps, the longest 0.1 s
render             5.5 s
in all           186.0 s
== scripts/test builds and tests what this left out
"""
FAST = "== seconds\nbuild  60.0 s\ntest  30.0 s\nin all  90.0 s\n"


class Times(unittest.TestCase):
    """Logs and the data that they become."""

    def setUp(self) -> None:
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.data = self.folder / "build.json"
        empty = {"runs": dict.fromkeys(times.RUNS), "minutes": {}}
        self.data.write_text(json.dumps(empty), encoding="utf-8")

    def keep(self, name: str, text: str) -> dict[str, float | None]:
        """Keeps a log; gives the minutes."""
        log = self.folder / "log"
        log.write_text(text, encoding="utf-8")
        times.keep(name, log, self.data)
        kept: dict[str, float | None] = project.read_json(self.data)["minutes"]
        return kept

    def test_the_last_table_counts(self) -> None:
        self.assertEqual(self.keep("demo", DEMO)["first picture"], 3.1)
        demo = project.read_json(self.data)["runs"]["demo"]
        self.assertEqual(
            demo["steps"]["compile"], {"seconds": 200.0, "number": 140, "longest": 24.3}
        )
        self.assertEqual(demo["render"], 5.5)

    def test_a_run_that_is_missing_leaves_its_minutes_out(self) -> None:
        kept = self.keep("demo", DEMO)
        self.assertIsNone(kept["everything built"])
        kept = self.keep("fast", FAST)
        self.assertEqual(kept["everything built"], 4.1)
        self.assertEqual(kept["fast tests"], 4.6)
        self.assertIsNone(kept["all tests"])

    def test_a_log_without_a_table_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "log:1: has no line '== seconds'"):
            self.keep("demo", "nothing\n")

    def test_a_run_that_was_cut_off_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "log:1: the table has no line 'in all'"):
            self.keep("demo", "== seconds\npackages 3.0 s\n")

    def test_an_unknown_run_is_named(self) -> None:
        with self.assertRaisesRegex(
            project.Failed, "--times slow: unknown; the runs are demo, fast"
        ):
            self.keep("slow", DEMO)


if __name__ == "__main__":
    unittest.main()
