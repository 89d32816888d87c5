# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A stand-in for nextpnr-ecp5 and calls of scripts/place with it, for tests."""

import argparse
import contextlib
import functools
import io
import json
import os
import pathlib
import re
import tempfile
import unittest
from collections.abc import Callable, Sequence
from typing import Any
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import (
    place,
    place_row,
    placing,
    rtl_files,
    synthesis,
)
from dynrt_tools.hardware.placed_example import SDF
from dynrt_tools.project import Json

UNIT = """\
// Scheduled for 3.5 ns on x: y
module sum (input clk_i, input rst_ni, input [3:0] a_i, input [3:0] b_i, output [4:0] sum_o);
  reg [4:0] sum_q;
  always @(posedge clk_i) sum_q <= rst_ni ? a_i + b_i : 5'd0;
  assign sum_o = sum_q;
endmodule
"""
# Writes the SDF file of placed_example and a report as nextpnr 0.11 writes it. MODE says how it
# differs; a mode with a seed, as "no route:2", is that seed's alone.
PLACER = """#!/usr/bin/python3
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
PROGRESS = re.compile(r"place: (placing )?\w+, seed \d+")


class StandIn(unittest.TestCase):
    """Calls of scripts/place with the stand-in on the PATH."""

    def setUp(self) -> None:
        self.delay: Json = {}  # the model of a row that is no core
        self.progress: list[str] = []  # lines of the last call
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        program = self.bin / "nextpnr-ecp5"
        program.write_text(PLACER, encoding="utf-8")
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
            "seed": None,
            "copies": 1,
            "paths": 3,
            "timeout": 1.0,
            "build": None,
            "jobs": 1,
            "json": data,
            "record": self.folder / "record.json",
            "clock": False,
        } | flags
        synthesis.tool_version.cache_clear()
        output, errors = io.StringIO(), io.StringIO()
        with (
            mock.patch.dict(os.environ, environment),
            mock.patch.object(synthesis, "KEPT", self.folder / "kept"),
            mock.patch.object(place, "parse", functools.partial(argparse.Namespace, **args)),
            mock.patch.object(place, "chosen", lambda _: (list(names), None)),
            mock.patch.object(place_row, "prepare", self.prepare),
            mock.patch.object(placing, "logic_delay", timing),
            contextlib.redirect_stdout(output),
            contextlib.redirect_stderr(errors),
        ):
            code = place.main()
        synthesis.tool_version.cache_clear()
        said = errors.getvalue().splitlines(keepends=True)
        self.progress = [line for line in said if PROGRESS.match(line)]
        others = "".join(line for line in said if line not in self.progress)
        return code, output.getvalue(), others, project.read_json(data)

    def prepare(self, name: str, args: argparse.Namespace, _: object) -> place_row.Row:
        subject = placing.Subject(name, [self.folder / f"{name}.v"], args.copies)
        data = {"unit": name, "stages": 2, "longest_path_ns": 3.0, **self.delay}
        return place_row.Row(name, data, subject)

    def runs(self) -> list[list[str]]:
        path = self.folder / "runs"
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        return [json.loads(line) for line in lines]

    def write_unit(self, expression: str) -> None:
        source = self.folder / "sum.v"
        source.write_text(UNIT.replace("a_i + b_i", expression), encoding="utf-8")
        synthesis._text.cache_clear()  # pylint: disable=protected-access
        synthesis.meaning.cache_clear()
