# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs scripts/bench on a stand-in for dynrt whose figures are known."""

import json
import unittest
from typing import Any

from dynrt_tools import testing
from dynrt_tools.bench.run import Work
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
parser.add_argument("--lines", type=int, default=512)
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
nodes *= 2000 if a.scene == "trees4000" else 1
cycles = nodes * (30 if a.packets == 1 else 2 if a.packets == 32 else 1.25)
units = {name: {"transactions": count, "utilisation": count / cycles,
                "stalled": 0.03 if name == "transformation" else 0} for name, count in
         {"node_lookup": nodes, "list_lookup": 55, "transformation": 750,
          "intersection": 560, "memory_interface": 303}.items()}
caches = {name: {"hit_rate": a.lines / 1024, "misses": 101} for name in ("node", "list", "matrix")}
report = {"scene": {"instances": 1},
          "frame": {"board": a.board, "configuration": a.config, "width": width, "height": height,
                    "hits": 1, "counters": counters,
                    "units": units, "caches": caches,
                    "memory": {"bytes_read": 24 * width * height, "pixel_bytes_written": 8,
                               "hit_bytes_written": 16},
                    "cycles": cycles if a.board == "rtl" else 1.5 * nodes if a.schedule else None}}
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
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        rows = json.loads((self.folder / "bench.json").read_text())["rows"]
        return {row["name"]: row for row in rows}, result.stdout

    def test_work_of_a_frame(self) -> None:
        frame: dict[str, Any] = {
            "configuration": "full",
            "counters": {
                "shade_job.tokens": 49152,
                "list_lookup.transactions": 311024,
                "collect_hits.transactions": 1135952,
                "transform_job.tokens": 333140,
                "list_job.tokens": 435918,
                "node_lookup.transactions": 1681545,
            },
        }
        work = Work.of(frame)
        self.assertEqual(work, Work(49152, 1681545, 311024, 0, 1556651, 124894, 234836, 49152))
        self.assertEqual(work.bound(), 1681545)
        # The counters of other cores say less.
        for other in ("fast", "whitted", "watertight", "configuration"):
            work = Work.of({**frame, "configuration": other})
            self.assertEqual(work, Work(49152, 1681545, 311024, 0), other)

    def test_figures_of_the_rtl(self) -> None:
        rows, text = self.rows()
        self.assertEqual(rows["busiest unit works, 64 packets"]["reached"], 80)
        self.assertIs(rows["busiest unit works, 64 packets"]["met"], False)
        self.assertEqual(rows["busiest unit works, 32 packets"]["reached"], 50)
        self.assertAlmostEqual(rows["rays per clock"]["reached"], 512 * 384 / (1.25 * 3030))
        clock = placed_clocks.of("fast")
        placed = rows["frames per second, placed"]
        rate = placed_clocks.frames_per_second(1.25 * 3030, clock.mhz)
        self.assertEqual(placed["reached"], rate if clock.configuration == "fast" else None)
        self.assertIn(clock.of_core("fast"), placed["note"])
        self.assertAlmostEqual(rows["frames per second at 85 MHz"]["reached"], 85e6 / 1.25 / 3030)
        self.assertEqual(rows["nodes per packet"]["reached"], 30.3)
        self.assertAlmostEqual(rows["list entries per packet"]["reached"], 0.55 - 1)
        self.assertNotIn("steps per packet", rows)
        self.assertEqual(rows["tree of 34,202 triangles"]["reached"], 1.25)
        self.assertLess(rows["peak memory of a render"]["reached"], 1000)
        self.assertRegex(text, r"works, 64 packets +>= 90\.0 % +80\.0 % +short +node_lookup")
        self.assertIn(
            "Short: busiest unit works, 64 packets, busiest unit works, 32 packets: the "
            "rest of the clocks",
            text,
        )

    def test_top_level(self) -> None:
        rows, _ = self.rows()
        row = rows["top level of 50,000 instances"]
        self.assertIsNone(row["reached"])
        self.assertIn("tree_benchmark is not built", row["note"])
        program = self.folder / "host" / "tree" / "tree_benchmark"
        program.parent.mkdir(parents=True)
        runs = [{"run_type": "iteration", "cpu_time": ms} for ms in (24.5, 40, 26)]
        runs.append({"run_type": "aggregate", "cpu_time": 99})
        program.write_text(
            f"#!/bin/sh\necho '{json.dumps({'benchmarks': runs})}'\n", encoding="utf-8"
        )
        program.chmod(0o755)
        row = self.rows()[0]["top level of 50,000 instances"]
        self.assertEqual(row["reached"], 26)
        self.assertIs(row["met"], True)
        self.assertIn("24.5 to 40.0", row["note"])

    def test_truth(self) -> None:
        rows, _ = self.rows()
        row = rows["truth of rays, per second of two cores"]
        self.assertIsNone(row["reached"])
        self.assertIn("truth_benchmark is not built", row["note"])
        program = self.folder / "host" / "analysis" / "truth" / "truth_benchmark"
        program.parent.mkdir(parents=True)
        runs = [
            {
                "run_type": "iteration",
                "cpu_time": ms,
                "rays": 100_000,
                "tests_per_ray": 3.4,
                "exact_per_ray": 0.04,
            }
            for ms in (400, 1000, 500)
        ]
        program.write_text(
            f"#!/bin/sh\necho '{json.dumps({'benchmarks': runs})}'\n", encoding="utf-8"
        )
        program.chmod(0o755)
        row = self.rows()[0]["truth of rays, per second of two cores"]
        self.assertEqual(row["reached"], 400_000)
        self.assertIs(row["met"], True)
        self.assertIn("200,000 to 500,000; 3.4 primitives a ray", row["note"])

    def test_round_trip(self) -> None:
        rows, _ = self.rows()
        self.assertEqual(rows["traversal round trip, measured"]["reached"], 30)
        self.assertIsNone(rows["traversal round trip, scheduled"]["reached"])
        reports = self.folder / "generated" / "fast"
        reports.mkdir(parents=True)
        for number, unit in enumerate(
            ("node_fetch", "node_lookup", "traversal_slice", "packet_decision")
        ):
            (reports / f"{unit}.json").write_text(
                json.dumps({"clock_ns": 10.0, "stages": number + 5})
            )
        rows, text = self.rows()
        self.assertEqual(rows["traversal round trip, scheduled"]["reached"], 5 + 6 + 7 + 8 + 3)
        self.assertIn("traversal_slice 7", text)
        (reports / "plane_offset.json").write_text(json.dumps({"clock_ns": 10.0, "stages": 9}))
        rows, text = self.rows()
        self.assertEqual(rows["traversal round trip, scheduled"]["reached"], 5 + 6 + 9 + 7 + 8 + 3)

    def test_configurations_are_refused_where_they_say_nothing(self) -> None:
        for flags, said in (
            (("--config", "slow"), "--config slow: unknown; the configurations are thesis, "),
            (
                ("--config", "full", "--scenes"),
                "--scenes has its own configurations; leave one out",
            ),
        ):
            result = self.bench(*flags)
            self.assertEqual(result.returncode, 2)
            self.assertIn(said, result.stderr)

    def test_another_configuration(self) -> None:
        rows, text = self.rows("--config", "whitted")
        self.assertIn("configuration whitted;", text)
        self.assertIsNone(rows["rays per clock"]["asked"])
        self.assertIsNone(rows["rays per clock"]["met"])
        full, _ = self.rows("--config", "full")
        self.assertEqual(full["rays per clock"]["asked"], 0.085)
        self.assertEqual(full["steps per packet"]["reached"], 30)
        self.assertIs(full["steps per packet"]["met"], True)
        self.assertEqual(full["objects per packet"]["reached"], 0.1)
        self.assertIsNone(full["objects per packet"]["met"])

    def test_clocks_by_the_schedules(self) -> None:
        row = self.rows()[0]["clocks of a frame, model against RTL"]
        self.assertAlmostEqual(row["reached"], 20)
        self.assertIs(row["met"], False)
        self.assertRegex(row["note"], r"^4,545.* by the units' schedules")
        self.assertIsNone(
            self.rows(rtl=False)[0]["clocks of a frame, model against RTL"]["reached"]
        )

    def test_without_rtl_the_rest_is_measured(self) -> None:
        rows, text = self.rows(rtl=False)
        self.assertIsNone(rows["rays per clock"]["reached"])
        self.assertIsNone(rows["rays per clock"]["met"])
        self.assertEqual(rows["nodes per packet"]["reached"], 30.3)
        self.assertIn("Nothing of the RTL was measured: dynrt: there is no RTL in this build", text)

    def test_scenes_beside_the_thesis(self) -> None:
        result = self.bench("--scenes", "--json", "scenes.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        scenes = json.loads((self.folder / "scenes.json").read_text())["scenes"]
        self.assertEqual(
            [(s["scene"], s["configuration"]) for s in scenes],
            [
                (scene, config)
                for scene in ("office", "cistern", "conference", "trees4000")
                for config in ("full", "fast")
            ],
        )
        office, trees = scenes[0], scenes[7]
        self.assertEqual(office["clocks per frame"], 1.25 * 3030)
        self.assertEqual(office["beside the thesis"], "above")
        self.assertEqual(office["nodes per packet"], 30.3)
        self.assertEqual(office["triangles per packet"], 0.4)
        self.assertEqual(trees["triangles per packet"], "-")
        self.assertEqual(office["bytes read per ray"], 24)
        self.assertEqual(
            trees["frames per second at 85 MHz"], round(85e6 / (1.25 * 3030 * 2000), 2)
        )
        clock = placed_clocks.of("fast")
        rate = f"{placed_clocks.frames_per_second(1.25 * 3030 * 2000, clock.mhz):.2f}"
        own = clock.configuration == "fast"
        self.assertEqual(trees["frames per second, placed"], rate if own else f"({rate})")
        self.assertIn(f"\nFrames per second, placed: {clock.of_core('fast')}.\n", result.stdout)
        self.assertEqual(trees["beside the thesis"], "within")
        self.assertRegex(
            result.stdout, r"\nthesis( +20 to 30){2}( +17 to 25){2}( +17 to 20){2}( +8 to 14){2}\n"
        )
        self.assertRegex(result.stdout, r"\n  transformation( +19.8){6}( +0.0){2}\n")
        self.assertIn(
            "\ntrees4000, fast, within the thesis's range: node_lookup works in 80.0 % of the "
            "clocks, 60600 times for each packet, and otherwise waits for packets that "
            "are elsewhere; the memory serves cache misses in 0.0 %; held up for want of "
            "room behind them: transformation 3.0 %.",
            result.stdout,
        )
        self.assertNotIn("\noffice, ", result.stdout)

    def test_scenes_of_another_size_are_not_compared(self) -> None:
        result = self.bench("--scenes", "--quick")
        self.assertRegex(result.stdout, r"\nbeside the thesis( +-){8}\n")
        self.assertNotIn("range", result.stdout)

    def test_scenes_need_the_rtl(self) -> None:
        result = self.bench("--scenes", rtl=False)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, "bench: dynrt: there is no RTL in this build\n")

    def test_two_tables_at_once(self) -> None:
        result = self.bench("--scenes", "--levers")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--scenes and --levers are two tables; ask for one of them", result.stderr)

    def test_report(self) -> None:
        result = self.bench("--report", "--quick", "--json", "report.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        first, again, truth = json.loads((self.folder / "report.json").read_text())["rows"]
        self.assertTrue(first["note"].startswith("2 variants on "))
        self.assertIsNone(first["met"])  # of another size
        self.assertEqual(again["name"], "the same again")
        self.assertEqual((truth["reached"], truth["met"]), (128 * 96 / 0.05 / 1e6, True))

    def test_a_program_that_is_none(self) -> None:
        result = testing.run(BENCH, "--program", "nothing")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr, "bench: nothing is no program; build it or leave out --program\n"
        )

    def test_a_folder_that_is_not_there(self) -> None:
        result = self.bench("--json", "gone/bench.json")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--json gone/bench.json: there is no folder 'gone'", result.stderr)


if __name__ == "__main__":
    unittest.main()
