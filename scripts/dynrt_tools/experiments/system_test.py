# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Experiments of a small scene, from the program to the page.

Usage: python3 -m dynrt_tools.experiments.system_test PROGRAM CLASS
"""

import csv
import pathlib
import sys
import unittest
from collections.abc import Mapping

from dynrt_tools import testing
from dynrt_tools.experiments import figures
from dynrt_tools.experiments.slurm_cluster import Cluster
from dynrt_tools.project import Json, read_json

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


class Case(testing.InFolder):
    COMMON = ("blocks", "--out", "report")

    def run_report(self, name: str, *flags: str, env: Mapping[str, str] | None = None) -> Json:
        """The report's data."""
        result = testing.run(
            PROGRAM, "report", name, *self.COMMON, *flags, cwd=self.folder, env=env
        )
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for suffix in ("html", "csv"):
            self.assertTrue((self.folder / "report" / f"{name}.{suffix}").is_file())
        return dict(read_json(self.folder / "report" / f"{name}.json"))

    def kept(self, kind: str) -> dict[pathlib.Path, int]:
        """The kept results of a kind, and when they were made."""
        folder = self.folder / "report.work" / "kept" / kind
        return {path: path.stat().st_mtime_ns for path in folder.glob("*/result.json")}


class Rows(Case):
    def test_rows(self) -> None:
        """The clocks of the native model by the schedules are those of the Verilog."""
        flags = ("--size", "32x24", "--variant", "fast", "--json", "kept.json")
        report = self.run_report("scenes", *flags)
        (row,) = report["rows"]
        verilog = ("render", "blocks", "--board", "rtl", "--config", "fast", "--size", "32x24")
        result = testing.run(PROGRAM, *verilog, "--json", "frame.json", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        frame = read_json(self.folder / "frame.json")["frame"]
        self.assertEqual(row["clocks"], frame["cycles"])
        self.assertEqual(row["bytes read per ray"], frame["memory"]["bytes_read"] / 768)
        kept = read_json(self.folder / "kept.json")["rows"][0]
        self.assertEqual(kept["clocks"], row["clocks"])
        # Rates follow from clocks, so the documents do not keep them.
        rates = {key for key in row if key.startswith("frames per second")}
        self.assertEqual(row.keys() - kept.keys(), rates)
        # Nothing is rendered again, but another size is.
        before = self.kept("frame")
        self.assertEqual(len(before), 1)
        self.assertEqual(self.run_report("scenes", *flags), report)
        self.assertEqual(self.kept("frame"), before)
        self.run_report("scenes", *flags, "--size", "16x12")
        self.assertEqual(len(self.kept("frame")), 2)


class Error(Case):
    def choose(self, bound: str) -> testing.Result:
        asked = ("--measure", "primary.t_median", "--max-error", bound)
        flags = ("--size", "64x48", "--variant", "m10", "--out", "report")
        return testing.run(PROGRAM, "choose", "blocks", *asked, *flags, cwd=self.folder)

    def test_error(self) -> None:
        report = self.run_report("error", "--size", "64x48", "--variant", "m10")
        with (self.folder / "report" / "error.csv").open(encoding="utf-8") as file:
            rows = {row["variant"]: row for row in csv.DictReader(file)}
        self.assertEqual(list(rows), ["m10", "m16"])

        def of(key: str) -> list[float]:
            return [float(rows[name][key]) for name in ("m10", "m16")]

        for measure in ("primary.t_median", "primary.t_p99"):
            self.assertGreater(of(measure)[0], 20 * of(measure)[1])
        self.assertLess(of("LUT")[0], of("LUT")[1])
        for clocks, period, time in zip(of("clocks"), of("clock_ns"), of("frame_ms")):
            self.assertGreater(clocks, 10000)
            self.assertAlmostEqual(time, clocks * period / 1e6)
        narrow, wide = (report["variants"][name]["schedule"] for name in ("m10", "m16"))
        self.assertLess(narrow["stages"], wide["stages"])
        for run in report["runs"]:
            for picture in (run["image"], run["difference"]):
                self.assertTrue((self.folder / "report" / picture).is_file())

        before = self.kept("frame")
        loose, tight, none = self.choose("0.01"), self.choose("0.0001"), self.choose("1e-12")
        self.assertEqual(self.kept("frame"), before)
        self.assertIn("\nm10 is the cheapest with primary.t_median ", loose.stdout)
        self.assertIn("\nm16 is the cheapest with primary.t_median ", tight.stdout)
        self.assertEqual((loose.returncode, tight.returncode, none.returncode), (0, 0, 2))
        self.assertRegex(
            none.stderr,
            "^dynrt: no variant reaches primary.t_median 1e-12 on this "
            "scene; the best is m16 with [0-9.e-]+\n$",
        )


class Hardware(Case):
    FLAGS = ("--size", "64x48", "--config", "thesis", "--table", "thesis", "--figure", "7.9")

    def test_hardware(self) -> None:
        report = self.run_report("hardware", *self.FLAGS, "--figure", "7.5")
        rate = figures.curves(
            report, next(f for f in figures.FIGURES if f["name"] == "7.9"), "blocks"
        )
        (curve,) = rate
        self.assertEqual([x for x, _ in curve.points], [1, 2, 4, 8, 16, 24, 32])
        for (_, fewer), (_, more) in zip(curve.points, curve.points[1:]):
            self.assertLess(fewer, more)
        for hits in figures.curves(report, figures.FIGURES[0], "blocks"):
            self.assertEqual(len(hits.points), 10)
            self.assertLess(hits.points[0][1], hits.points[-1][1])
        (own,) = report["table"]
        self.assertGreater(own["C_AU + C_IM"], 1_000_000)
        self.assertGreater(own["QHW"], 1)
        self.assertLess(own["QHW"], own["U_AU"])
        parts = report["configurations"]["thesis"]["gates"]["split"]
        self.assertGreater(parts["packet"]["memory"], 50_000)  # a packet, of the thesis's 56,028
        self.assertGreater(parts["line"]["memory"], 900)  # a line, of the thesis's 996
        self.assertEqual(len(self.kept("frame")), 26)


class Slurm(Case):
    def test_slurm(self) -> None:
        cluster = Cluster(self.folder / "cluster")
        self.addCleanup(cluster.stop)
        cluster.start()
        report = self.run_report("hardware", "--slurm", *Hardware.FLAGS, env=cluster.environment)
        self.assertEqual(
            [run["flags"]["packets"] for run in report["runs"]], [32, 1, 2, 4, 8, 16, 24]
        )
        # The Verilog and the gates of three cores, and the frames.
        submitted = list((self.folder / "report.work" / "logs" / "slurm").iterdir())
        self.assertEqual(len(submitted), 6 + 7)


if __name__ == "__main__":
    unittest.main()
