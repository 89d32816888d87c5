# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place does around a placer: a stand-in for nextpnr writes reports that are kept
here, or fails in the ways that a placer can."""

import argparse
import contextlib
import errno
import functools
import gzip
import io
import json
import os
import pathlib
import shutil
import tempfile
import unittest
from collections.abc import Callable, Sequence

from typing import Any
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import (
    block_registers,
    kept_placement,
    model_file,
    place,
    placers,
    placing,
    rtl_files,
    synthesis,
)
from dynrt_tools.hardware.worst_paths_test import SDF
from dynrt_tools.project import Json

UNIT = """\
module sum (input clk_i, input rst_ni, input [3:0] a_i, input [3:0] b_i, output [4:0] sum_o);
  reg [4:0] sum_q;
  always @(posedge clk_i) sum_q <= rst_ni ? a_i + b_i : 5'd0;
  assign sum_o = sum_q;
endmodule
"""
# Writes the SDF file of worst_paths_test and a report as nextpnr 0.11 writes it. MODE says how it
# differs; a mode with a seed, as "no route:2", is that seed's alone.
STAND_IN = """#!/usr/bin/python3
import json, os, sys, time
args = sys.argv[1:]
if args == ["--version"]:
    sys.exit("nextpnr-ecp5 -- Next Generation Place and Route (Version " + os.environ["VERSION"] + ")")
value = {a: b for a, b in zip(args, args[1:]) if a.startswith("--")}
mode, _, seed = os.environ["MODE"].partition(":")
if seed and seed != value["--seed"]:
    mode = ""
with open(os.environ["RUNS"], "a") as runs:
    runs.write(json.dumps(args) + "\\n")
if mode == "no route":
    sys.exit("Info: routing\\nERROR: Failed to route arc 3 of net 'a', from X1Y2 to X3Y4.")
if mode == "full":
    sys.exit("ERROR: Unable to place cell 'x', no Bels remaining of type 'TRELLIS_COMB'")
if mode == "slow":
    time.sleep(30)
asked = 125.0 if mode == "deaf" else float(value["--freq"])
achieved = 1000 / (7.5 if mode == "other delays" else 4.1)
report = {
    "utilization": {"TRELLIS_COMB": {"used": 40, "available": 83640}},
    "fmax": {"clk": {"achieved": achieved, "constraint": asked}},
    "critical_paths": [],
}
if mode == "other report":
    del report["fmax"]
if mode != "silent":
    json.dump(report, open(value["--report"], "w"))
if mode != "no delays":
    open(value["--sdf"], "w").write(open(os.environ["SDF"]).read())
"""


class StandIn(unittest.TestCase):
    def setUp(self) -> None:
        self.delay: Json = {}  # the model of a row that is no core
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        program = self.bin / "nextpnr-ecp5"
        program.write_text(STAND_IN, encoding="utf-8")
        program.chmod(0o755)
        for name, text in (("timing.sdf", SDF), ("sum.v", UNIT), ("wide.v", UNIT)):
            text = text.replace("module sum", f"module {name.removesuffix('.v')}")
            (self.folder / name).write_text(text, encoding="utf-8")

    def called(
        self,
        mode: str = "",
        version: str = "nextpnr-0.11",
        names: Sequence[str] = ("sum",),
        without: bool = False,
        timing: Callable[..., float] = lambda module, files: 2.5,
        **flags: Any,
    ) -> tuple[int, str, str, Json]:
        """Exit code, output, errors and data of a call; `without` the placer on the PATH."""
        environment = {
            "PATH": "/usr/bin:/bin" if without else f"{self.bin}:{os.environ['PATH']}",
            "RUNS": str(self.folder / "runs"),
            "MODE": mode,
            "SDF": str(self.folder / "timing.sdf"),
            "VERSION": version,
        }
        data = self.folder / "place.json"
        args: Json = {
            "unit": list(names),
            "device": "ecp5-85",
            "config": rtl_files.CHECKED_IN,
            "grade": "",
            "clock_ns": 10.0,
            "ask_mhz": None,
            "seeds": 3,
            "copies": 1,
            "paths": 3,
            "timeout": 1.0,
            "build": None,
            "jobs": 1,
            "json": data,
            "record": self.folder / "record.json",
            "keep": None,
        } | flags
        synthesis.tool_version.cache_clear()
        output, errors = io.StringIO(), io.StringIO()
        with mock.patch.dict(os.environ, environment), mock.patch.object(
            synthesis, "KEPT", self.folder / "kept"
        ), mock.patch.object(
            place, "parse", functools.partial(argparse.Namespace, **args)
        ), mock.patch.object(
            place, "chosen", lambda _: (list(names), None)
        ), mock.patch.object(
            place, "prepare", self.prepare
        ), mock.patch.object(
            placing, "logic_delay", timing
        ), contextlib.redirect_stdout(
            output
        ), contextlib.redirect_stderr(
            errors
        ):
            code = place.main()
        synthesis.tool_version.cache_clear()
        return code, output.getvalue(), errors.getvalue(), project.read_json(data)

    def prepare(self, name: str, args: argparse.Namespace, _: object) -> place.Row:
        subject = placing.Subject(name, [self.folder / f"{name}.v"], args.copies)
        data = {"unit": name, "stages": 2, "longest_path_ns": 3.0, **self.delay}
        return place.Row(name, data, subject)

    def runs(self) -> list[list[str]]:
        path = self.folder / "runs"
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        return [json.loads(line) for line in lines]

    def test_a_row_with_its_paths(self) -> None:
        code, output, errors, data = self.called()
        self.assertEqual((code, errors), (0, ""))
        self.assertTrue((self.folder / "kept" / data["units"][0]["placed"][0]["run"]).is_dir())
        self.assertRegex(output, r"sum +2 +3.00 +40 +244 +244 to 244 +4.10 +137 %")
        record = project.read_json(self.folder / "record.json")
        shown = {"stages": 2, "predicted, ns": 3.0, "cells": 40, "ends too slow": 0}
        shown |= {
            "MHz, median": 244,
            "range low": 244,
            "range high": 244,
            "placed, ns": 4.1,
            "of predicted": 137,
        }
        self.assertEqual(record["units"], {"sum": shown})
        self.assertEqual(record["lowered"], {"units": 1, "of": 1, "stages": 2})
        self.assertIn("4.10 ns = 1.10 logic + 3.00 wires, 2 levels, 1 ends", output)
        (row,) = data["units"]
        self.assertEqual([p["seed"] for p in row["placed"]], [1, 2, 3])
        placed = row["placed"][0]
        self.assertEqual((placed["placer"], placed["too_slow"]), ("nextpnr-0.11", 0))
        self.assertEqual(len(placed["paths"][0]["hops"]), 4)
        self.assertTrue(placed["netlist"])

    def test_a_placement_is_kept(self) -> None:
        source = self.folder / "sum.v"
        source.write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", encoding="utf-8")
        self.called(keep=str(self.folder / "{unit}.json"))
        kept = kept_placement.read(self.folder / "sum.json")
        shown = {key: kept[key] for key in ("unit", "device", "grade", "copies", "placer", "seeds")}
        self.assertEqual(
            shown,
            {
                "unit": "sum",
                "device": "ecp5-85",
                "grade": "6",
                "copies": 1,
                "placer": "nextpnr-0.11",
                "seeds": 3,
            },
        )
        self.assertEqual(kept["clock_ns"], 3.5)
        self.assertEqual(kept["model"], self.model("ecp5.json"))
        self.assertAlmostEqual(kept_placement.period(kept), 4.1, delta=0.01)
        self.assertEqual(kept["verilog"], kept_placement.hash_of("sum", [source]))
        (end,) = kept_placement.that_limit(kept)
        self.assertEqual((end["ns"], end["median"]), ([4.1, 4.1, 4.1], 4.1))

    @staticmethod
    def model(name: str) -> dict[str, float]:
        return model_file.constants(project.ROOT / "hls/compiler/delay" / name)

    def test_what_is_kept_has_the_model_that_its_row_was_lowered_by(self) -> None:
        (self.folder / "sum.v").write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", "utf-8")
        self.delay = {"delay": "hls/compiler/delay/ecp5-8.json"}
        self.called(seeds=1, grade="8", keep=str(self.folder / "{unit}.json"))
        kept = kept_placement.read(self.folder / "sum.json")
        self.assertEqual(kept["model"], self.model("ecp5-8.json"))

    def test_a_row_that_cannot_be_kept_leaves_the_others(self) -> None:
        (self.folder / "sum.v").write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", "utf-8")
        code, output, errors, data = self.called(
            names=("wide", "sum"), seeds=1, keep=str(self.folder / "{unit}.json")
        )
        self.assertEqual(code, 1)
        self.assertEqual(
            errors,
            "place: wide is placed and not kept: no unit is among the files; their periods would be "
            "in their heads\nplace: not kept are wide\n",
        )
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertTrue(data["complete"])
        self.assertEqual(kept_placement.read(self.folder / "sum.json")["unit"], "sum")
        self.assertFalse((self.folder / "wide.json").exists())

    def test_clock_and_grade_reach_the_placer(self) -> None:
        for asked, mhz, grade in ((None, "100.0000", "6"), (120.0, "120.0000", "8")):
            self.called(seeds=1, ask_mhz=asked, grade=grade)
            run = self.runs()[-1]
            self.assertEqual(run[run.index("--freq") + 1], mhz)
            self.assertEqual(run[run.index("--speed") + 1], grade)

    def test_a_placer_that_places_for_another_clock_is_an_error(self) -> None:
        code, _, errors, data = self.called("deaf", seeds=1)
        self.assertEqual(code, 1)
        self.assertIn("was asked for 100.00 MHz and placed for 125.00 of clk", errors)
        self.assertEqual(data["units"][0]["placed"], [])

    def test_a_placement_is_not_repeated(self) -> None:
        first = self.called()[3]
        self.assertEqual(len(self.runs()), 3)
        self.assertEqual(self.called()[3], first)
        self.assertEqual(len(self.runs()), 3)

    def test_what_decides_a_placement_makes_it_new(self) -> None:
        self.called(seeds=1)
        changes: list[Json] = [
            {"grade": "8"},
            {"ask_mhz": 120.0},
            {"version": "nextpnr-0.12"},
            {"copies": 2},
        ]
        for number, flags in enumerate(changes, 2):
            self.called(seeds=1, **flags)
            self.assertEqual(len(self.runs()), number, flags)
        with mock.patch.object(placers, "constraints_text", lambda device: "other"):
            self.called(seeds=1)
        self.assertEqual(len(self.runs()), 6)
        with mock.patch.dict(placers.PLACERS["ecp5-85"], flags=["--85k"]):
            self.called(seeds=1)
        self.assertEqual(len(self.runs()), 7)
        self.write_unit("a_i - b_i")
        self.called(seeds=1)
        self.assertEqual(len(self.runs()), 8)

    def test_verilog_of_the_same_netlist_is_not_placed_again(self) -> None:
        first = self.called(seeds=1)[3]
        self.write_unit("\n(a_i + b_i)")
        second = self.called(seeds=1)[3]
        self.assertEqual(len(self.runs()), 1)
        runs = [data["units"][0]["placed"][0].pop("run") for data in (first, second)]
        self.assertNotEqual(*runs)  # the lines of its paths are those of the text
        self.assertEqual(
            first["units"][0]["placed"][0]["mhz"], second["units"][0]["placed"][0]["mhz"]
        )

    def test_another_packer_makes_the_netlist_new(self) -> None:
        first = self.called(seeds=1)[3]
        with mock.patch.object(block_registers, "version", lambda: "another"):
            second = self.called(seeds=1)[3]
        self.assertNotEqual(*(d["units"][0]["placed"][0]["netlist"] for d in (first, second)))

    def write_unit(self, expression: str) -> None:
        source = self.folder / "sum.v"
        source.write_text(UNIT.replace("a_i + b_i", expression), encoding="utf-8")
        synthesis._text.cache_clear()  # pylint: disable=protected-access
        synthesis.meaning.cache_clear()

    def fails(self, mode: str, sentence: str, **flags: Any) -> None:
        """One seed fails: it is named with tool and unit, and all else is there."""
        code, output, errors, data = self.called(f"{mode}:2", names=("sum", "wide"), **flags)
        self.assertEqual(code, 1)
        for name in ("sum", "wide"):
            self.assertIn(f"place: nextpnr-ecp5 placed no {name} with seed 2: {sentence}", errors)
            self.assertRegex(output, rf"{name} +2 +3.00 +40 +244")
        self.assertTrue(data["complete"])
        for row in data["units"]:
            self.assertEqual([p["seed"] for p in row["placed"]], [1, 3])
            self.assertEqual([f["seed"] for f in row["failures"]], [2])

    def test_a_design_that_is_not_routed(self) -> None:
        self.fails("no route", "Failed to route arc 3 of net 'a', from X1Y2 to X3Y4.")

    def test_a_placer_that_runs_out_of_time(self) -> None:
        self.fails("slow", "nextpnr-ecp5 ran out of time, 5 seconds", timeout=5 / 60)

    def test_a_report_that_reads_otherwise(self) -> None:
        self.fails(
            "other report",
            "the report of this version of nextpnr-ecp5 reads otherwise than that of 0.4 to 0.11: "
            "it has no 'fmax'",
        )

    def test_a_report_that_is_not_there(self) -> None:
        self.fails("silent", "nextpnr-ecp5 wrote no report")

    def test_delays_that_are_not_there(self) -> None:
        code, _, errors, _ = self.called("no delays", seeds=1)
        self.assertEqual(code, 1)
        self.assertRegex(
            errors, "placed no sum with seed 1: .*/timing.sdf: No such file or directory\n"
        )

    def test_a_full_disk_is_said_as_such(self) -> None:
        full = OSError(errno.ENOSPC, "No space left on device")
        with mock.patch.object(gzip, "open", side_effect=full):
            code, _, errors, _ = self.called(seeds=1)
        self.assertEqual(code, 1)
        self.assertRegex(
            errors, "placed no sum with seed 1: the disk that holds the cache .* is full"
        )

    def test_delays_that_read_otherwise(self) -> None:
        self.fails(
            "other delays",
            "the longest path in the SDF file of nextpnr-ecp5 takes 4.10 ns, and its report says "
            "7.50",
        )

    def test_a_failure_is_not_kept(self) -> None:
        self.called("no route", seeds=1)
        self.assertEqual(self.called(seeds=1)[0], 0)

    def test_a_design_that_is_too_large_is_not_placed(self) -> None:
        code, output, errors, data = self.called("full", seeds=1)
        self.assertEqual(code, 1)
        self.assertIn("not placed are 1 of 1 rows: sum (does not fit: Unable to place", errors)
        self.assertIn("does not fit: Unable to place cell 'x'", output)
        self.assertEqual(data["units"][0]["logic_ns"], 2.5)
        record = project.read_json(self.folder / "record.json")
        self.assertEqual((record["units"], record["longest path by Yosys, ns"]), ({}, 2.5))
        self.assertIn("does not fit", record["not placed"]["sum"]["reason"])

    def test_a_seed_that_does_not_fit_is_an_error_and_changes_no_kept_placement(self) -> None:
        kept = self.folder / "sum.json"
        kept.write_text("as before", encoding="utf-8")
        code, output, errors, data = self.called("full:2", keep=str(kept))
        self.assertEqual(code, 1)
        self.assertIn("placed no sum with seed 2: does not fit: Unable to place cell", errors)
        self.assertIn(f"not every seed was; {kept} stays as it is", errors)
        self.assertEqual(len(data["units"][0]["placed"]), 2)
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertEqual(kept.read_text(encoding="utf-8"), "as before")

    @unittest.skipIf(shutil.which("nextpnr-ecp5", path="/usr/bin:/bin"), "nextpnr-ecp5 is there")
    def test_without_a_placer_the_rows_have_the_timing_of_yosys(self) -> None:
        code, output, errors, _ = self.called(without=True)
        self.assertEqual(code, 1)
        self.assertIn("place: nextpnr-ecp5 is not on the PATH", errors)
        self.assertIn("cells alone 2.50 ns on 7-series", output)

    def test_a_row_that_cannot_be_prepared_leaves_the_others(self) -> None:
        prepare = self.prepare

        def broken(name: str, args: argparse.Namespace, build: object) -> place.Row:
            if name == "wide":
                raise project.Failed("wide: Yosys failed")
            return prepare(name, args, build)

        with mock.patch.object(self, "prepare", broken):
            code, output, errors, data = self.called(names=("wide", "sum"), seeds=1)
        self.assertEqual(code, 1)
        self.assertEqual(
            errors,
            "place: wide: Yosys failed\n"
            "place: not placed are 1 of 2 rows: wide (failed: wide: Yosys failed)\n",
        )
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertEqual(data["units"][0]["note"], "failed: wide: Yosys failed")

    def test_a_row_without_yosys_s_timing_leaves_the_others(self) -> None:
        refused = mock.Mock(side_effect=project.Failed("wide: Yosys failed"))
        code, output, errors, data = self.called(
            "full", names=("wide", "sum"), timing=refused, seeds=1
        )
        self.assertEqual(code, 1)
        self.assertIn("place: no timing of wide by Yosys: wide: Yosys failed", errors)
        self.assertRegex(output, "\nwide .*\nsum ")
        self.assertTrue(data["complete"])


if __name__ == "__main__":
    unittest.main()
