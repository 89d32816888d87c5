# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds dynrt.core and the file lists against the Verilog that is there."""

import json
import pathlib
import re
import sys
import unittest

import yaml

from dynrt_tools import project, testing
from dynrt_tools.hardware import bitstream, file_lists, placers, rtl_files
from dynrt_tools.hardware.file_lists import TARGETS

ROOT = project.ROOT
BUILD = pathlib.Path(sys.argv.pop(1)) if sys.argv[1:] else ROOT / "build/release"
MADE = BUILD / "generated"
PIN = re.compile(r"^set_property -dict \{PACKAGE_PIN (\w+) .*\[get_ports \{(.+)\}\]$", re.MULTILINE)


class Targets(testing.InFolder):
    """What belongs to a target."""

    def files(self, name: str, suffix: str = "") -> list[pathlib.Path]:
        return [p for p in TARGETS[name].files(MADE) if p.name.endswith(suffix)]

    def test_the_checked_in_description_is_current(self) -> None:
        text = (ROOT / "dynrt.core").read_text(encoding="utf-8")
        self.assertEqual(text, file_lists.checked_in_core_file(), "run scripts/file_lists .")

    def test_every_file_by_hand_and_every_constraint_is_of_a_target(self) -> None:
        listed = {path for name in TARGETS for path in self.files(name)}
        constraints = placers.CONSTRAINTS.iterdir()
        there = [p for p in constraints if not p.name.startswith("place_")]  # of scripts/place
        there += rtl_files.all_hand_written() + list((ROOT / "rtl/lint").glob("*.vlt"))
        self.assertGreater(len(there), 45)
        self.assertEqual(sorted(set(there) - listed), [])

    def elaborated(self, top: str, files: list[pathlib.Path], cells: pathlib.Path) -> str:
        """What Icarus Verilog says of a top in these files, with modules of the folder `cells`."""
        folders = {f"-I{p.parent}" for p in files if p.suffix == ".vh"}
        sources = [p for p in files if p.suffix == ".v"]
        command: list[testing.Word] = ["iverilog", "-g2005", "-t", "null", "-s", top, "-y", cells]
        return testing.run(*command, *sorted(folders), *sources).stderr

    def test_targets_lack_no_file_and_need_each(self) -> None:
        names = {(t.top, t.core): name for name, t in TARGETS.items()}.values()
        for name, cells in (
            *((name, "verif/vendor") for name in names),
            ("arty", "rtl/arty"),  # which stands for what the vendor's tool makes
        ):
            target, files = TARGETS[name], self.files(name)
            self.assertEqual(self.elaborated(target.top, files, ROOT / cells), "", name)
            least = next(p for p in files if p.suffix == ".v" and p.stem != target.top)
            files.remove(least)
            said = self.elaborated(target.top, files, ROOT / cells)
            self.assertIn(f"Unknown module type: {least.stem}", said, name)

    def test_lint_targets_are_clean_by_their_waivers(self) -> None:
        for name in ("lint", "axi_lint", "wishbone_lint", "arty_lint", "ulx3s_lint"):
            target, files = TARGETS[name], self.files(name)
            self.assertEqual(self.linted(target, files), "", name)
            without = [path for path in files if path.suffix != ".vlt"]
            self.assertIn("%Warning-", self.linted(target, without), name)

    def linted(self, target: file_lists.Target, files: list[pathlib.Path]) -> str:
        """What Verilator says of a target in these files."""
        path = self.folder / "list.f"
        path.write_text(file_lists.file_list(target, files, str), encoding="utf-8")
        return testing.run("verilator", "--lint-only", "-f", path).stderr

    def test_the_arty_has_its_pins(self) -> None:
        (file,) = self.files("arty", ".xdc")
        found = PIN.findall(file.read_text(encoding="utf-8"))
        pins = bitstream.pins_of(ROOT / "rtl/arty/dynrt_arty.v")
        own = [pin for pin in pins if not pin.startswith("ddr3_")]  # the others Vivado knows
        self.assertEqual(sorted(pin for _, pin in found), sorted(own))
        self.assertEqual(len({site for site, _ in found}), len(own))

    def test_the_board_is_made_for_the_core_that_is_listed(self) -> None:
        listed = json.loads((ROOT / "hls/configs/configs.json").read_text(encoding="utf-8"))
        thesis = next(c for c in listed if c["name"] == "thesis")
        board = (ROOT / "rtl/board/dynrt_board.v").read_text(encoding="utf-8")
        for parameter, key in (("PACKETS", "packets"), ("CACHE_LINES", "lines")):
            stated = project.searched(rf"parameter {parameter} = (\d+)", board)
            self.assertEqual(int(stated[1]), int(thesis[key]), parameter)


class Lists(testing.InFolder):
    """What the command writes."""

    def test_lists_name_what_is_there(self) -> None:
        for flags, places in (((), [pathlib.Path("/")]), (("--relative",), [ROOT / "rtl", BUILD])):
            command: list[testing.Word] = [ROOT / "scripts/file_lists", *flags, f"--build={BUILD}"]
            self.assertEqual(testing.run(*command, self.folder).returncode, 0)
            for name in file_lists.LISTS:
                lines = (self.folder / name).read_text(encoding="utf-8").splitlines()
                self.assertGreater(len(lines), 25, name)
                for line in lines:
                    path = pathlib.Path(line.removeprefix("+incdir+"))
                    if not line.startswith("-"):
                        self.assertEqual(path.is_absolute(), not flags, f"{name}: {line}")
                        self.assertTrue(any((p / path).exists() for p in places), line)
            core = yaml.safe_load((self.folder / "dynrt.core").read_text().partition("\n")[2])
            self.assertGreaterEqual(core["targets"].keys(), {"default", "axi", "ulx3s", "arty"})

    def test_without_a_build_the_checked_in_core_has_its_lists(self) -> None:
        result = testing.run(ROOT / "scripts/file_lists", "--build", self.folder, self.folder)
        self.assertIn("left out: no build with hlsc is in ", result.stderr)
        self.assertIn("scripts/test --build-only", result.stderr)
        written = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(written, ["dynrt.core", "dynrt_board.f", "dynrt_core.f", "dynrt_lint.f"])
        for name in ("dynrt_core", "dynrt_board"):
            command = f"iverilog -g2005 -t null -s {name} -f {self.folder}/{name}.f".split()
            self.assertEqual(testing.run(*command, cwd=self.folder).stderr, "")


if __name__ == "__main__":
    unittest.main()
