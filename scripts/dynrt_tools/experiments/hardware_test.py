# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The hardware report: the walks that its figures need, its curves and indices, from frames and
gates that are computed by hand."""

import argparse
import pathlib
import tempfile
import unittest
from collections import Counter
from collections.abc import Mapping

from dynrt_tools.experiments import figures, hardware, indices
from dynrt_tools.experiments import testing_frames as made
from dynrt_tools.experiments.figures import FIGURES, WITHOUT_HITS, Point
from dynrt_tools.experiments.frame import RATE
from dynrt_tools.experiments.jobs import RESULT, Job, Maker
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.hardware import gate_rule, gate_units, rtl_files
from dynrt_tools.project import Failed, Json, write_json

BY_NAME = {figure["name"]: figure for figure in FIGURES}


def written(folder: pathlib.Path, name: str, packets: int) -> str:
    path = folder / f"{name}.json"
    write_json(path, {"like": "thesis", "packets": packets, "lines": 2})
    return str(path)


def keep(flow: Workflow, job: Job, result: Json) -> None:
    flow.kept(job).mkdir(parents=True, exist_ok=True)
    write_json(flow.kept(job) / RESULT, result)


def experiment(folder: pathlib.Path, *named: str) -> hardware.Experiment:
    """Of two scenes, a configuration `wide` with curves and `narrow` without."""
    (folder / "build.json").write_text("{}", encoding="utf-8")
    wide, narrow = written(folder, "wide", 4), written(folder, "narrow", 2)
    args = argparse.Namespace(config=[wide], table=[narrow, wide], figure=list(named))
    drawn = hardware.figures_of(named)
    configurations = hardware.configurations_of(args, drawn)
    scenes = {"cistern": "cistern", "lamps": "lamps"}
    names = [figure["name"] for figure in drawn]
    maker = Maker(folder / "dynrt", folder / "build.json", "f")
    return hardware.Experiment(maker, scenes, configurations, names, "32x24", 3)


def report(folder: pathlib.Path, *named: str, without: str = "") -> Json:
    """As jobs leave it; `without` the walk of this name."""
    found, flow = experiment(folder, *named), Workflow(folder / "work")
    for cores in found.own.values():
        for core, job in cores:
            keep(flow, job, made.gates_of(core))
    for name, one in found.configurations.items():
        for scene in ("cistern", "lamps"):
            for point in one.points:
                place = (scene, name, figures.name_of(point))
                core = figures.core_at(one.keys, point)
                if place in found.others:
                    keep(flow, found.others[place], made.gates_of(core))
                if place[2] != without:
                    of = (int(point["packets"]), int(point["lines"]))
                    keep(
                        flow, found.walks[place], made.walk(*of, point["order"] == "scanline", core)
                    )
    return found.collected(flow, {s: {"about": f"the scene {s}"} for s in ("cistern", "lamps")})


class Case(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))


class Walks(Case):
    def names(self, configuration: Json, *drawn: str) -> list[str]:
        some = [BY_NAME[name] for name in drawn] if drawn else FIGURES
        return [figures.name_of(point) for point in figures.points(configuration, some)]

    def test_each_is_made_once(self) -> None:
        names = self.names({"packets": 4, "lines": 2})
        self.assertEqual(len(names), len(set(names)))
        own = "packets 4 lines 2 order morton"
        bare = f"{own} no-hits"
        self.assertEqual(names[0], own)
        morton = {f"packets {p} lines 2 order morton" for p in (1, 2, 4)}
        morton |= {"packets 4 lines 1 order morton"}
        scanline = {f"packets 4 lines {n} order scanline" for n in (1, 2)}
        several = {
            f"{bare} {key} {n}" for key in ("memory_clocks", "pipelines") for n in (2, 4, 8, 16)
        }
        self.assertEqual(set(names), morton | scanline | {bare} | several)

    def test_flags(self) -> None:
        point = figures.own_point({"packets": 4, "lines": 2})
        flags = "--packets 4 --lines 2 --order morton".split()
        self.assertEqual(figures.flags_of(point), [*flags, "--hits"])
        self.assertEqual(figures.flags_of({**point, **WITHOUT_HITS, "pipelines": 2}), flags)
        self.assertEqual(figures.keys_of({**point, "pipelines": 2, "made": 1}), {"pipelines": 2})

    def test_a_configuration_is_its_own_core_at_its_own_value(self) -> None:
        pair: Json = {"packets": 4, "lines": 2, "pipelines": 2}
        points = figures.points(pair, [BY_NAME["7.12"]])
        found = [figures.keys_of(point) for point in points]
        self.assertEqual(found, [{}, {"pipelines": 1}, {}, *({"pipelines": n} for n in (4, 8, 16))])

    def test_a_memory_behind_a_port(self) -> None:
        port: Json = {"packets": 4, "lines": 4, "ways": 2, "memory": "port", "port_bytes": 16}
        first, *rest = figures.points(port, [BY_NAME["7.11"]])
        flags = "--packets 4 --lines 4 --order morton --memory-latency 30 --hits".split()
        self.assertEqual(figures.flags_of(first), flags)
        widths = [figures.keys_of(point).get("port_bytes", 16) for point in rest]
        self.assertEqual(widths, [2, 4, 8, 16, 32])
        axis = figures.axis_of(BY_NAME["7.11"], port)
        self.assertEqual(
            [figures.x_of(axis, w) for w in axis["values"]], [170, 340, 680, 1360, 2720]
        )
        # A set has a line in each way.
        lines = {int(p["lines"]) for p in figures.points(port, [BY_NAME["7.5 and 7.10"]])}
        self.assertEqual(lines, {2, 4})

    def test_a_core_is_made_of_its_keys(self) -> None:
        found = experiment(self.folder, "7.12")
        place = ("lamps", "wide", "packets 4 lines 2 order morton no-hits pipelines 4")
        words = {str(word) for word in found.walks[place].words}
        (model,) = (job for job in found.walks[place].after if job.kind == "model")
        self.assertIn(f"kept/{model.key}/model.so", words)
        assert model.keys is not None
        self.assertEqual((model.keys["pipelines"], model.keys["packets"]), (4, 4))
        # Of 8 and 16 pipelines no index is shown, so nothing counts their gates.
        counted = sorted(name.rpartition(" ")[2] for _, _, name in found.others)
        self.assertEqual(counted, ["2", "2", "4", "4"])

    def test_mistakes(self) -> None:
        with self.assertRaisesRegex(
            Failed, "^--figure 7.13: unknown; the figures are 7.5, 7.10, 7.6, "
        ):
            hardware.figures_of(["7.13"])
        path = self.folder / "mute.json"
        write_json(path, {"like": "thesis", "counters": False})
        args = argparse.Namespace(config=[str(path)], table=[str(path)], figure=["7.9"])
        with self.assertRaisesRegex(
            Failed, "it counts nothing, so nobody can tell the use of its units"
        ):
            hardware.configurations_of(args, [])


class Report(Case):
    def test_curves(self) -> None:
        found = report(self.folder)

        def curves(name: str) -> list[figures.Curve]:
            return list(figures.curves(found, BY_NAME[name], "lamps"))

        (rate,) = curves("7.9")
        self.assertEqual([x for x, _ in rate.points], [1, 2, 4])
        hits = curves("7.5 and 7.10")
        self.assertEqual([c.dashed for c in hits], 3 * [False] + 3 * [True])
        for (_, morton), (_, scanline) in zip(hits[0].points, hits[3].points):
            self.assertAlmostEqual(morton - scanline, 10)
        (bandwidth,) = curves("7.11")
        self.assertEqual([x for x, _ in bandwidth.points], [63.75, 127.5, 255, 510, 1020])
        self.assertAlmostEqual(bandwidth.points[-1][1] / bandwidth.points[0][1], 23 / 8)
        (scale,) = curves("7.12")
        self.assertAlmostEqual(scale.points[-1][1], 16 * bandwidth.points[-1][1])

    def test_indices(self) -> None:
        (wide,) = [
            r
            for r in report(self.folder)["table"]
            if r["configuration"] == "wide" and r["scene"] == "lamps"
        ]
        # The slice works in 0.4 of the clocks with 300 gates, the intersection in 0.2 with 100.
        use, logic, memory = (300 * 0.4 + 100 * 0.2) / 400, 1040, 860
        self.assertAlmostEqual(wide["U_AU"], 100 * use)
        self.assertAlmostEqual(wide["QHW"], 100 * use * logic / (logic + memory))
        self.assertAlmostEqual(wide["QGHW"], 1e6 * (768 / 19200) / (logic + memory))
        self.assertEqual(wide["thesis's C_RTC"], 487020 + 56028 * 4 + 996 * 2)
        runs = {
            figures.name_of(r["flags"]): r
            for r in report(self.folder)["runs"]
            if r["scene"] == "lamps"
        }
        fewer = runs["packets 1 lines 2 order morton"]
        self.assertAlmostEqual(fewer["QGHW"], 1e6 * (768 / 76800) / (1010 + 260))
        four = runs["packets 4 lines 2 order morton no-hits pipelines 4"]
        self.assertEqual(four["C_AU + C_IM"], 4 * (logic + memory))
        self.assertAlmostEqual(four["QGHW"], wide["QGHW"])
        self.assertNotIn("QGHW", runs["packets 4 lines 2 order morton no-hits pipelines 16"])

    def test_findings(self) -> None:
        row, other = report(self.folder)["findings"]
        self.assertEqual((row["scene"], other["scene"]), ("cistern", "lamps"))
        self.assertEqual(row["QGHW at packets"], 4)
        self.assertAlmostEqual(row["best QGHW"], 1e6 * (768 / 19200) / 1900)
        for cache in indices.CACHES:
            self.assertAlmostEqual(row[f"{cache} cache hits gained"], 10)
        self.assertAlmostEqual(row[indices.QUARTER], 100 * (1 - 8 / 11))
        self.assertAlmostEqual(row["speed-up of 4 pipelines"], 4)
        self.assertAlmostEqual(row[indices.HALF], (2 / 8) / (2 / 9))
        self.assertLessEqual(figures.TABLE["said"].keys(), set(indices.FINDINGS))
        (alone, _) = report(self.folder, "7.9")["findings"]
        self.assertIsNone(alone[indices.QUARTER])
        self.assertIsNone(alone["list cache hits gained"])

    def test_additions(self) -> None:
        configuration: Json = {"packets": 4, "lines": 2, "curves": True}
        ways: Json = {"name": "two ways", "configuration": "wide", "without": {"ways": 1}}
        without, having = figures.added_points(ways, configuration)
        self.assertEqual((figures.keys_of(without), figures.keys_of(having)), ({"ways": 1}, {}))

        def run(point: Point, rate: float, gates: int) -> Json:
            place = {"scene": "lamps", "configuration": "wide", "flags": dict(point)}
            return {**place, RATE: rate, "C_AU + C_IM": gates, "QHW": rate / 10}

        runs = [run(without, 20, 1000), run(having, 30, 1100)]
        row = indices.gain_of(runs, "lamps", ways, configuration)
        self.assertAlmostEqual(row["frame rate gained"], 50)
        self.assertAlmostEqual(row["gates added"], 10)
        self.assertEqual((row["QHW without"], row["QHW with"], row["QGHW with"]), (2, 3, None))
        self.assertEqual(set(row), set(indices.GAINS))
        row = indices.gain_of(runs[1:], "lamps", ways, configuration)
        self.assertEqual((row["frame rate gained"], row["QHW with"]), (None, 3))

    def test_what_is_missing(self) -> None:
        found = report(self.folder, "7.9", without="packets 2 lines 2 order morton")
        self.assertEqual(
            found["missing"],
            [
                f"{scene}, {name}: 1 of {count} walks"
                for scene in ("cistern", "lamps")
                for name, count in (("narrow", 1), ("wide", 3))
            ],
        )
        (rate,) = figures.curves(found, BY_NAME["7.9"], "lamps")
        self.assertEqual([x for x, _ in rate.points], [1, 4])

    def test_a_row_of_the_csv_has_the_flags(self) -> None:
        lines = hardware.csv_rows(report(self.folder, "7.9"))
        self.assertEqual({line["packets"] for line in lines}, {1, 2, 4})
        self.assertNotIn("flags", lines[0])


class Gates(unittest.TestCase):
    def test_parts(self) -> None:
        own: Json = {"packets": 64, "lines": 512}
        counted = [(core, made.gates_of(core)) for core in (own, *indices.smaller(own))]
        parts = indices.split(counted)
        whole = indices.of_core(own, counted[0][1], parts)
        assert parts and whole
        for part, (logic, memory) in {
            "fixed": (1000, 0),
            "packet": (10, 200),
            "line": (0, 30),
        }.items():
            self.assertAlmostEqual(parts[part]["logic"], logic, 4)
            self.assertAlmostEqual(parts[part]["memory"], memory, 4)
        cost = indices.costs(whole, 24, 16)
        assert cost
        self.assertAlmostEqual(sum(cost), 1000 + 210 * 24 + 30 * 16, 4)
        self.assertIsNone(indices.costs({**whole, "split": None}, 24, 16))
        self.assertIsNone(indices.split(counted[:1]))
        self.assertEqual(hardware.formula(whole), "1,000 + 210 P + 30 CL")

    def arithmetic(self, configuration: str) -> list[str]:
        """The arithmetic units among the instances of the checked-in Verilog."""
        core = rtl_files.ALL_GENERATED / configuration / f"{rtl_files.CORE}.v"
        count = gate_rule.Count(Counter({"LUT4": 1}), ())
        counts = {part.name: count for part in rtl_files.instances(core)} | {"join": count}
        return sorted(indices.gates_of(counts)["arithmetic"])

    def test_the_arithmetic_units_are_those_of_table_7_3(self) -> None:
        slices = [f"slice_{i}" for i in range(8)]
        others = ["collect_hits", "intersection", "transformation"]
        more = ["camera_rays", "plane_offset", "ray_reciprocal", "world_box"]
        self.assertEqual(self.arithmetic("thesis"), sorted(slices[:4] + others))
        self.assertEqual(self.arithmetic("fast"), sorted(slices + others + more))

    def test_pipelines_and_what_counts(self) -> None:
        def count(cells: int, memory: str) -> gate_rule.Count:
            return gate_rule.Count(Counter({"LUT4": cells}), (gate_rule.Memory(memory, 8, 4, 2),))

        units: Mapping[str, gate_rule.Count] = {
            "slice_0": count(10, "rows"),
            "shading": count(1000, "pixels"),
        }
        joins = {"join": count(0, "ray_0_ram"), "frame_writer": count(1000, "fifo")}
        one = indices.gates_of({**units, "join": count(0, "ray_0_ram")})
        self.assertEqual(one, {"logic": 90, "memory": 4 * 2 * 64, "arithmetic": {"slice_0": 90}})
        two = indices.gates_of(
            {f"p{i}_{name}": unit for i in (0, 11) for name, unit in units.items()} | joins
        )
        self.assertEqual(two["logic"], 2 * one["logic"])
        self.assertEqual(two["arithmetic"], {"slice_0": 180})
        self.assertEqual(gate_units.owner("p11_ray_0_ram_0"), "TraversalSlice0")


if __name__ == "__main__":
    unittest.main()
