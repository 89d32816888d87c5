# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A report of two variants of a small scene, from the program to the page, and a choice of them.

Usage: python3 -m dynrt_tools.report.system_test PROGRAM
"""

import csv
import json
import pathlib
import sys
import unittest

from dynrt_tools import testing

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


class Report(testing.InFolder):
    def run_program(self, *arguments: str) -> testing.Result:
        variant = ("--size", "64x48", "--variant", "m10")
        return testing.run(PROGRAM, *arguments, *variant, cwd=self.folder)

    def run_report(self) -> dict[str, dict[str, str]]:
        """The rows of the report, by their variants."""
        result = self.run_program("report", "error", "blocks", "--out", "report")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with (self.folder / "report" / "error.csv").open(encoding="utf-8") as file:
            return {row["variant"]: row for row in csv.DictReader(file)}

    def choose(self, bound: str) -> testing.Result:
        asked = ("--measure", "primary.t_median", "--max-error", bound)
        return self.run_program("choose", "blocks", "--out", "report", *asked)

    def test_from_the_program_to_the_page(self) -> None:
        rows = self.run_report()
        self.assertEqual(list(rows), ["m10", "m16"])

        def of(key: str) -> list[float]:
            return [float(rows[name][key]) for name in ("m10", "m16")]

        for more, less in (("primary.t_median", 20), ("primary.t_p99", 20)):
            self.assertGreater(of(more)[0], less * of(more)[1])
        self.assertLess(of("LUT")[0], of("LUT")[1])
        for clocks in of("clocks"):
            self.assertGreater(clocks, 10000)
        for clocks, period, time in zip(of("clocks"), of("clock_ns"), of("frame_ms")):
            self.assertAlmostEqual(time, clocks * period / 1e6)

        report = json.loads((self.folder / "report" / "error.json").read_text(encoding="utf-8"))
        narrow, wide = (report["variants"][name]["schedule"] for name in ("m10", "m16"))
        self.assertLessEqual(narrow["clock_ns"], wide["clock_ns"])
        self.assertLess(narrow["stages"], wide["stages"])
        for run in report["runs"]:
            for picture in (run["image"], run["difference"]):
                self.assertTrue((self.folder / "report" / picture).is_file())
        page = (self.folder / "report" / "error.html").read_text(encoding="utf-8")
        self.assertIn("m10", page)

        # Nothing is measured again.
        figures = self.folder / "report.work" / "scenes" / "blocks" / "m10" / "run.json"
        before = figures.stat().st_mtime_ns
        self.assertEqual(self.run_report(), rows)
        self.assertEqual(figures.stat().st_mtime_ns, before)

        loose, tight, none = self.choose("0.01"), self.choose("0.0001"), self.choose("1e-12")
        self.assertIn("\nm10 is the cheapest with primary.t_median ", loose.stdout)
        self.assertIn("\nm16 is the cheapest with primary.t_median ", tight.stdout)
        self.assertEqual((loose.returncode, tight.returncode, none.returncode), (0, 0, 2))
        self.assertRegex(
            none.stderr,
            "^dynrt: no variant reaches primary.t_median 1e-12 on this "
            "scene; the best is m16 with [0-9.e-]+\n$",
        )


if __name__ == "__main__":
    unittest.main()
