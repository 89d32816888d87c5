# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place checks before a placer runs, and what it makes of rows without one."""

import argparse
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.hardware import (
    area,
    lowering,
    place_record,
    place_row,
    placers,
    rtl_files,
    synthesis,
)

SCRIPTS = project.SCRIPTS
REPORT = """\
unit       dynrt::List<dynrt::config::thesis>
clock      10.00 ns (Lattice ECP5, speed grade 6)
stages     2
registers  27 bits between stages, 0 of state

stage  registers  longest path, ns  operations
    0          0              4.00  1 not
    1         27              9.60  1 add, 12 and

The longest path of each stage ends at
    0  the read of 'last', units/list.h:17
"""


class Texts(unittest.TestCase):
    def test_schedule_report(self) -> None:
        self.assertEqual(area.schedule(REPORT), {"stages": 2, "longest_path_ns": 9.6})

    def test_no_build_is_said(self) -> None:
        with self.assertRaisesRegex(project.Failed, "no build with hlsc is in /nowhere"):
            rtl_files.find_build(pathlib.Path("/nowhere"))

    def test_the_constraints_ask_for_no_clock(self) -> None:
        for device in placers.PLACERS:
            stated = placers.constraints_text(device)
            self.assertIn("clk_i", stated)
            self.assertNotIn("#", stated)
            self.assertNotIn("FREQUENCY", stated)

    def script(self, *args: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [SCRIPTS / "place", *args], capture_output=True, text=True, check=False
        )

    def test_unknown_device_lists_those_that_there_are(self) -> None:
        result = self.script("--device", "virtex2-6000")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr,
            "place: there is no way to place on 'virtex2-6000'; the "
            "devices are ice40-hx8k, ecp5-85\n",
        )

    def test_counts_and_clocks_are_above_zero(self) -> None:
        for flag, text, sentence in (
            ("--ask-mhz", "fast", "'fast' is not a number above 0"),
            ("--clock-ns", "-1", "'-1' is not a number above 0"),
            ("--copies", "0", "'0' is not a whole number above 0"),
            ("--seeds", "1.5", "'1.5' is not a whole number above 0"),
            ("--paths", "-1", "'-1' is not a whole number"),
        ):
            result = self.script(flag, text)
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"argument {flag}: {sentence}", result.stderr)

    def refused(self, *args: str) -> str:
        """The one sentence of a call that began no work."""
        result = self.script(*args)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr

    def test_unknown_grade_lists_those_that_there_are(self) -> None:
        self.assertEqual(
            self.refused("dynrt_core", "--device", "ecp5-85", "--grade", "9"),
            "place: --grade 9: ecp5-85 has no such speed grade; its grades are 6, 7, 8\n",
        )

    def test_names_are_checked_before_the_work(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            testing.write_tree(
                pathlib.Path(name),
                {
                    "hls/compiler/hlsc": "",
                    "hls/units/list_units.txt": "thesis|list|units/list.h|dynrt::List\n",
                },
            )
            self.assertRegex(
                self.refused("dynrt_core", "lists", "--build", name),
                "there is no unit 'lists' .did you mean list..; the units are dynrt_board, dynrt_core, "
                "list; dynrt_core",
            )
            self.assertIn(
                f"--config none: the build {name} has no such configuration",
                self.refused("list", "--config", "none", "--build", name),
            )
        self.assertIn(
            "--build /nowhere: there is no such folder",
            self.refused("dynrt_core", "--device", "ecp5-85", "--build", "/nowhere"),
        )

    @unittest.skipIf(shutil.which("nextpnr-ecp5"), "nextpnr-ecp5 is there")
    def test_a_missing_tool_is_said(self) -> None:
        result = self.script("dynrt_core", "dynrt_board", "--device", "ecp5-85")
        self.assertEqual(result.returncode, 1)
        first, last = result.stderr.splitlines()
        self.assertIn(
            "place: nextpnr-ecp5 is not on the PATH (Debian 12 has no package of it", first
        )
        self.assertEqual(
            last,
            "place: not placed are 2 of 2 rows: dynrt_core (nextpnr-ecp5 is not on the PATH); "
            "dynrt_board (nextpnr-ecp5 is not on the PATH)",
        )
        for name in ("dynrt_core", "dynrt_board"):
            self.assertRegex(result.stdout, f"\n{name} .*is not on the PATH")


class Lowering(unittest.TestCase):
    """What becomes of a unit before a placer runs."""

    UNIT = {"sum": {"module": "sum", "header": "sum.h", "type": "Sum"}}

    @staticmethod
    def prepared(grade: str) -> place_row.Row:
        args = argparse.Namespace(
            device="ecp5-85", grade=grade, config=rtl_files.CHECKED_IN, clock_ns=0.1, copies=1
        )
        return place_row.prepare("sum", args, pathlib.Path("build"))

    def test_a_unit_that_no_schedule_brings_to_the_clock_is_a_failure(self) -> None:
        refusal = project.Failed("sum.h:3: takes 2.35 ns")
        with (
            mock.patch.object(lowering, "units", lambda *_: self.UNIT),
            mock.patch.object(lowering, "lower", side_effect=refusal) as lower,
        ):
            row = self.prepared("8")
        self.assertEqual(pathlib.Path(lower.call_args.args[3]).name, "ecp5-8.json")
        self.assertIsNone(row.subject)
        self.assertEqual(row.data["note"], "not lowered: sum.h:3: takes 2.35 ns")

    def test_hlsc_gets_what_a_unit_states(self) -> None:
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        lines = "fast|sum|sum.h|Sum\nfast|box|box.h|Box|12\nfast|mail|mail.h|Mail||0.8\n"
        testing.write_tree(folder, {"hls/units/list_units.txt": lines})
        said = {}
        for module, unit in lowering.units(folder, "fast").items():
            words = list(map(str, lowering.command(folder, unit, 8.33, folder, "fast")))
            said[module] = words[words.index("--delay") + 2 :]
        self.assertEqual(
            said, {"sum": [], "box": ["--room", "12"], "mail": ["--uncertainty", "0.8"]}
        )

    def test_its_row_names_the_model_that_it_was_lowered_by(self) -> None:
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "sum.txt").write_text(REPORT, encoding="utf-8")
        with (
            mock.patch.object(lowering, "units", lambda *_: self.UNIT),
            mock.patch.object(lowering, "lower", lambda *_: folder),
            mock.patch.object(synthesis, "cells", lambda *_: ({}, 0.0)),
        ):
            models = {grade: self.prepared(grade).data["delay"] for grade in ("", "7", "8")}
        first = "hls/compiler/delay/ecp5.json"
        self.assertEqual(models, {"": first, "7": first, "8": "hls/compiler/delay/ecp5-8.json"})


class Record(unittest.TestCase):
    def test_the_clock_that_hlsc_asks_for(self) -> None:
        texts = (project.ROOT / "hls/compiler/schedule/timing_messages.h").read_text("utf-8")
        joined = re.sub(r'"\n\s*"', "", texts)
        refusals = [t for t in re.findall(r'"(.*?)";', joined) if "needs" in t]
        self.assertEqual(len(refusals), 3)
        for refusal in refusals:
            said = "not lowered: " + refusal.replace("{:.2f}", "11.12")
            missing = place_record.missing({"unit": "ray_generation", "note": said}, "ice40-hx8k")
            self.assertEqual((missing["least clock, ns"], missing["reason"]), (11.12, said))

    def test_a_row_without_a_note(self) -> None:
        missing = place_record.missing({"unit": "list"}, "ice40-hx8k")
        self.assertEqual(missing["reason"], "no seed was placed")
        self.assertIsNone(missing["least clock, ns"])


class Whole(unittest.TestCase):
    def test_core_and_board_are_the_checked_in_verilog(self) -> None:
        args = argparse.Namespace(copies=2, config=rtl_files.CHECKED_IN, build=None)
        for name in rtl_files.WHOLE:
            row = place_row.prepare(name, args, None)
            assert row.subject is not None
            files = synthesis.needed(name, list(row.subject.files))
            self.assertIn(rtl_files.GENERATED / "list.v", files)
            self.assertTrue(row.subject.joins)
            self.assertEqual(row.subject.copies, 2)


if __name__ == "__main__":
    unittest.main()
