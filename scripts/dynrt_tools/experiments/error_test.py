# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The error report of two variants whose figures are known, and the choice among them."""

import argparse
import math
import pathlib
import re
import tempfile
import unittest

from dynrt_tools.experiments import choose, error, table
from dynrt_tools.experiments.jobs import RESULT, Maker
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.project import Failed, Json, write_json

AREAS = {"m10": (14210, 17510, 8.5), "m16": (19980, 24560, 10.0)}
CLOCKS = {"m10": 40210, "m16": 40188}
ERRORS: Json = {
    "m10": {"primary": {"rays": 3072, "t_p99": 9.8e-4}, "image": {"differ": 71, "psnr": 38.2}},
    "m16": {"primary": {"rays": 3072, "t_p99": 1.5e-5}, "image": {"differ": 0, "psnr": None}},
}


def report(folder: pathlib.Path) -> tuple[Json, dict[str, pathlib.Path]]:
    """As the jobs leave it: the variants that can render the scene `blocks`, and one that
    cannot."""
    stated: Json = {"m10": {"mantissa_bits": 10}, "m16": {}, "m16_e5": {"exponent_bits": 5}}
    base = table.base_configuration("thesis")
    variants = table.variants(folder, stated, base, "thesis")
    (folder / "build.json").write_text("{}", encoding="utf-8")
    maker = Maker(folder / "dynrt", folder / "build.json", "f")
    found = error.Experiment(maker, {"blocks": "blocks"}, variants, "64x48", True)
    flow = Workflow(folder / "work")
    for name, (luts, takes, clock) in AREAS.items():
        kept = flow.kept(found.area[name])
        kept.mkdir(parents=True)
        area = {"LUT": luts, "mult": 16, "BRAM": 42}
        whole = {"LUT4": takes, "FF": 12440, "block RAM": 42, "multiplier": 16}
        schedule = {"stages": 140, "clock_ns": clock}
        write_json(kept / RESULT, {"area": area, "takes": whole, "schedule": schedule})
        kept = flow.kept(found.frames["blocks", name])
        kept.mkdir(parents=True)
        write_json(kept / RESULT, {"clocks": CLOCKS[name], "measures": ERRORS[name]})
        for kind in error.PICTURES:
            (kept / f"{kind}.png").write_text(kind, encoding="utf-8")
    refused = flow.kept(found.frames["blocks", "m16_e5"])
    refused.mkdir(parents=True)
    write_json(refused / RESULT, {"refused": "exponent_bits 5 cannot hold x = 70000"})
    return found.collected(flow, {"blocks": {"about": "36 </script> triangles"}})


class Case(unittest.TestCase):
    report: Json
    pictures: dict[str, pathlib.Path]

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.report, cls.pictures = report(pathlib.Path(folder))


class Report(Case):
    def test_collected(self) -> None:
        self.assertEqual(self.report["reference"], "m16")
        narrow, refused = self.report["runs"][0], self.report["runs"][-1]
        for run in self.report["runs"][:2]:
            period = self.report["variants"][run["variant"]]["schedule"]["clock_ns"]
            self.assertEqual(run["frame_ms"], run["clocks"] * period / 1e6)
        self.assertEqual(narrow["difference"], "pictures/blocks/m10.difference.png")
        self.assertIn("refused", refused)
        self.assertEqual(
            sorted(self.pictures),
            [
                *(f"pictures/blocks/{n}{s}.png" for n in AREAS for s in (".difference", "")),
                "pictures/blocks/truth.png",
            ],
        )

    def test_csv(self) -> None:
        rows = error.csv_rows(self.report)
        self.assertEqual([row["variant"] for row in rows], ["m10", "m16", "m16_e5"])
        self.assertEqual([row["mantissa_bits"] for row in rows], [10, 16, 16])
        self.assertEqual([row["LUT"] for row in rows], [14210, 19980, None])
        self.assertEqual(rows[0]["primary.t_p99"], 9.8e-4)
        self.assertEqual(list(rows[0])[:4], ["scene", "variant", "mantissa_bits", "exponent_bits"])

    def test_the_page_shows_what_is_kept(self) -> None:
        shown = error.shown(error.kept(self.report), ["a frame"])
        self.assertIn("64x48 pixels; clocks of 8.5 to 10 ns; area on ", shown["about"])
        self.assertEqual(shown["rows"][1]["figures"]["image.psnr"], "identical")
        self.assertEqual(
            [row["family"] for row in shown["rows"]],
            ["mantissa_bits", "reference", "exponent_bits"],
        )
        self.assertEqual(shown["rows"][0]["differs"], "mantissa bits 10")
        self.assertEqual(shown["axes"]["y"], ["primary.t_p99", "image.differ", "image.psnr"])
        self.assertEqual(shown["axes"]["x"], [["frame_ms", "clocks"], ["LUT", "mult", "BRAM"]])
        self.assertEqual(shown["missing"], ["a frame"])


class Choose(Case):
    def chosen(self, measure: str, bound: float) -> tuple[list[str], list[str]]:
        runs, holding = choose.choose(self.report, measure, bound)
        return [r["variant"] for r in runs], [r["variant"] for r in holding]

    def test_cheapest_first(self) -> None:
        self.assertEqual(self.chosen("primary.t_p99", 1e-3), (["m10", "m16"], ["m10", "m16"]))
        self.assertEqual(self.chosen("primary.t_p99", 1e-4)[1], ["m16"])
        self.assertEqual(self.chosen("primary.t_p99", 1e-9)[1], [])

    def test_cost_is_the_largest_part_of_the_device_times_the_time(self) -> None:
        part, resource = choose.part_of_device(self.report["variants"]["m16"])
        self.assertEqual((round(part, 4), resource), (round(24560 / 83640, 4), "LUT4"))
        cost = choose.cost(self.report["variants"]["m16"], self.report["runs"][1])
        self.assertEqual(cost, (part * 0.40188, 19980))

    def test_the_table_says_the_period_of_each_variant(self) -> None:
        runs, _ = choose.choose(self.report, "primary.t_p99", 1e-3)
        lines = choose.table(self.report, runs, "primary.t_p99", 1e-3).splitlines()
        heads, *rows = (re.split("  +", line) for line in lines)
        at = heads.index("clock, ns")
        self.assertEqual([(row[0], row[at]) for row in rows], [("m10", "8.5"), ("m16", "10")])

    def test_of_a_psnr_more_is_better_and_none_means_no_difference(self) -> None:
        self.assertEqual(self.chosen("image.psnr", 60)[1], ["m16"])
        self.assertFalse(choose.holds("primary.t_p99", None, 60))

    def test_mistakes(self) -> None:
        with self.assertRaisesRegex(
            Failed, "^--measure x: this scene has none; its measures are primary.t_p99, "
        ):
            self.chosen("x", 1)
        for flags, sentence in (
            (("x", 1.0), "^--measure x: unknown; the measures are primary.missed, "),
            (("image.rms", math.nan), "^--max-error nan: must be a number$"),
        ):
            args = argparse.Namespace(measure=flags[0], max_error=flags[1])
            with self.assertRaisesRegex(Failed, sentence):
                choose.check_bound(args)


if __name__ == "__main__":
    unittest.main()
