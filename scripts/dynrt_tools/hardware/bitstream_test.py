# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/bitstream does for a small board: Yosys synthesizes it, stand-ins place and pack it, and
a PATH of its own says which tools there are."""

import contextlib
import io
import json
import os
import pathlib
import shutil
import tempfile
import unittest
from collections.abc import Sequence
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.hardware import bitstream, devices, placers, rtl_files, synthesis

TOP = """\
module small #(parameter PIXEL_MHZ = 25) (
  input  wire       clk_i,
  input  wire [1:0] a_i,
  output reg  [1:0] sum_o
);
  always @(posedge clk_i) sum_o <= PIXEL_MHZ == 40 ? a_i : sum_o + a_i;
endmodule
"""
PINS = ("clk_i", "a_i[0]", "a_i[1]", "sum_o[0]", "sum_o[1]")
# Both note their arguments, and write half of a file before they fail.
STAND_IN = """#!/usr/bin/python3
import json, os, sys, time
args = sys.argv[1:]
if args == ["--version"]:
    sys.exit(print("nextpnr-ecp5 -- Version 0.7"))
value = {a: b for a, b in zip(args, args[1:]) if a.startswith("-")}
mode = os.environ["MODE"]
with open(os.environ["RUNS"], "a") as runs:
    runs.write(json.dumps([os.path.basename(sys.argv[0]), *args]) + "\\n")
"""
PLACER = f"""{STAND_IN}
open(value["--textcfg"], "w").write("configuration")
if mode == "placer fails":
    sys.exit("ERROR: Failed to route arc 3 of net 'a', from X1Y2 to X3Y4.")
if mode == "slow" and "--timing-allow-fail" not in args:
    sys.exit("ERROR: Max frequency for clock 'clk': 70.00 MHz (FAIL at 78.12 MHz)")
if mode == "placer hangs":
    time.sleep(30)
asked = 12.0 if mode == "another clock" else 78.13
achieved = 70.0 if mode == "slow" else 90.0
report = {{"fmax": {{"$glbnet$clk": {{"achieved": achieved, "constraint": asked}}}}}}
if mode == "no clocks":
    report = {{"fmax": {{}}}}
late = 4.25 if mode == "late pin" else 1.5
far = 13.5 if mode == "far crossing" else 2.5
open(value["-l"], "w").write(
    f"Info: Max delay posedge $glbnet$clk     -> <async>   : {{late}} ns\\n"
    f"Info: Max delay posedge $glbnet$clk -> posedge $glbnet$other: {{far}} ns\\n"
)
if mode == "no crossing":
    report["fmax"]["other"] = report["fmax"]["$glbnet$clk"]
    open(value["-l"], "w").write("")
if mode == "other report":
    report = {{}}
if mode != "no report":
    json.dump(report, open(value["--report"], "w"))
"""
PACKER = f"""{STAND_IN}
assert open(value["--input"]).read() == "configuration"
if mode != "no bitstream":
    open(value["--bit"], "w").write("half" if mode == "packer fails" else "bits")
if mode == "packer fails":
    sys.exit(3)
"""
FAILING_YOSYS = """#!/bin/sh
[ "$1" = -V ] && echo 'Yosys 0.23' || { echo 'ERROR: Module `x` is not part of the design.' >&2; exit 1; }
"""
ABC = "berkeley-abc"  # which Debian's Yosys calls, and others have in them


class Small(testing.InFolder):
    """Calls of scripts/bitstream for the small board."""

    kept: pathlib.Path  # of all tests, as Yosys needs seconds

    @classmethod
    def setUpClass(cls) -> None:
        cls.kept = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))

    def setUp(self) -> None:
        super().setUp()
        self.bin, self.out, self.json = (self.folder / name for name in ("bin", "out", "json"))
        self.bin.mkdir()
        testing.link_tools(self.bin, "yosys", "sh", *([ABC] if shutil.which(ABC) else []))
        testing.write_program(self.bin / "nextpnr-ecp5", PLACER)
        testing.write_program(self.bin / "ecppack", PACKER)
        self.write_pins(PINS)
        testing.write_tree(self.folder, {"rtl/small.v": TOP})

    def write_pins(self, pins: Sequence[str]) -> None:
        text = "".join(
            f'LOCATE COMP "{pin}" SITE "A{i}";\nIOBUF PORT "{pin}" IO_TYPE=LVCMOS33;\n'
            for i, pin in enumerate(pins)
        )
        testing.write_tree(self.folder, {"constraints/small.lpf": text})

    def called(self, mode: str, *flags: str) -> tuple[int | str | None, str, str]:
        """Exit code or last words, output and errors."""
        board = bitstream.Board(
            *("small", "fast_port", "ecp5-85", "6", "small.lpf"),
            {"640x480": 25, "800x600": 40},
            {25: {"clk": 78.125}, 40: {"clk": 60.0}}.__getitem__,
            {"clk": 4.0},
        )
        output, errors = io.StringIO(), io.StringIO()
        environment = {"PATH": str(self.bin), "MODE": mode, "RUNS": str(self.folder / "runs")}
        words = ["bitstream", "small", "--out", str(self.out), "--json", str(self.json), *flags]
        synthesis.tool_version.cache_clear()
        changes: list[contextlib.AbstractContextManager[object]] = [
            mock.patch.dict(os.environ, environment),
            mock.patch.dict(bitstream.BOARDS, small=board),
            mock.patch.object(project, "ROOT", self.folder),
            mock.patch.object(placers, "CONSTRAINTS", self.folder / "constraints"),
            mock.patch.object(synthesis, "KEPT", self.kept),
            mock.patch.object(rtl_files, "made_by", lambda build, target: self.folder),
            mock.patch.object(rtl_files, "sources", lambda core, made: [bitstream.top_of(board)]),
            mock.patch("sys.argv", words),
            contextlib.redirect_stdout(output),
            contextlib.redirect_stderr(errors),
        ]
        with contextlib.ExitStack() as changed:
            for change in changes:
                changed.enter_context(change)
            try:
                code: int | str | None = bitstream.main()
            except SystemExit as error:
                code = error.code
        synthesis.tool_version.cache_clear()
        return code, output.getvalue(), errors.getvalue()

    def runs(self) -> list[list[str]]:
        path = self.folder / "runs"
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        return [json.loads(line) for line in lines]

    def leaves_nothing(self, mode: str, sentence: str, *flags: str) -> str:
        """A call that ends with this sentence and without a file; gives its output. A code that is a
        text is 1 to the shell."""
        code, output, errors = self.called(mode, *flags)
        self.assertEqual((code, errors), (f"bitstream: {sentence}", ""))
        self.assertFalse(self.out.exists() or self.json.exists())
        return output

    def refuses(self, *sentences: str) -> str:
        """A call that says this, places nothing and leaves no file; gives its output."""
        code, output, errors = self.called("")
        self.assertEqual(code, 1)
        self.assertEqual(errors.splitlines(), [f"bitstream: {said}" for said in sentences])
        self.assertFalse(self.out.exists() or self.json.exists())
        self.assertEqual(self.runs(), [])
        return output


class Bitstream(Small):
    """Bitstreams, and what keeps the command from one."""

    def test_a_bitstream_and_its_figures(self) -> None:
        code, output, errors = self.called("", "--seed", "7")
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(self.out.read_text(encoding="utf-8"), "bits")
        data = project.read_json(self.json)
        self.assertEqual(data["clocks"], {"clk": {"achieved": 90.0, "constraint": 78.13}})
        self.assertEqual(data["pins_ns"], {"clk": 1.5})
        self.assertEqual(data["crossings_ns"], {"clk to other": 2.5})
        self.assertEqual((data["board"], data["mode"]), ("small", "640x480"))
        self.assertEqual(data["date"], project.today())
        self.assertEqual(data["tools"]["placer"], "nextpnr-ecp5 -- Version 0.7")
        self.assertIn("crossing    clk to other 2.5 ns of 12.8\n", output)
        self.assertEqual((data["seed"], data["resources"]["FF"]), (7, 2))
        self.assertIn("pins        all 5 have their sites\n", output)
        self.assertRegex(output, r"FF +2 of 83,640, 0%\n")
        self.assertIn("clock       clk reaches 90.0 MHz and runs at 78.1\n", output)
        self.assertIn("pins        clk to the last pin 1.5 ns of 4.0\n", output)
        self.assertIn(f"bitstream   {self.out}\n", output)
        placer, packer = self.runs()
        self.assertEqual((placer[0], packer[0]), ("nextpnr-ecp5", "ecppack"))
        for flag, value in (
            ("--speed", "6"),
            ("--seed", "7"),
            ("--router", "router2"),
            ("--lpf", str(self.folder / "constraints/small.lpf")),
        ):
            self.assertEqual(placer[placer.index(flag) + 1], value)
        self.assertIn("--85k", placer)
        netlist = project.read_json(pathlib.Path(placer[placer.index("--json") + 1]))
        self.assertEqual(netlist["modules"]["small"]["settings"], bitstream.ROUTER_COSTS)

    def test_another_mode(self) -> None:
        output = self.leaves_nothing(
            "",
            "nextpnr-ecp5 was asked for 78.13 MHz of clock clk, which the PLL makes 60.00 MHz: this "
            "version of it follows the clock through the PLL otherwise",
            *("--mode", "800x600"),
        )
        self.assertRegex(output, r"LUT4 +0 of 83,640, 0%\n")

    def test_a_mode_that_there_is_not(self) -> None:
        output = self.leaves_nothing(
            "",
            "--mode 640x400: small has no such mode; it has 640x480 and 800x600",
            *("--mode", "640x400"),
        )
        self.assertEqual(output, "")

    def test_a_missed_clock_leaves_the_file(self) -> None:
        code, output, errors = self.called("slow")
        self.assertEqual(code, 1)
        self.assertEqual(
            errors, "bitstream: clock clk runs at 78.1 MHz, and its paths end at 70.0\n"
        )
        self.assertIn("clk reaches 70.0 MHz and runs at 78.1", output)
        self.assertEqual(self.out.read_text(encoding="utf-8"), "bits")
        self.assertEqual(project.read_json(self.json)["clocks"]["clk"]["achieved"], 70.0)

    def test_a_late_pin_leaves_the_file(self) -> None:
        code, _, errors = self.called("late pin")
        self.assertEqual(code, 1)
        self.assertEqual(
            errors, "bitstream: a pin is 4.2 ns behind clock clk, and 4.0 is the most\n"
        )
        self.assertTrue(self.out.exists())

    def test_a_far_crossing_leaves_the_file(self) -> None:
        code, _, errors = self.called("far crossing")
        self.assertEqual(code, 1)
        self.assertEqual(errors, "bitstream: clk to other takes 13.5 ns, and a period is 12.8\n")
        self.assertTrue(self.out.exists())

    def test_the_placer_was_asked_for_the_clocks_of_the_board(self) -> None:
        for mode, asked in (("another clock", "12.00"), ("no clocks", "0.00")):
            self.leaves_nothing(
                mode,
                f"nextpnr-ecp5 was asked for {asked} MHz of clock clk, which the PLL makes 78.12 MHz: "
                "this version of it follows the clock through the PLL otherwise",
            )

    def test_a_missing_tool_is_named_after_the_checks_without_it(self) -> None:
        for tool in ("nextpnr-ecp5", "ecppack"):
            (self.bin / tool).unlink()
            output = self.refuses(
                f"{tool} is not on the PATH, so there is no bitstream; {bitstream.SUITE}"
            )
            self.assertIn("pins        all 5 have their sites\n", output)
            self.assertIn(f"tools       {tool} is not on the PATH: pins, synthesis", output)
            self.assertRegex(output, r"LUT4 +\d+ of 83,640, 0%\n")
            testing.write_program(self.bin / tool, PLACER)

    def test_without_yosys_the_pins_are_checked(self) -> None:
        (self.bin / "yosys").unlink()
        output = self.leaves_nothing(
            "",
            "yosys is not installed; Debian's package yosys has it, and scripts/setup installs "
            "that",
        )
        self.assertEqual(output, "pins        all 5 have their sites\n")

    def test_pins_and_sites_agree(self) -> None:
        self.write_pins([*PINS[:-1], "led_o"])
        where = "constraints/small.lpf"
        self.refuses(
            f"{where} has no site for pin sum_o[1] of small",
            f"{where} has no IOBUF for pin sum_o[1] of small",
            f"{where} has a site for led_o, which is no pin of small",
        )

    def test_no_two_pins_have_a_site(self) -> None:
        path = self.folder / "constraints/small.lpf"
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace('"A1"', '"A0"'), encoding="utf-8")
        self.refuses("constraints/small.lpf gives site A0 to two pins")

    def test_a_chip_without_the_room(self) -> None:
        with mock.patch.dict(devices.DEVICES["ecp5-85"]["has"], FF=1):
            self.refuses("Lattice LFE5U-85F has not the room: 2 FF of 1, 1 too many")

    def test_each_board_has_its_sites(self) -> None:
        for name, board in bitstream.BOARDS.items():
            self.assertEqual(bitstream.pin_problems(board), [], name)
            self.assertGreater(len(bitstream.pins_of(bitstream.top_of(board))), 2, name)


class FailingTools(Small):
    """A tool that fails says why, and leaves nothing."""

    def test_yosys(self) -> None:
        (self.bin / "yosys").unlink()
        testing.write_program(self.bin / "yosys", FAILING_YOSYS)
        with mock.patch.object(self, "kept", self.folder / "kept"):
            code, _, errors = self.called("")
        self.assertIn("small: ERROR: Module `x` is not part of the design.", str(code))
        self.assertEqual((errors, self.runs()), ("", []))
        self.assertFalse(self.out.exists() or self.json.exists())

    def test_the_placer(self) -> None:
        self.leaves_nothing("placer fails", "Failed to route arc 3 of net 'a', from X1Y2 to X3Y4.")
        self.leaves_nothing(
            "placer hangs",
            "nextpnr-ecp5 ran out of time, 1 seconds; --timeout gives it more",
            *("--timeout", "0.02"),
        )
        self.assertEqual({run[0] for run in self.runs()}, {"nextpnr-ecp5"})

    def test_the_placer_s_report(self) -> None:
        self.leaves_nothing("no report", "nextpnr-ecp5 wrote no report")
        self.leaves_nothing(
            "other report",
            "the report of this version of nextpnr-ecp5 reads otherwise than that of 0.4 to 0.11: "
            "it has no 'fmax'",
        )

    def test_the_placer_s_log(self) -> None:
        self.leaves_nothing(
            "no crossing",
            "the report of this version of nextpnr-ecp5 reads otherwise than that of 0.4 to 0.11: "
            "it has no 'Max delay posedge'",
        )

    def test_the_packer(self) -> None:
        self.leaves_nothing("packer fails", "ecppack ended with exit code 3")
        self.leaves_nothing("no bitstream", "ecppack wrote no bitstream")

    def test_what_was_there_stays(self) -> None:
        for path in (self.out, self.json):
            path.write_text("of before", encoding="utf-8")
        self.called("packer fails")
        for path in (self.out, self.json):
            self.assertEqual(path.read_text(encoding="utf-8"), "of before")

    def test_a_file_that_cannot_be_written_is_refused_first(self) -> None:
        code, output, _ = self.called("", "--out", str(self.folder / "none" / "out"))
        self.assertRegex(str(code), "^bitstream: --out .*: there is no folder '.*none'")
        self.assertEqual(output, "")


if __name__ == "__main__":
    unittest.main()
