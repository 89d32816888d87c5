# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The command lines of experiments and of a choice, and the files that a report is written to."""

import json
import os
import pathlib
import unittest

from dynrt_tools import project, testing
from dynrt_tools.experiments import command, output, table
from dynrt_tools.project import Failed, Json


class Mistakes(testing.InFolder):
    def assert_mistake(self, words: list[str], sentence: str, alone: bool = False) -> None:
        build = self.folder / "build.json"
        described = {"source": str(self.folder), "identity": {}, "program_only": alone}
        build.write_text(json.dumps(described), encoding="utf-8")
        given = ("--program", "dynrt", "--build", str(build), "--expect", "f")
        script, *rest = words
        result = testing.run(
            project.SCRIPTS / script, *rest[:1], *given, *rest[1:], cwd=self.folder
        )
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"dynrt: {sentence}\n")

    def test_flags(self) -> None:
        listed = table.with_reference(
            table.FOLDER / "error.json", table.base_configuration("thesis"), "thesis", False
        )
        for words, sentence in (
            (
                ["error", "--colour"],
                "unrecognized arguments: --colour; dynrt report error --help lists what there is",
            ),
            (["memory", "--jobs", "0"], "--jobs 0: at least one is needed"),
            (
                ["error", "--variant", "x"],
                f"--variant x: unknown; the variants are {', '.join(listed)}",
            ),
            (
                ["ideas", "--variant", "x"],
                f"--variant x: unknown; the variants are {', '.join(table.of_experiment('ideas'))}",
            ),
            (["hardware", "--frames", "0"], "--frames 0: a report's walk has 1 to 100 frames"),
            (
                ["hardware", "--json", "no/x.json"],
                "--json no/x.json: there is no folder 'no'; create it or name a file elsewhere",
            ),
            (
                ["scenes", "--drawings", "no"],
                "--drawings no: there is no folder 'no'; create it or name another",
            ),
        ):
            self.assert_mistake(["experiment", *words], sentence)
        self.assert_mistake(
            ["choose", "office"],
            "the following arguments are required: --max-error; dynrt choose --help lists what there "
            "is",
        )

    def test_another_build(self) -> None:
        old = "the sources have changed since this program was built; build it again"
        bound = ["choose", "office", "--max-error", "1"]
        for words in (bound, *(["experiment", name] for name in table.names())):
            self.assert_mistake(words, old)
        self.assert_mistake(
            bound,
            "measuring variants needs hlsc, CGAL and Embree, and scripts/demo built this program "
            "without; scripts/test --build-only builds the whole program",
            alone=True,
        )

    def test_an_experiment_that_is_not_there(self) -> None:
        result = testing.run(project.SCRIPTS / "experiment", "sweep")
        self.assertEqual(result.returncode, 2)
        self.assertIn("'sweep': unknown; the experiments are board, ", result.stderr)

    def test_a_target_that_cannot_be_built(self) -> None:
        with self.assertRaisesRegex(Failed, "sdram_frames cannot be built: .*[Ee]rror"):
            command.build_target(self.folder, "sdram_frames")


class Files(testing.InFolder):
    def test_names(self) -> None:
        for scene, name in (
            ("office", "office"),
            ("/a b/c d.gltf", "c_d"),
            ("maps.pk3:one", "maps_one"),
        ):
            self.assertEqual(output.scene_name(scene), name)

    def test_a_built_in_scene_goes_before_a_folder_of_its_name(self) -> None:
        (self.folder / "blocks").mkdir()
        for name in ("office", "ball.json", "maps.pk3"):
            (self.folder / name).touch()
        self.addCleanup(os.chdir, pathlib.Path.cwd())
        os.chdir(self.folder)
        here = pathlib.Path.cwd()
        for scene, path in (
            ("blocks", "blocks"),
            ("office", "office"),
            ("no.obj", "no.obj"),
            ("./ball.json", f"{here}/ball.json"),
            ("maps.pk3:mine", f"{here}/maps.pk3:mine"),
        ):
            self.assertEqual(output.scene_path(scene), path)

    def test_a_full_disk_leaves_the_report_that_was_there(self) -> None:
        out = self.folder / "out"
        with output.written_first(out) as new:
            (new / "error.csv").write_text("old", encoding="utf-8")
        with self.assertRaisesRegex(
            Failed,
            f"^--out {out}: cannot be written .the disk is full.; a report that was there is as",
        ):
            with output.written_first(out) as new:
                (new / "error.csv").write_text("new", encoding="utf-8")
                raise OSError(28, "No space left on device")
        self.assertEqual([p.name for p in out.iterdir()], ["error.csv"])
        self.assertEqual((out / "error.csv").read_text(encoding="utf-8"), "old")

    def test_two_that_write_at_once(self) -> None:
        out = self.folder / "out"
        for left in (".new999999999.cut", ".newest"):  # of a process that is no more; a user's own
            (out / left).mkdir(parents=True)
        with output.written_first(out) as first:
            (first / "a").touch()
            with output.written_first(out) as second:
                (second / "b").touch()
        self.assertEqual(sorted(p.name for p in out.iterdir()), [".newest", "a", "b"])

    def test_csv_has_every_key(self) -> None:
        lines: list[Json] = [{"scene": "a", "clocks": 1}, {"scene": "b", "use": 2}]
        output.write_csv(self.folder / "x.csv", lines)
        text = (self.folder / "x.csv").read_text(encoding="utf-8")
        self.assertEqual(text, "scene,clocks,use\na,1,\nb,,2\n")


if __name__ == "__main__":
    unittest.main()
