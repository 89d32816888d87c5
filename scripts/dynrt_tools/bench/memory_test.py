# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The table of memories behind the port, from a stand-in for dynrt whose figures are known."""

import pathlib
import tempfile
import unittest
from unittest import mock

from dynrt_tools import testing
from dynrt_tools.bench import cores, memory
from dynrt_tools.bench.run import Dynrt, RunFailed
from dynrt_tools.docs.results import template_text
from dynrt_tools.project import ROOT, SCRIPTS, Json, read_json

CONFIGURATIONS = ROOT / "hls" / "configs" / "configs.json"

# A frame takes 1,000 clocks with SRAM and as many more as the latency has, less with pipelines.
STAND_IN = """#!/usr/bin/python3 -IS
import argparse, json, pathlib, sys
parser = argparse.ArgumentParser()
parser.add_argument("command")
parser.add_argument("scene")
for flag in ("schedule", "board", "config", "size", "out", "json", "memory-latency", "row-clocks"):
    parser.add_argument("--" + flag)
parser.add_argument("--no-hits", action="store_true", required=True)
a = parser.parse_args()
if a.scene == REFUSED:
    sys.exit("dynrt: the scene is refused")
keys = json.loads(pathlib.Path(a.config).read_text())
is_port = keys["like"] == "fast_port"
assert is_port == (a.memory_latency is not None) == (a.row_clocks is not None)
assert a.board == "model" and a.schedule.endswith(".schedules")
lowered = json.loads(pathlib.Path(a.schedule.removesuffix(".schedules")).read_text())
assert lowered.pop("counters", None) == (False if "pipelines" in keys else None) and lowered == keys
cycles = (1000 + int(a.memory_latency or 0) + int(a.row_clocks or 0)) // keys.get("pipelines", 1)
uses = {"slice_0": 0.75, "send_packet": 0.8, "transformation": 0.8, "step": 0.1}
caches = ["node", "list", "matrix"]
if is_port:
    uses["memory_gather"] = 0.25
    if keys.get("second_level", 64):
        caches.append("second")
width, height = map(int, a.size.split("x"))
frame = {"configuration": "loadable", "width": width, "height": height,
         "cycles": cycles if HAS_CLOCKS else None,
         "memory": {"bytes_read": width * height * 5},
         "units": {name: {"utilisation": use} for name, use in uses.items()},
         "caches": {name: {"hit_rate": 0.5} for name in caches}}
pathlib.Path(a.json).write_text(json.dumps({"frame": frame}))
"""


def no_build(_: pathlib.Path, config: pathlib.Path, *flags: str) -> pathlib.Path:
    """Stands for scripts/configuration."""
    return pathlib.Path(f"{config}.schedules") if flags == ("--verilog",) else config


def measured(
    folder: pathlib.Path, said: list[str], has_clocks: bool = True, refused: str = ""
) -> Json:
    """The data that frames of the stand-in give, and the progress that was shown."""
    with mock.patch.object(cores, "built", no_build):
        return memory.measure(Dynrt(stand_in(folder, has_clocks, refused)), "40x30", said.append)


def stand_in(folder: pathlib.Path, has_clocks: bool = True, refused: str = "") -> pathlib.Path:
    program = folder / "dynrt"
    text = STAND_IN.replace("HAS_CLOCKS", str(has_clocks)).replace("REFUSED", repr(refused))
    testing.write_program(program, text)
    return program


class Memory(unittest.TestCase):
    measured: Json
    said: list[str]

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.said = []
        cls.measured = measured(folder, cls.said)

    def test_figures(self) -> None:
        self.assertEqual(len(self.measured["frames"]), len(memory.ROWS) * len(memory.SCENES))
        frames = {(one["row"], one["scene"]): one for one in self.measured["frames"]}
        sram, slow = frames["fast", "office"], frames["latency 100", "office"]
        self.assertEqual((sram["clocks"], sram["rays per clock"]), (1000, 1.2))
        self.assertEqual((sram["port"], sram["second hits"]), (None, None))
        self.assertEqual((slow["clocks"], slow["port"], slow["second hits"]), (1100, 0.25, 0.5))
        self.assertEqual(slow[memory.SHARE], 1000 / 1100)
        self.assertEqual(slow["bytes read per ray"], 5)
        self.assertEqual((slow["busiest unit"], slow["use"]), ("transformation", 0.8))
        self.assertIsNone(slow[memory.PIPELINES])
        self.assertIsNone(frames["second_level 0", "office"]["second hits"])
        self.assertEqual(frames["row_clocks 10", "office"]["clocks"], 1040)
        self.assertEqual(frames["pipelines 2", "office"][memory.PIPELINES], 2)

    def test_aims(self) -> None:
        found = {(one["row"], one["figure"], one["scene"]): one for one in self.measured["aims"]}
        self.assertEqual(len(found), 18)
        one = found["latency 30", memory.SHARE, "office"]
        self.assertEqual((one["asked"], one["verdict"]), (0.97, "reached"))
        self.assertEqual(found["pipelines 4", memory.PIPELINES, "cistern"]["verdict"], "reached")
        one = found["latency 30", memory.READ, "office"]
        self.assertEqual((one["asked"], one["reached"], one["verdict"]), (5.5, 5, "reached"))
        for row in ("latency 30", "second_level 128"):
            self.assertEqual(found[row, memory.READ, "cistern"]["verdict"], "missed")

    def test_the_table_has_a_line_for_each_row_and_scene(self) -> None:
        text = memory.table(self.measured)
        lines = text.splitlines()
        self.assertEqual(
            len(lines), 1 + len(self.measured["frames"]) + 2 + len(self.measured["aims"])
        )
        self.assertRegex(lines[1], r"^fast +office +1,000 +1\.2000 +100\.0% +5\.00 .* -  transf")
        self.assertRegex(text, r"\npipelines 2 +office .* x2\.00 ")
        self.assertRegex(
            text, r"\nlatency 30 +office +share of SRAM: 97\.0% or more, is 97\.1%: reached"
        )
        self.assertRegex(
            text, r"\nlatency 30 +office +bytes read per ray: 5\.50 or less, is 5\.00: reached"
        )

    def test_names_and_progress(self) -> None:
        names = [row.name for row in memory.ROWS]
        self.assertEqual(len(set(names)), len(names))
        self.assertIn(f"core of fast, row 1 of {len(names)}", self.said)
        self.assertIn(f"frame {4 * len(names)} of {4 * len(names)}", self.said[-1])

    def test_the_rows_have_the_keys_of_fast_port(self) -> None:
        listed = {one["name"]: one for one in read_json(CONFIGURATIONS)}
        for row in memory.ROWS:
            self.assertIn(row.like, listed)
            for key, value in row.keys:
                self.assertNotEqual(listed[memory.PORT].get(key), value, row.name)

    def test_the_page_has_the_rows_and_the_keys_of_fast_port(self) -> None:
        page = template_text("memory")
        listed = {one["name"]: one for one in read_json(CONFIGURATIONS)}
        for row in memory.ROWS:
            self.assertIn(f"memory:frames/{row.name}+", page)
            for key, _ in row.keys:
                if key != "pipelines":
                    self.assertIn(f"`{key}` {listed[memory.PORT][key]}", page)


class Refusals(testing.InFolder):
    def test_refusals_are_sentences(self) -> None:
        with self.assertRaisesRegex(RunFailed, "dynrt: the scene is refused"):
            measured(self.folder, [], refused="trees4000")
        with self.assertRaisesRegex(RunFailed, "the frame of loadable has no clocks"):
            measured(self.folder, [], has_clocks=False)

    def test_the_command_names_what_is_missing(self) -> None:
        result = testing.run(SCRIPTS / "bench", "--memory", "--program", stand_in(self.folder))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^bench: configuration: .*: no build is at ")
        self.assertEqual(result.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
