# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The tables of a board whose memory is an SDRAM, from stand-ins for dynrt and for the programs that
render with the SDRAM, whose figures are known."""

import pathlib
import tempfile
import unittest
from unittest import mock

from dynrt_tools import testing
from dynrt_tools.bench import board, board_levers, cores
from dynrt_tools.bench.run import Dynrt, RunFailed
from dynrt_tools.docs.results import template_text
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import ROOT, SCRIPTS, Json, read_json

SIZE, RAYS = "40x30", 40 * 30

# A frame with SRAM takes 1,000 clocks.
DYNRT = """#!/usr/bin/python3 -IS
import json, pathlib, sys
assert sys.argv[1] == "render" and "--no-hits" in sys.argv and sys.argv[2] != REFUSED, sys.argv
units = {"node_fetch": {"utilisation": 0.9}, "list": {"utilisation": 0.4}}
frame = {"cycles": 1000 if HAS_CLOCKS else None, "width": 40, "height": 30, "units": units}
pathlib.Path(sys.argv[sys.argv.index("--json") + 1]).write_text(json.dumps({"frame": frame}))
"""

# With the SDRAM it takes a quarter more, and 600 more in trees4000: half of the chip's clocks move
# words, a quarter find no burst. A core reads as many bytes as its name has letters, per ray.
FRAMES = """#!/usr/bin/python3 -IS
import argparse, json, pathlib, sys
parser = argparse.ArgumentParser()
parser.add_argument("scene")
for flag in ("size", "core-mhz", "sdram-mhz", "schedule", "json"):
    parser.add_argument("--" + flag, required=True)
parser.add_argument("--no-display", action="store_true")
a = parser.parse_args()
if a.scene == REFUSED:
    sys.exit("sdram_frames: the scene is refused")
core = pathlib.Path(sys.argv[0]).name.removeprefix("sdram_frames_")
assert pathlib.Path(a.schedule).name == core, a.schedule
cycles = 1250 + 600 * (a.scene == "trees4000")
microseconds = cycles / float(a.core_mhz)
clocks = int(microseconds * (1000 / 7.5 if a.sdram_mhz == "133" else int(a.sdram_mhz)))
rays, width = 1200, len(core)
sdram = {"clocks": clocks, "busy": clocks / 2, "idle": clocks / 4, "activations": 30, "bursts": 40,
         "refreshes": 2, "refresh_clocks": 12, "reads": 10, "read_nanoseconds": 5000,
         "bytes_read": width * rays, "node_bytes_read": 3 * rays, "list_bytes_read": 2 * rays,
         "matrix_bytes_read": (width - 5) * rays, "bytes_written": 2 * rays,
         "bytes_displayed": 30 * microseconds, "late_display_reads": 0}
units = {"node_fetch": {"utilisation": 0.7, "stalled": 0},
         "list": {"utilisation": 0.3, "stalled": 0.2},
         "memory_lookup": {"utilisation": 0.95, "stalled": 0.1}}
frame = {"cycles": cycles, "width": 40, "height": 30, "sdram": sdram, "units": units,
         "caches": {"second": {"hit_rate": 0.5}}}
pathlib.Path(a.json).write_text(json.dumps(frame))
"""


def stand_ins(folder: pathlib.Path, has_clocks: bool = True, refused: str = "") -> Dynrt:
    """A build with the program and those of the cores."""
    text = DYNRT.replace("HAS_CLOCKS", str(has_clocks)).replace("REFUSED", repr(""))
    testing.write_program(folder / "dynrt", text)
    programs = folder / "verif" / "sdram"
    programs.mkdir(parents=True)
    for core in (
        "fast_port",
        "fast_ulx3s",
        *(lever["name"] for lever in read_json(board_levers.LEVERS)),
    ):
        path = programs / f"sdram_frames_{core}"
        testing.write_program(path, FRAMES.replace("REFUSED", repr(refused)))
    return Dynrt(folder / "dynrt")


def no_build(_: pathlib.Path, target: str) -> None:
    """Stands for cmake."""
    assert target in ("sdram_frames", "sdram_frames_levers")


def no_verilog(_: pathlib.Path, config: pathlib.Path, *flags: str) -> pathlib.Path:
    """Stands for scripts/configuration."""
    assert flags == ("--verilog",) and read_json(config)["like"] == "fast_port"
    return pathlib.Path("kept", config.stem)


class Frames(unittest.TestCase):
    measured: Json
    said: list[str]

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.said = []
        with mock.patch.object(board, "build", no_build):
            cls.measured = board.measure(stand_ins(folder), "ulx3s", SIZE, cls.said.append)

    def frame(self, system: str, scene: str) -> Json:
        frames = self.measured["frames"]
        return next(f for f in frames if (f["system"], f["scene"]) == (system, scene))

    def test_frames(self) -> None:
        self.assertEqual(len(self.measured["frames"]), 2 * 4)
        office = self.frame("placed", "office")
        mhz = placed_clocks.of("fast").mhz
        self.assertEqual(office["core_hz"], mhz * 1e6)
        self.assertEqual(office["share of SRAM"], 0.8)
        self.assertEqual(self.frame("placed", "trees4000")["share of SRAM"], 1000 / 1850)
        self.assertEqual(office["bytes read per ray"], len("fast_port"))
        self.assertEqual(office["matrix bytes per ray"], len("fast_port") - 5)
        self.assertEqual(office["bytes written per ray"], 2)
        self.assertAlmostEqual(office["MB per second read"], 9 * RAYS / 1250 * mhz)
        self.assertAlmostEqual(office["MB per second displayed"], 30)
        self.assertAlmostEqual(office["reads under way"], 5 * mhz / 1250)
        self.assertEqual(self.frame("own", "office")["core_hz"], 62.5e6)

    def test_what_waits(self) -> None:
        office = self.frame("placed", "office")
        shares = ("share of the peak", "waits for the core", "waits for rows and turns")
        self.assertEqual([office[name] for name in shares], [0.5, 0.25, 0.25])
        self.assertEqual((office["rows opened per burst"], office["ns of a read"]), (0.75, 500))
        self.assertEqual((office["busiest unit"], office["use"]), ("node_fetch", 0.7))
        self.assertEqual(office["use with SRAM"], 0.9)
        self.assertEqual((office["stalled unit"], office["stalled"]), ("list", 0.2))

    def test_the_budget_limits_the_aims(self) -> None:
        budget = {row["scene"]: row for row in self.measured["budget"] if row["system"] == "placed"}
        office, cistern, trees = (budget[s] for s in ("office", "cistern", "trees4000"))
        mhz = placed_clocks.of("fast").mhz
        asked = (9 + 2) * RAYS / 1000 * mhz
        self.assertAlmostEqual(office["peak"], 2000 / 7.5, delta=0.5)
        self.assertAlmostEqual(office["read"] + office["written"], asked)
        self.assertAlmostEqual(office["sum"], asked + 30 + office["refresh"])
        room = 0.85 * office["peak"] - 30 - office["refresh"]
        self.assertAlmostEqual(office["reachable"], room / asked)
        self.assertLess(office["reachable"], 0.7)
        self.assertEqual(office["aim"], office["reachable"])
        self.assertEqual((office["verdict"], cistern["verdict"]), ("reached", "reached"))
        self.assertEqual((trees["aim"], trees["verdict"]), (None, "no aim"))

    def test_each_system_has_a_budget(self) -> None:
        own = [row for row in self.measured["budget"] if row["system"] == "own"]
        self.assertEqual({row["verdict"] for row in own}, {"no aim"})
        self.assertEqual(len(own), 4)
        for row in own:
            self.assertAlmostEqual(row["peak"], 200, delta=0.5)

    def test_the_verilog_is_beside_it(self) -> None:
        self.assertEqual(
            self.measured["verilog"],
            [
                {"scene": scene, "clocks of the Verilog": 1000, "clocks here": 1250}
                for scene in ("office", "conference")
            ],
        )

    def test_an_aim_that_is_missed(self) -> None:
        frame = {**self.frame("placed", "office"), "bytes read per ray": 0.1}
        fixed = {"peak": 266.0, "displayed": 37.0, "refresh": 3.0}
        row = board.budget_of({**frame, "bytes written per ray": 0.1}, fixed, 0.9)
        self.assertEqual((row["reachable"], row["aim"], row["verdict"]), (1, 0.9, "missed"))

    def test_the_table_has_each_frame(self) -> None:
        text = board.table(self.measured)
        self.assertRegex(
            text, r"\noffice .* 80\.0% +9\.00 +2\.00 .* node_fetch 70\.0%, with SRAM 90"
        )
        self.assertRegex(
            text, r"\nown: the clocks and the core of rtl/ulx3s: core 62\.5 MHz, SDRAM 100 MHz\n"
        )
        self.assertEqual(text.count("trees4000 "), 4)
        self.assertTrue(any("frame 12 of 12" in said for said in self.said))

    def test_the_page_has_all(self) -> None:
        page = template_text("boards")
        for frame in self.measured["frames"]:
            self.assertIn(f"{{{{board:frames/{frame['system']}+{frame['scene']}/", page)


class Levers(unittest.TestCase):
    def test_each_changes_one_key_of_fast_port(self) -> None:
        listed = {one["name"]: one for one in read_json(ROOT / "hls" / "configs" / "configs.json")}
        page = template_text("boards")
        for lever in read_json(board_levers.LEVERS):
            key, value = board_levers.key_of(lever)
            self.assertEqual((lever["like"], lever["name"]), ("fast_port", f"{key}_{value}"))
            self.assertNotEqual(listed["fast_port"].get(key), value, lever["name"])
            self.assertIn(f"board_levers:levers/{lever['name']}+", page)

    def test_figures(self) -> None:
        said: list[str] = []
        with (
            tempfile.TemporaryDirectory() as folder,
            mock.patch.object(board, "build", no_build),
            mock.patch.object(cores, "built", no_verilog),
        ):
            dynrt = stand_ins(pathlib.Path(folder))
            measured = board_levers.measure(dynrt, "ulx3s", SIZE, said.append)
        rows = {(row["lever"], row["scene"]): row for row in measured["levers"]}
        self.assertEqual(len(rows), 3 * (1 + len(read_json(board_levers.LEVERS))))
        base, row = rows["fast_port", "office"], rows["second_level_128", "office"]
        self.assertEqual((base["key"], base["times the frames"]), (None, 1))
        self.assertEqual((row["key"], row["value"]), ("second_level", 128))
        self.assertEqual(row["bytes read per ray"], len("second_level_128"))
        self.assertEqual(row["times the bytes"], len("second_level_128") / len("fast_port"))
        text = board_levers.table(measured)
        self.assertEqual(len(text.splitlines()), 2 + len(read_json(board_levers.LEVERS)))
        self.assertRegex(text, r"\nsecond_level_128 +16\.00 B +\d+\.\d/s x1\.000 ")


class Refusals(testing.InFolder):
    def test_refusals_are_sentences(self) -> None:
        (self.folder / "a").mkdir()
        (self.folder / "b").mkdir()
        said: list[str] = []
        with mock.patch.object(board, "build", no_build):
            for dynrt, sentence in (
                (stand_ins(self.folder / "a", refused="office"), "the scene is refused"),
                (stand_ins(self.folder / "b", has_clocks=False), "the frame of fast has no clocks"),
            ):
                with self.assertRaisesRegex(RunFailed, sentence):
                    board.measure(dynrt, "ulx3s", SIZE, said.append)

    def test_a_build_that_fails(self) -> None:
        with self.assertRaisesRegex(RunFailed, "sdram_frames cannot be built: .*[Ee]rror"):
            board.build(self.folder, "sdram_frames")

    def test_other_boards(self) -> None:
        for flag in ("--board", "--board-levers"):
            result = testing.run(SCRIPTS / "bench", flag, "ulx4")
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"{flag} ulx4: unknown; the boards are ulx3s", result.stderr)


if __name__ == "__main__":
    unittest.main()
