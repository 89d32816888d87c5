# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Hardware reports whole, from the command line to the files, with programs that only pretend."""

import csv
import json
import pathlib
import unittest

from dynrt_tools import project, testing
from dynrt_tools.build import configs
from dynrt_tools.hardware_report import collect, example
from dynrt_tools.hardware_report.report_case import ALL_FRAMES, FRAMES, Case


class Reports(Case):
    def test_from_the_flags_to_the_files(self) -> None:
        data, pictures = self.folder / "data.json", self.folder / "pictures"
        pictures.mkdir()
        given = {"json": data, "drawings": pictures, "figure": []}
        self.assertEqual(self.run_report("blocks", "lamps", **given), (0, ""))
        made = self.made()
        self.assertEqual(len(made["runs"]), 2 * (ALL_FRAMES + 1))
        self.assertEqual(project.read_json(data), made)
        with (self.out / "hardware.csv").open(encoding="utf-8") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual(len(lines), len(made["runs"]))
        first = lines[0]
        self.assertEqual((first["scene"], first["configuration"]), ("blocks", "narrow"))
        self.assertEqual((first["packets"], first["lines"]), ("2", "2"))
        wide = next(r for r in made["table"] if r["configuration"] == "wide")
        self.assertAlmostEqual(wide["QGHW"], 1e6 * (768 / 19200) / (1040 + 860))
        fewer = next(r for r in made["runs"] if r["flags"]["packets"] == 1)
        self.assertAlmostEqual(fewer["QGHW"], 1e6 * (768 / 76800) / (1010 + 260))
        drawings = sorted(path.name for path in self.out.glob("*.svg"))
        self.assertEqual(len(drawings), 7)
        self.assertIn("figure_7_6.svg", drawings)
        self.assertEqual(sorted(path.name for path in pictures.iterdir()), drawings)

    def test_renders_what_is_not_there_yet(self) -> None:
        self.run_report("blocks")
        # Three cores of the curves, one of the table, and their gates.
        self.assertEqual(len(self.ran()), 8 + FRAMES + 1)
        self.run_report("blocks")
        self.assertEqual(self.ran(), [])
        self.run_report("blocks", "lamps")
        self.assertEqual(len(self.ran()), FRAMES + 1)
        self.assertTrue(all(line.startswith("lamps ") for line in self.ran()))
        self.run_report("blocks", size="64x48")
        self.assertEqual(len(self.ran()), FRAMES + 1)
        self.run_report("blocks")
        self.assertEqual(self.ran(), [])
        self.program.write_text(self.program.read_text() + "# changed\n", encoding="utf-8")
        self.run_report("blocks")
        self.assertEqual(len(self.ran()), 8 + FRAMES + 1)

    def test_a_file_that_changes_is_rendered_again(self) -> None:
        ball = self.folder / "ball.obj"
        ball.write_text("v 0 0 0", encoding="utf-8")
        self.assertEqual(self.run_report(str(ball), "blocks"), (0, ""))
        ball.write_text("v 1 1 1", encoding="utf-8")
        self.assertEqual(self.run_report(str(ball), "blocks"), (0, ""))
        self.assertEqual(len(self.ran()), FRAMES + 1)
        self.assertTrue(all(line.startswith(str(ball)) for line in self.ran()))

    def test_frames_that_die_are_named_and_the_rest_is_there(self) -> None:
        self.work.mkdir()
        (self.work / "fail").write_text("", encoding="utf-8")
        code, said = self.run_report("blocks")
        self.assertEqual(code, 1)
        self.assertEqual(
            said.splitlines(),
            [
                "dynrt: missing: blocks.wide.packets-1_lines-2_order-morton: rendering failed: the "
                "frame is lost",
                "dynrt: missing: blocks, wide: 1 of 6 walks",
            ],
        )
        made = self.made()
        self.assertEqual(len(made["runs"]), FRAMES)
        page = (self.out / "hardware.html").read_text(encoding="utf-8")
        self.assertIn("rendering failed: the frame is lost", page)
        (self.work / "fail").unlink()
        self.assertEqual(self.run_report("blocks"), (0, ""))
        self.assertEqual(len(self.ran()), 1)
        self.assertEqual(self.made()["missing"], [])

    def test_a_frame_that_is_killed_is_named_too(self) -> None:
        self.work.mkdir()
        (self.work / "kill").write_text("", encoding="utf-8")
        code, said = self.run_report("blocks")
        self.assertEqual(code, 1)
        self.assertEqual(
            said.splitlines(),
            [
                "dynrt: missing: blocks.wide.packets-1_lines-2_order-morton: rendering failed: it "
                "ended without a word, as a program does that is killed",
                "dynrt: missing: blocks, wide: 1 of 6 walks",
            ],
        )
        self.assertEqual(len(self.made()["runs"]), FRAMES)

    def test_what_an_earlier_program_made_does_not_count(self) -> None:
        self.assertEqual(self.run_report("blocks"), (0, ""))
        self.program.write_text(self.program.read_text() + "# changed\n", encoding="utf-8")
        (self.work / "fail_configuration").write_text("", encoding="utf-8")
        code, said = self.run_report("blocks")
        self.assertEqual(code, 2)
        self.assertRegex(
            said,
            r"^dynrt: there is no walk to report; [\w-]+: lowering its units failed: configuration: "
            "this unit cannot be lowered\n$",
        )
        # The report that was there is as it was.
        self.assertEqual(len(self.made()["runs"]), FRAMES + 1)

    def test_a_scene_that_is_not_known(self) -> None:
        self.assertEqual(
            self.run_report("castle"),
            (2, "dynrt: castle: unknown scene; the scenes are blocks, lamps\n"),
        )
        self.assertFalse(self.work.exists())

    def test_configurations(self) -> None:
        code, said = self.run_report("blocks", config=["slow"])
        names = ", ".join(configs.load_configurations().listed())
        self.assertEqual(
            (code, said),
            (2, f"dynrt: --config slow: unknown; the configurations are {names}\n"),
        )
        bare = self.folder / "bare.json"
        bare.write_text('{"like": "thesis", "counters": false}', encoding="utf-8")
        sentence = (
            "it counts nothing, so nobody can tell the use of its units; set counters to true\n"
        )
        for listed in ("config", "table"):
            code, said = self.run_report("blocks", **{listed: [str(bare)]})
            self.assertEqual((code, said), (2, f"dynrt: --config {bare}: {sentence}"))
        (self.folder / "other").mkdir()
        other = self.folder / "other" / "wide.json"
        other.write_text('{"like": "thesis"}', encoding="utf-8")
        code, said = self.run_report("blocks", table=[str(other)])
        self.assertEqual(code, 2)
        self.assertIn("another configuration of this report is named 'wide'", said)

    def test_places_that_are_none(self) -> None:
        for flag, path, sentence in (
            ("json", "no/where.json", "create it or name a file elsewhere"),
            ("drawings", "no", "create it or name another"),
        ):
            code, said = self.run_report("blocks", **{flag: pathlib.Path(path)})
            self.assertEqual(code, 2)
            self.assertEqual(said, f"dynrt: --{flag} {path}: there is no folder 'no'; {sentence}\n")

    def test_frames_of_a_walk(self) -> None:
        self.assertEqual(self.run_report("blocks", figure=["7.9"], frames=2), (0, ""))
        self.assertEqual(self.made()["frames"], 2)
        (own,) = [r for r in self.made()["table"] if r["configuration"] == "wide"]
        # The mean of 19,199 and 19,201 clocks.
        self.assertEqual(own["clocks"], 19200)
        slowest = own["slowest frame, per second at 85 MHz"]
        self.assertAlmostEqual(slowest, 85e6 / 19201)
        # Another number of frames is another measurement, and the first stays.
        self.assertEqual(self.run_report("blocks", figure=["7.9"], frames=3), (0, ""))
        self.assertEqual(len(self.ran()), 4)
        self.assertEqual(self.run_report("blocks", figure=["7.9"], frames=2), (0, ""))
        self.assertEqual(self.ran(), [])
        self.assertEqual(
            self.run_report("blocks", frames=0),
            (2, "dynrt: --frames 0: a report's walk has 1 to 100 frames\n"),
        )

    def test_another_build(self) -> None:
        code, said = self.run_report("blocks", expect="f")
        self.assertEqual(
            (code, said),
            (2, "dynrt: the sources have changed since this program was built; build it again\n"),
        )

    def test_the_command(self) -> None:
        given = ("--program", self.program, "--build", self.build, "--expect", "f")
        result = testing.run(project.SCRIPTS / "report_hardware", *given, "--colour")
        self.assertEqual(
            (result.returncode, result.stderr),
            (
                2,
                "dynrt: unrecognized arguments: --colour; dynrt report hardware --help lists what "
                "there is\n",
            ),
        )

    def test_the_json_has_a_line_for_each_run(self) -> None:
        path = self.folder / "one.json"
        collect.write_json(path, example.report())
        text = path.read_text(encoding="utf-8")
        self.assertEqual(json.loads(text), example.report())
        rows = sum(len(example.report()[name]) for name in ("runs", "table", "findings"))
        self.assertEqual(text.count('\n    {"scene":'), rows)


if __name__ == "__main__":
    unittest.main()
