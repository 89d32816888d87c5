# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs scripts/bench on a stand-in for dynrt whose figures are known."""

import json
import unittest
from typing import Any

from dynrt_tools import testing
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import SCRIPTS

BENCH = SCRIPTS / "bench"

# A frame of 100 packets: 10 objects and 40 triangles are transformed, 5 entries were seen before,
# 30 leaves and 3,000 inner nodes are fetched.
STAND_IN = """#!/usr/bin/env python3
import argparse, json, pathlib, sys
if sys.argv[1] == "report":
    out = pathlib.Path(sys.argv[sys.argv.index("--out") + 1])
    out.mkdir(exist_ok=True)
    runs = [{"seconds": {"truth": 0.1}}, {"seconds": {"truth": 0.05}}, {"refused": "why"}]
    out.joinpath("error.json").write_text(json.dumps({"runs": runs}))
    sys.exit()
parser = argparse.ArgumentParser()
parser.add_argument("command")
parser.add_argument("scene")
for flag in ("schedule", "board", "config", "size", "out", "json", "position", "look-at", "up", "fov"):
    parser.add_argument("--" + flag)
parser.add_argument("--packets", type=int, default=64)
a = parser.parse_args()
if a.command == "info":
    pathlib.Path(a.json).write_text(json.dumps({"tree_seconds": 1.25, "triangles": 34202}))
    sys.exit()
if a.board == "rtl" and not HAS_RTL:
    sys.exit("dynrt: there is no RTL in this build")
width, height = map(int, a.size.split("x"))
steps = 3000
if pathlib.Path(a.scene).suffix == ".obj":
    steps += 10 * pathlib.Path(a.scene).read_text().count("f ")
nodes = steps + 30
counters = {"shade_job.tokens": 100, "list_lookup.transactions": 55,
            "collect_hits.transactions": 560, "transform_job.tokens": 150,
            "list_job.tokens": 85, "node_lookup.transactions": nodes}
cycles = nodes * (30 if a.packets == 1 else 2 if a.packets == 32 else 1.25)
units = {"node_lookup": {"transactions": nodes, "utilisation": nodes / cycles, "stalled": 0},
         "list_lookup": {"transactions": 55, "utilisation": 55 / cycles, "stalled": 0}}
caches = {name: {"hit_rate": 0.5, "lookups": 202, "misses": 101} for name in ("node", "list", "matrix")}
report = {"scene": {"instances": 1},
          "frame": {"board": a.board, "configuration": a.config, "width": width, "height": height,
                    "counters": counters, "units": units, "caches": caches,
                    "memory": {"bytes_read": 24, "pixel_bytes_written": 8, "hit_bytes_written": 16},
                    "cycles": cycles if a.board == "rtl" else 1.5 * nodes}}
pathlib.Path(a.json).write_text(json.dumps(report))
"""


class Bench(testing.InFolder):
    def bench(self, *flags: str, rtl: bool = True) -> testing.Result:
        program = self.folder / "dynrt"
        testing.write_program(program, STAND_IN.replace("HAS_RTL", str(rtl)))
        return testing.run(BENCH, "--program", program, *flags, cwd=self.folder)

    def rows(self, *flags: str, rtl: bool = True) -> tuple[dict[str, Any], str]:
        """The rows of figures, by their names, and what is printed."""
        result = self.bench("--runs", "2", "--json", "bench.json", *flags, rtl=rtl)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = json.loads((self.folder / "bench.json").read_text())["rows"]
        return {row["name"]: row for row in rows}, result.stdout

    def test_figures_of_the_rtl(self) -> None:
        rows, text = self.rows()
        self.assertEqual(rows["busiest unit works, 64 packets"]["reached"], 80)
        self.assertIs(rows["busiest unit works, 64 packets"]["met"], False)
        self.assertEqual(rows["busiest unit works, 32 packets"]["reached"], 50)
        self.assertAlmostEqual(rows["rays per clock"]["reached"], 512 * 384 / (1.25 * 3030))
        clock, placed = placed_clocks.of("fast"), rows["frames per second, placed"]
        rate = placed_clocks.frames_per_second(1.25 * 3030, clock.mhz)
        self.assertEqual(placed["reached"], rate if clock.configuration == "fast" else None)
        self.assertIn(clock.of_core("fast"), placed["note"])
        self.assertAlmostEqual(rows["frames per second at 85 MHz"]["reached"], 85e6 / 1.25 / 3030)
        self.assertEqual(rows["nodes per packet"]["reached"], 30.3)
        self.assertAlmostEqual(rows["list entries per packet"]["reached"], 0.55 - 1)
        self.assertNotIn("steps per packet", rows)
        self.assertEqual(rows["tree of 34,202 triangles"]["reached"], 1.25)
        self.assertAlmostEqual(rows["clocks of a frame, model against RTL"]["reached"], 20)
        self.assertEqual(rows["traversal round trip, measured"]["reached"], 30)
        self.assertRegex(text, r"works, 64 packets +>= 90\.0 % +80\.0 % +short +node_lookup")
        self.assertIn(
            "Short: busiest unit works, 64 packets, busiest unit works, 32 packets: the", text
        )

    def test_another_configuration(self) -> None:
        rows, _ = self.rows("--config", "full")
        self.assertEqual(rows["rays per clock"]["asked"], 0.085)
        self.assertEqual(
            (rows["steps per packet"]["reached"], rows["steps per packet"]["met"]), (30, True)
        )
        self.assertEqual(rows["objects per packet"]["reached"], 0.1)

    def test_without_rtl_the_rest_is_measured(self) -> None:
        rows, text = self.rows(rtl=False)
        self.assertIsNone(rows["rays per clock"]["met"])
        self.assertEqual(rows["nodes per packet"]["reached"], 30.3)
        self.assertIn("Nothing of the RTL was measured: dynrt: there is no RTL in this build", text)

    def test_benchmarks(self) -> None:
        rows, _ = self.rows()
        for name in ("top level of 50,000 instances", "truth of rays, per second of two cores"):
            self.assertRegex(rows[name]["note"], "_benchmark is not built$")
        stated: dict[str, dict[str, int]] = {
            "tree/tree": {},
            "analysis/truth/truth": {"rays": 1000},
        }
        for program, more in stated.items():
            runs: list[Any] = [
                {"run_type": "iteration", "cpu_time": ms, **more} for ms in (24, 40, 26)
            ]
            said = json.dumps({"benchmarks": [*runs, {"run_type": "aggregate", "cpu_time": 99}]})
            path = self.folder / "host" / f"{program}_benchmark"
            path.parent.mkdir(parents=True)
            testing.write_program(path, f"#!/bin/sh\necho '{said}'\n")
        rows, _ = self.rows()
        top = rows["top level of 50,000 instances"]
        self.assertEqual((top["reached"], top["met"]), (26, True))
        self.assertIn("24.0 to 40.0", top["note"])
        truth = rows["truth of rays, per second of two cores"]
        self.assertAlmostEqual(truth["reached"], 2 * 1000 / 0.026)

    def test_round_trip_of_schedules(self) -> None:
        reports = self.folder / "generated" / "fast"
        reports.mkdir(parents=True)
        units = ("node_fetch", "node_lookup", "traversal_slice", "packet_decision", "plane_offset")
        for number, unit in enumerate(units):
            stated = json.dumps({"clock_ns": 10.0, "stages": number + 5})
            (reports / f"{unit}.json").write_text(stated, encoding="utf-8")
            if unit == "packet_decision":
                row = self.rows()[0]["traversal round trip, scheduled"]
                self.assertEqual(row["reached"], 5 + 6 + 7 + 8 + 3)
        row = self.rows()[0]["traversal round trip, scheduled"]
        self.assertEqual(row["reached"], 5 + 6 + 7 + 8 + 9 + 3)
        self.assertIn("traversal_slice 7", row["note"])

    def test_report(self) -> None:
        result = self.bench("--report", "--quick", "--json", "report.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        first, again, truth = json.loads((self.folder / "report.json").read_text())["rows"]
        self.assertTrue(first["note"].startswith("2 variants on "))
        self.assertIsNone(first["met"])  # of another size
        self.assertEqual(again["name"], "the same again")
        self.assertEqual((truth["reached"], truth["met"]), (128 * 96 / 0.05 / 1e6, True))

    def test_mistakes(self) -> None:
        for flags, code, said in (
            (("--config", "slow"), 2, "--config slow: unknown; the configurations are thesis, "),
            (("--json", "gone/x.json"), 1, "--json gone/x.json: there is no folder 'gone'"),
            (("--runs", "0"), 2, "--runs 0: at least one run is needed"),
        ):
            result = self.bench(*flags)
            self.assertEqual(result.returncode, code)
            self.assertIn(said, result.stderr)
        result = testing.run(BENCH, "--program", "nothing", cwd=self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("nothing is no program; build it or leave out --program\n", result.stderr)


if __name__ == "__main__":
    unittest.main()
