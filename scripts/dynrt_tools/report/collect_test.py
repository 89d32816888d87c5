# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Collects the results of jobs, and writes a report that is whole or as it was."""

import csv
import os
import pathlib
import unittest

from dynrt_tools import project, testing
from dynrt_tools.project import Failed
from dynrt_tools.report import collect

EXAMPLE = project.read_json(pathlib.Path(__file__).resolve().parent / "example.json")


class Collect(testing.InFolder):
    def test_names(self) -> None:
        self.assertEqual(collect.scene_name("office"), "office")
        self.assertEqual(collect.scene_name("/a b/c d.gltf"), "c_d")
        self.assertEqual(collect.scene_name("maps.pk3:one"), "maps_one")

    def test_csv(self) -> None:
        collect.write_csv(self.folder / "error.csv", EXAMPLE)
        with (self.folder / "error.csv").open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([r["variant"] for r in rows], ["m10", "m16"])
        self.assertEqual(
            (rows[0]["mantissa_bits"], rows[0]["LUT"], rows[0]["clocks"]), ("10", "14210", "40210")
        )
        self.assertEqual([r["clock_ns"] for r in rows], ["8.5", "10.0"])
        self.assertEqual(rows[1]["primary.t_p99"], "1.5e-05")
        self.assertEqual(rows[1]["refused"], "")

    def leave_results(self, work: pathlib.Path, run: project.Json) -> None:
        """As the jobs of a variant of the example leave them."""
        pictures = work / "scenes" / "blocks" / run["variant"] / "pictures"
        pictures.mkdir(parents=True)
        for kind in ("image", "truth", "difference"):
            (pictures / f"{kind}.png").write_text(kind, encoding="utf-8")
        figures = {k: run[k] for k in ("clocks", "counters", "seconds", "measures")}
        project.write_json(pictures.parent / "run.json", figures)
        variant = EXAMPLE["variants"][run["variant"]]
        hardware = work / "variants" / run["variant"] / "hardware.json"
        hardware.parent.mkdir(parents=True)
        project.write_json(
            hardware, {k: variant[k] for k in ("area", "takes", "units", "schedule")}
        )

    def test_collected_as_the_example(self) -> None:
        work = self.folder / "work"
        for run in EXAMPLE["runs"]:
            self.leave_results(work, run)
        listed = {
            name: {k: variant[k] for k in ("differs", "configuration")}
            for name, variant in EXAMPLE["variants"].items()
        }
        scenes = {"blocks": {"about": EXAMPLE["scenes"]["blocks"]["about"]}}
        report, named = collect.collect(work, scenes, listed, "64x48")
        self.assertEqual(report, EXAMPLE)
        self.assertEqual(
            named["pictures/blocks/m16.difference.png"],
            work / "scenes/blocks/m16/pictures/difference.png",
        )

    def test_the_time_is_the_clocks_at_the_period_of_the_variant(self) -> None:
        periods = {name: collect.clock_ns(v) for name, v in EXAMPLE["variants"].items()}
        self.assertLess(periods["m10"], periods["m16"])
        for run in EXAMPLE["runs"]:
            self.assertEqual(run["frame_ms"], run["clocks"] * periods[run["variant"]] / 1e6)

    def test_a_built_in_scene_goes_before_a_folder_of_its_name(self) -> None:
        (self.folder / "blocks").mkdir()
        for name in ("office", "ball.json", "maps.pk3"):
            (self.folder / name).write_text("", encoding="utf-8")
        before = pathlib.Path.cwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        here = pathlib.Path.cwd()
        for scene, path in (
            ("blocks", "blocks"),
            ("office", "office"),
            ("no.obj", "no.obj"),
            ("ball.json", f"{here}/ball.json"),
            ("./ball.json", f"{here}/ball.json"),
            ("maps.pk3:mine", f"{here}/maps.pk3:mine"),
        ):
            self.assertEqual(collect.scene_path(scene), path)

    def test_a_full_disk_leaves_the_report_that_was_there(self) -> None:
        out = self.folder / "out"
        with collect.written_first(out) as new:
            (new / "error.csv").write_text("old", encoding="utf-8")
        with self.assertRaisesRegex(
            Failed,
            f"^--out {out}: cannot be written .the disk is full.; "
            "a report that was there is as it was",
        ):
            with collect.written_first(out) as new:
                (new / "error.csv").write_text("new", encoding="utf-8")
                raise OSError(28, "No space left on device")
        self.assertEqual([p.name for p in out.iterdir()], ["error.csv"])
        self.assertEqual((out / "error.csv").read_text(encoding="utf-8"), "old")

    def test_two_that_write_at_once(self) -> None:
        out = self.folder / "out"
        for left in (".new999999999.cut", ".newest"):  # of a process that is no more; a user's own
            (out / left).mkdir(parents=True)
        with collect.written_first(out) as first:
            (first / "a").write_text("first", encoding="utf-8")
            with collect.written_first(out) as second:
                (second / "b").write_text("second", encoding="utf-8")
        self.assertEqual(sorted(p.name for p in out.iterdir()), [".newest", "a", "b"])


if __name__ == "__main__":
    unittest.main()
