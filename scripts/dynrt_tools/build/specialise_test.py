# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""From a scene to the core made for it: its keys, that it renders the same bits, and what it
refuses. The class Command takes a minute, Cores takes many.

Usage: python3 -m dynrt_tools.build.specialise_test PROGRAM [CLASS]
"""

import json
import pathlib
import sys
import unittest

from dynrt_tools import project, testing

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SMALL = ("--size", "64x48")
# A ball that slides by, and for which a second core is too small once others are beside it.
BALL = {
    "objects": [
        {
            "name": "ball",
            "parts": [{"generate": "sphere", "radius": 1, "subdivisions": 2, "colour": [1, 1, 1]}],
        }
    ],
    "instances": [
        {
            "object": "ball",
            "name": "slides",
            "position": [0, 2, 0],
            "motion": {"keys": [{"time": 0}, {"time": 4, "position": [4, 2, 0]}]},
        }
    ],
    "camera": {"position": [0, 0, 20], "look_at": [0, 0, 0], "field_of_view": 40},
}


class Specialised(testing.InFolder):
    def run_program(self, *arguments: str) -> testing.Result:
        return testing.run(PROGRAM, *arguments, cwd=self.folder)

    def done(self, *arguments: str) -> str:
        result = self.run_program(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
        return result.stdout

    def read(self, name: str) -> project.Json:
        return dict(project.read_json(self.folder / name))

    def scene(self, name: str, **changes: object) -> str:
        (self.folder / name).write_text(json.dumps(BALL | changes), encoding="utf-8")
        return name

    def bits(self, name: str) -> bytes:
        return (self.folder / name).read_bytes()


class Command(Specialised):
    """The whole way once, with nothing measured but the clocks of a small frame."""

    def test_a_core_is_made(self) -> None:
        ball = self.scene("ball.json", instances=[{"object": "ball", "name": "stands"}])
        testing.write_tree(
            self.folder / "made",
            {
                "analysis.json": '{"verilog": ["old.v", "../mine.v"]}',
                "mine.v": "mine",
                "verilog/old.v": "of an earlier core",
                "verilog/mine.v": "mine",
            },
        )
        kept = ("--keep", "packets", "--keep=lines", "--size", "16x12", "--no-hardware")
        page = self.done(
            "specialise", ball, *kept, "--out", "made", "--json", "figures.json", "--max-slowdown=1"
        )
        self.assertRegex(page, r"\n  levels +2 +1 +the scene is one object that stands where it is")
        self.assertRegex(page, r"\n  clocks of a frame +[0-9,]+ +[0-9,]+ +[0-9.]+ %")
        stated, analysis = self.read("made/configuration.json"), self.read("made/analysis.json")
        self.assertEqual((stated["made_for"], stated["made_from"]), ("ball", "fast"))
        self.assertEqual(stated["packets"]["reason"], "as in fast: it was asked for")
        self.assertEqual(self.read("figures.json"), analysis)
        self.assertEqual(
            analysis["configuration"], {k: stated[k] for k in analysis["configuration"]}
        )
        self.assertIn("levels", analysis["left_out"])
        self.assertEqual(analysis["curves"], {"packets": {}, "lines": {}})
        for core in ("general", "special"):
            self.assertGreater(analysis["costs"][core]["clocks"], 100)
        verilog = {path.name for path in (self.folder / "made/verilog").iterdir()}
        self.assertEqual(verilog, {*analysis["verilog"], "mine.v"})
        self.assertLess({"dynrt_core.v", "dynrt_core.vh", "intersection.json"}, verilog)
        self.assertTrue((self.folder / "made/mine.v").exists())
        model = ("--board", "model", "--size", "16x12")
        special = ("--config", "made/configuration.json")
        self.done("render", ball, *model, *special, "--out", "special.png")
        self.done("render", ball, *model, "--out", "general.png")
        self.assertEqual(self.bits("special.png"), self.bits("general.png"))


class Cores(Specialised):
    def test_a_scene_of_one_object(self) -> None:
        page = self.done("specialise", "office", *SMALL, "--out", "made", "--no-hardware")
        self.assertIn("\n  levels", page)
        stated = self.read("made/configuration.json")
        self.assertEqual((stated["made_for"], stated["made_from"]), ("office", "fast"))
        for key, one in stated.items():
            if isinstance(one, dict):
                self.assertGreater(len(one["reason"]), 10, key)
        self.assertEqual(stated["levels"]["value"], 1)
        self.assertLess(stated["stack_depth"]["value"], 31)
        self.assertIn(
            f"pushes at most {stated['stack_depth']['value']}", stated["stack_depth"]["reason"]
        )
        analysis = self.read("made/analysis.json")
        self.assertEqual(max(map(int, analysis["curves"]["packets"])), 64)
        self.assertGreater(analysis["costs"]["special"]["clocks"], 1000)
        self.assertTrue((self.folder / "made/verilog/dynrt_core.v").is_file())

        model = ("--board", "model")
        self.done("render", "office", *SMALL, *model, "--specialise", "--out", "special.png")
        self.done("render", "office", *SMALL, *model, "--out", "general.png")
        self.assertEqual(self.bits("special.png"), self.bits("general.png"))

    def test_the_verilog_gives_the_general_cores_bits(self) -> None:
        said = self.done("compare", "lamps", *SMALL, "--specialise")
        self.assertRegex(
            said,
            "compared +3,072 hit records, 3,072 pixels, 0 counters of rtl and "
            "model: 0 \\+ 0 \\+ 0 differ",
        )

    def test_a_core_behind_a_port_gets_the_lines_that_suit_its_memory(self) -> None:
        behind = ("--config", "fast_port", "--memory-latency", "30")
        page = self.done("specialise", "office", *SMALL, *behind, "--out", "made", "--no-hardware")
        self.assertRegex(page, r"\n  line_nodes +1 +2")
        analysis, stated = self.read("made/analysis.json"), self.read("made/configuration.json")
        layouts = {int(n): costs for n, costs in analysis["layouts"].items()}
        self.assertGreater(len(layouts), 1)
        for costs in layouts.values():
            self.assertGreater(costs["bytes_per_ray"], 0)
        fewest = min(costs["clocks"] for costs in layouts.values())
        chosen = stated["line_nodes"]["value"]
        self.assertLessEqual(layouts[chosen]["clocks"], 1.02 * fewest)
        self.assertFalse(stated["counters"]["value"])
        self.assertLessEqual(
            analysis["costs"]["special"]["clocks"], 1.02 * layouts[chosen]["clocks"]
        )

    def test_frames_that_exceed_the_core(self) -> None:
        ball = self.scene("ball.json")
        balls = self.scene(
            "balls.json",
            instances=[
                {"object": "ball", "name": f"ball{i}", "position": [3 * i, 0, 0]} for i in range(40)
            ],
        )
        self.done(
            "walk",
            ball,
            *SMALL,
            "--frames",
            "3",
            "--board",
            "model",
            "--specialise",
            "--out",
            "frames",
        )
        self.done("specialise", ball, *SMALL, "--out", "made", "--no-hardware")
        mine = ("--board", "model", "--config", "made/configuration.json", *SMALL)
        refused = self.run_program("render", balls, *mine)
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(
            refused.stderr,
            "^dynrt: the scene 'balls' needs stack_depth [0-9]+, "
            "and configuration configuration, made for 'ball', has 1;",
        )
        said = self.done("render", balls, *mine, "--general-if-exceeded")
        self.assertIn("configuration fast", said)
        lit = self.run_program("render", ball, *mine, "--light", "0,5,9")
        self.assertEqual(lit.returncode, 2)
        self.assertIn("has no light rays; take --config whitted", lit.stderr)

    def test_frames_of_a_walk_that_exceed_the_core(self) -> None:
        spread = self.scene(
            "spread.json",
            instances=[
                {
                    "object": "ball",
                    "name": f"ball{i}",
                    "motion": {"keys": [{"time": 1}, {"time": 4, "position": [2 * i, 0, 0]}]},
                }
                for i in range(12)
            ],
        )
        self.done(
            "specialise",
            spread,
            *SMALL,
            "--to",
            "1",
            "--frames",
            "2",
            "--out",
            "made",
            "--no-hardware",
        )
        mine = (
            "walk",
            spread,
            "--board",
            "model",
            "--config",
            "made/configuration.json",
            *SMALL,
            "--frames",
            "3",
        )
        refused = self.run_program(*mine, "--out", "refused")
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(
            refused.stderr,
            "^dynrt: frame [12] of 3 needs stack_depth [0-9]+, "
            "and configuration .* has [0-9]+; .*--general-if-exceeded",
        )
        self.done(*mine, "--general-if-exceeded", "--out", "mixed", "--json", "mixed.json")
        general = [one.get("general", False) for one in self.read("mixed.json")["walk"]["frames"]]
        self.assertEqual((general[0], general[-1]), (False, True))
        self.done(*mine[:2], "--board", "model", *SMALL, "--frames", "3", "--out", "plain")
        for i in range(3):
            frame = f"frame_{i:04}.png"
            self.assertEqual(self.bits(f"mixed/{frame}"), self.bits(f"plain/{frame}"), i)


if __name__ == "__main__":
    unittest.main()
