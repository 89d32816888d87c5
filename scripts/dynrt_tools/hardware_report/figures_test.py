# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The frames and the curves that follow from the description of the figures."""

import unittest

from dynrt_tools.build import configs
from dynrt_tools.hardware_report import example, figures, findings, points
from dynrt_tools.hardware_report.figure import KEYS, WITHOUT_HITS, Axis, Figure, Point, Series
from dynrt_tools.project import Json


class Figures(unittest.TestCase):
    def test_each_frame_is_rendered_once(self) -> None:
        keys = example.configuration(4, 2)["keys"]
        names = [points.name_of(point) for point in points.points(keys, figures.FIGURES)]
        self.assertEqual(len(names), len(set(names)))
        morton = {f"packets-{p}_lines-2_order-morton" for p in (1, 2, 4)}
        morton |= {"packets-4_lines-1_order-morton"}
        scanline = {f"packets-4_lines-{n}_order-scanline" for n in (1, 2)}
        bare = "packets-4_lines-2_order-morton_no-hits"
        slow = {f"{bare}_memory_clocks-{n}" for n in (2, 4, 8, 16)}
        several = {f"{bare}_pipelines-{n}" for n in (2, 4, 8, 16)}
        self.assertEqual(set(names), morton | scanline | {bare} | slow | several)

    def test_flags_of_render(self) -> None:
        point = points.own_point({"packets": 4, "lines": 2})
        flags = "--packets 4 --lines 2 --order morton"
        self.assertEqual(points.flags_of(point), f"{flags} --hits")
        self.assertEqual(points.flags_of({**point, **WITHOUT_HITS}), flags)
        self.assertEqual(points.core_of("wide", point), "wide")
        several: Point = {**point, "pipelines": 2}
        self.assertEqual(points.flags_of(several), f"{flags} --hits")
        self.assertEqual(points.core_of("wide", several), "wide-pipelines2")

    def test_each_value_of_a_key_is_one_that_it_allows(self) -> None:
        known = configs.load_configurations().KEYS
        axes = [axis for f in figures.FIGURES for axis in (f.axis, f.behind_port) if axis]
        along = {axis.along: axis for axis in axes if axis.along in KEYS}
        self.assertEqual(set(along), set(KEYS))
        for key, axis in along.items():
            self.assertEqual(known[key].default, KEYS[key])
            self.assertTrue(all(known[key].kind.allows(value) for value in axis.values))

    def test_a_configuration_is_its_own_core_at_its_own_value(self) -> None:
        (figure,) = [f for f in figures.FIGURES if f.axis.along == "pipelines"]
        pair = {"packets": 4, "lines": 2, "pipelines": 2}
        found = [points.keys_of(point) for point in points.points(pair, (figure,))]
        self.assertEqual(found, [{}, {"pipelines": 1}, {}, *({"pipelines": n} for n in (4, 8, 16))])

    def test_another_figure_is_another_entry(self) -> None:
        widths = Figure("7.1", "Rate", Axis("width", (2, 4, 8)), "", (Series("rate", "clocks"),))
        keys = {"packets": 4, "lines": 2, "width": 4}
        names = [points.name_of(point) for point in points.points(keys, (widths,))]
        end = "packets-4_lines-2_order-morton"
        self.assertEqual(names, [end, f"{end}_width-2", f"{end}_width-4"])
        keys.pop("width")
        self.assertEqual(len(points.points(keys, (widths,))), 4)

    def test_a_memory_behind_a_port(self) -> None:
        port: Json = {"packets": 4, "lines": 4, "ways": 2, "memory": "port", "port_bytes": 16}
        own: Json = {"packets": 4, "lines": 4, "order": "morton", "memory-latency": 30}
        by_name = {figure.name: figure for figure in figures.FIGURES}
        bandwidth = points.points(port, (by_name["7.11"],))
        self.assertEqual(bandwidth[0], own)
        self.assertEqual(
            points.flags_of(bandwidth[0]),
            "--packets 4 --lines 4 --order morton --memory-latency 30 --hits",
        )
        widths = [points.keys_of(point).get("port_bytes", 16) for point in bandwidth[1:]]
        self.assertEqual(widths, [2, 4, 8, 16, 32])
        axis = by_name["7.11"].axis_of(port)
        self.assertEqual([axis.x_of(w) for w in axis.values], [170, 340, 680, 1360, 2720])
        # A set has a line in each way.
        lines = {int(point["lines"]) for point in points.points(port, (by_name["7.5 and 7.10"],))}
        self.assertEqual(lines, {2, 4})
        paired: Json = {**port, "lines": 32, "line_nodes": 2}
        hits = points.points(paired, (by_name["7.5 and 7.10"],))
        self.assertEqual({int(point["lines"]) for point in hits}, {16, 32})

    def test_what_a_quarter_of_a_port_costs(self) -> None:
        port: Json = {"packets": 4, "lines": 4, "memory": "port", "port_bytes": 16}
        own: Json = {**points.own_point(port), **WITHOUT_HITS}
        runs = [
            {"scene": "lamps", "configuration": "port", "flags": dict(flags), figures.RATE: rate}
            for flags, rate in ((own, 20.0), ({**own, "port_bytes": 4}, 15.0))
        ]
        row = findings.row_of(runs, "lamps", "port", port)
        self.assertEqual(row["lost at a quarter of the bandwidth"], 25)

    def test_curves(self) -> None:
        report = example.report()
        by_name = {figure.name: figure for figure in figures.FIGURES}
        (index,) = figures.curves(report, by_name["7.7"], "cistern")
        self.assertEqual(index.configuration, "wide")
        self.assertEqual([x for x, _ in index.points], [1, 2, 4])
        hits = list(figures.curves(report, by_name["7.5 and 7.10"], "cistern"))
        self.assertEqual([c.series.dashed for c in hits], 3 * [False] + 3 * [True])
        node, node_scanline = hits[0].points, hits[3].points
        self.assertEqual([x for x, _ in node], [1, 2])
        for (_, morton), (_, scanline) in zip(node, node_scanline):
            self.assertAlmostEqual(morton - scanline, 10)

    def test_curves_of_cores(self) -> None:
        report = example.report()
        by_name = {figure.name: figure for figure in figures.FIGURES}
        (bandwidth,) = figures.curves(report, by_name["7.11"], "lamps")
        self.assertEqual([x for x, _ in bandwidth.points], [63.75, 127.5, 255, 510, 1020])
        slowest, quickest = bandwidth.points[0][1], bandwidth.points[-1][1]
        self.assertAlmostEqual(quickest / slowest, 23 / 8)
        (scale,) = figures.curves(report, by_name["7.12"], "lamps")
        self.assertEqual([x for x, _ in scale.points], [1, 2, 4, 8, 16])
        self.assertEqual(scale.points[0][1], quickest)
        self.assertAlmostEqual(scale.points[-1][1], 16 * quickest)

    def test_a_curve_leaves_out_what_is_missing(self) -> None:
        report = example.report()
        report["runs"] = [r for r in report["runs"] if r["flags"]["packets"] != 2]
        rate = next(f for f in figures.FIGURES if f.name == "7.9")
        (curve,) = figures.curves(report, rate, "lamps")
        self.assertEqual([x for x, _ in curve.points], [1, 4])

    def test_what_the_curves_say(self) -> None:
        report = example.report()
        self.assertEqual([row["scene"] for row in report["findings"]], ["cistern", "lamps"])
        found = report["findings"][0]
        along = [r for r in report["runs"] if (r["scene"], r["configuration"]) == ("lamps", "wide")]
        along = [r for r in along if (r["flags"]["lines"], r["flags"]["order"]) == (2, "morton")]
        along = [r for r in along if not r["flags"].keys() & {*KEYS, "no-hits"}]
        self.assertEqual(len(along), 3)
        best = max(along, key=lambda r: float(r["QHW"]))
        self.assertEqual(found["best QHW"], best["QHW"])
        self.assertEqual(found["QHW at packets"], best["flags"]["packets"])
        for cache in ("node", "list", "matrix"):
            self.assertAlmostEqual(found[f"{cache} cache hits gained"], 10)
        self.assertAlmostEqual(found["lost at a quarter of the bandwidth"], 100 * (1 - 8 / 11))
        self.assertAlmostEqual(found["speed-up of 2 pipelines"], 2)
        half = found["2 pipelines, by twice one at half the bandwidth"]
        self.assertAlmostEqual(half, (2 / 8) / (2 / 9))
        self.assertAlmostEqual(found["speed-up of 4 pipelines"], 4)
        for index in ("QHW", "QGHW"):
            for run in report["runs"]:
                run[index] = run["flags"].get("pipelines")
            self.assertEqual(findings.of(report)[0][f"{index} of 4 pipelines"], 4)
        self.assertLessEqual(findings.THESIS.keys(), set(findings.COLUMNS))

    def test_what_no_frame_says_is_unknown(self) -> None:
        report = example.report()
        kept = [r for r in report["runs"] if r["flags"]["order"] == "morton"]
        for run in kept:
            run.pop("QGHW", None)
        (first, _) = findings.of({**report, "runs": kept})
        self.assertIsNone(first["list cache hits gained"])
        self.assertIsNone(first["best QGHW"])
        whole = [r for r in report["runs"] if not r["flags"].keys() & set(KEYS)]
        (first, _) = findings.of({**report, "runs": whole})
        self.assertIsNone(first["lost at a quarter of the bandwidth"])
        self.assertIsNone(first["speed-up of 2 pipelines"])
        (first, _) = findings.of({**report, "runs": kept})
        self.assertIsNotNone(first["best QHW"])
        alone = [r for r in kept if r["flags"]["packets"] == 4]
        (first, _) = findings.of({**report, "runs": alone})
        self.assertIsNone(first["best QHW"], "one is no best")


if __name__ == "__main__":
    unittest.main()
