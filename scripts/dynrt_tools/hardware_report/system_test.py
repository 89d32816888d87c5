# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A report of a small scene, from the program to the page.

Usage: python3 -m dynrt_tools.hardware_report.system_test PROGRAM
"""

import pathlib
import sys
import unittest

from dynrt_tools import testing
from dynrt_tools.hardware_report import figures
from dynrt_tools.project import Json, read_json

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


class Report(testing.InFolder):
    def run_report(self) -> Json:
        """The report's data."""
        flags = ("--size", "64x48", "--config", "thesis", "--table", "thesis")
        some = ("--figure", "7.5", "--figure", "7.9")  # without a core for each value of a key
        command = (PROGRAM, "report", "hardware", "blocks", "--out", "report", *flags, *some)
        result = testing.run(*command, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return dict(read_json(self.folder / "report" / "hardware.json"))

    def test_from_the_program_to_the_page(self) -> None:
        report = self.run_report()
        curves = {f.name: list(figures.curves(report, f, "blocks")) for f in figures.FIGURES}

        (rate,) = curves["7.9"]
        self.assertEqual([x for x, _ in rate.points], [1, 2, 4, 8, 16, 24, 32])
        for (_, fewer), (_, more) in zip(rate.points, rate.points[1:]):
            self.assertLess(fewer, more)
        for curve in curves["7.5 and 7.10"]:
            self.assertEqual([x for x, _ in curve.points], list(figures.LINES))
            self.assertLess(curve.points[0][1], curve.points[-1][1])
        (own,) = report["table"]
        self.assertGreater(own["C_AU + C_IM"], 1_000_000)
        self.assertGreater(own["QHW"], 1)
        self.assertLess(own["QHW"], own["U_AU"])
        gates = report["configurations"]["thesis"]["gates"]
        self.assertGreater(
            gates["split"]["packet"]["memory"], 50_000
        )  # a packet, of the thesis's 56,028
        self.assertGreater(gates["split"]["line"]["memory"], 900)  # a line, of the thesis's 996
        self.assertTrue((self.folder / "report" / "hardware.html").is_file())

        # Nothing is rendered again.
        frames = sorted(self.folder.glob("report.work/frames/64x48/3/blocks/thesis/*.json"))
        self.assertEqual(len(frames), 26)
        before = [path.stat().st_mtime_ns for path in frames]
        self.assertEqual(self.run_report(), report)
        self.assertEqual([path.stat().st_mtime_ns for path in frames], before)


if __name__ == "__main__":
    unittest.main()
