# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds dynrt.core, the description for FuseSoC, and the file lists made from it against the
Verilog that is there."""

import json
import pathlib
import re
import subprocess
import unittest

import yaml

from dynrt_tools import project, testing
from dynrt_tools.hardware import bitstream, file_lists, placers, rtl_files

ROOT = project.ROOT
# Filesets of Verilog that is written by hand; the board's has its display too.
BY_HAND = (
    "library registers board scan_out port_board bus examples sdram link display ulx3s".split()
)
BY_HAND += ["serial", "arty", "arty_controller"]
BESIDE_CORES = ["link16", "link8"]  # and what the filesets sdram and display have
# Files of constraints with pins, and how they give a pin its site.
SITES = {
    "LPF": r'^LOCATE COMP "(?P<pin>.+)" SITE "(?P<site>\w+)";',
    "xdc": r"^set_property -dict \{PACKAGE_PIN (?P<site>\w+) .*\[get_ports \{(?P<pin>.+)\}\]$",
}
# What the vendor's tool adds to a target, and the pins that come with it.
MADE_BY_TOOLS = {"arty": ("arty_controller", "ddr3_")}
TEXT = (ROOT / "dynrt.core").read_text(encoding="utf-8")


class CoreFile(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        first, _, rest = TEXT.partition("\n")
        self.assertEqual(first, "CAPI=2:")
        self.core = yaml.safe_load(rest)

    def files(self, *filesets: str) -> list[str]:
        """The names in these filesets; an entry is a name, or a name with attributes."""
        found = [f for fileset in filesets for f in self.core["filesets"][fileset]["files"]]
        return [next(iter(f)) if isinstance(f, dict) else f for f in found]

    def test_its_version_is_the_project_s(self) -> None:
        text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        stated = project.searched(r"project\(dynrt VERSION ([\d.]+)", text)
        self.assertEqual(self.core["name"], f"dynrt::dynrt:{stated[1]}")

    def test_every_verilog_file_is_listed_once(self) -> None:
        listed = [
            name for name in self.files(*BY_HAND, *BESIDE_CORES, "core") if name.endswith(".v")
        ]
        there = rtl_files.all_hand_written() + rtl_files.units_in(rtl_files.GENERATED)
        for folder in rtl_files.BESIDE_CORES:
            there += rtl_files.units_in(folder)
        self.assertGreater(len(there), 30)
        self.assertEqual(sorted(listed), sorted(p.relative_to(ROOT).as_posix() for p in there))

    def test_the_cores_behind_a_port_are_listed_too(self) -> None:
        # One that a bus joins to its memory has no display, so that is a fileset of its own.
        for filesets, name in (
            (["port_core", "port_scan_out"], "fast_port"),
            (["ulx3s_core"], "fast_ulx3s"),
        ):
            there = rtl_files.units_in(rtl_files.ALL_GENERATED / name)
            self.assertGreater(len(there), 25)
            self.assertEqual(
                sorted(self.files(*filesets)), [p.relative_to(ROOT).as_posix() for p in there]
            )

    def test_every_constraint_is_of_a_target(self) -> None:
        # But for those that scripts/place measures with.
        listed = {f for t in self.core["targets"].values() for f in self.files(*t["filesets"])}
        there = [p for p in placers.CONSTRAINTS.iterdir() if not p.name.startswith("place_")]
        self.assertGreater(len(there), 3)
        for path in there:
            self.assertIn(path.relative_to(ROOT).as_posix(), listed)

    def test_every_file_is_there(self) -> None:
        for name in self.files(*self.core["filesets"]):
            self.assertTrue((ROOT / name).is_file(), name)

    def test_every_header_that_is_included_is_listed(self) -> None:
        headers = {pathlib.PurePath(name).name for name in self.files("headers", "link16")}
        for name in self.files(*BY_HAND, "core"):
            text = (ROOT / name).read_text(encoding="utf-8")
            for header in re.findall(r'^`include "([^"]+)"', text, re.MULTILINE):
                self.assertIn(header, headers, name)

    def test_targets_have_what_they_name(self) -> None:
        for name, target in self.core["targets"].items():
            for fileset in target["filesets"]:
                self.assertIn(fileset, self.core["filesets"], name)
            text = "".join(
                (ROOT / f).read_text(encoding="utf-8")
                for f in self.files(*target["filesets"])
                if f.endswith(".v")
            )
            self.assertRegex(text, rf"\nmodule {target['toplevel']}\b", name)

    def elaborated(self, files: list[str], top: str) -> str:
        """What Icarus Verilog says of a top in these files; it knows the vendors' cells too."""
        folders = {ROOT / pathlib.PurePath(f).parent for f in files if f.endswith(".vh")}
        sources = [ROOT / f for f in files if f.endswith(".v")]
        command = ["iverilog", "-g2005", "-t", "null", "-s", top, "-y", f"{ROOT}/verif/vendor"]
        result = testing.run(*command, *(f"-I{f}" for f in sorted(folders)), *sources)
        self.assertEqual(result.returncode == 0, not result.stderr, result.stderr)
        return result.stderr

    def test_targets_lack_no_file(self) -> None:
        tops = set()
        for name, target in self.core["targets"].items():
            self.assertEqual(self.elaborated(self.all_of(name), target["toplevel"]), "", name)
            tops.add(target["toplevel"])
        self.assertGreaterEqual(tops, {"dynrt_axi", "dynrt_wishbone", "dynrt_ulx3s", "dynrt_arty"})

    def test_a_target_needs_its_files(self) -> None:
        for name in ("axi", "wishbone", *self.boards()):
            target = self.core["targets"][name]
            files = self.all_of(name)
            text = self.top_of(target).read_text(encoding="utf-8")
            modules = set(re.findall(r"^  (\w+)(?: #\(.*\))? \w+ \($", text, re.MULTILINE))
            self.assertTrue(modules, name)
            for module in modules:
                without = [f for f in files if pathlib.PurePath(f).stem != module]
                self.assertLess(len(without), len(files), f"{name}: {module}")
                said = self.elaborated(without, target["toplevel"])
                self.assertIn(f"Unknown module type: {module}", said)

    def top_of(self, target: project.Json) -> pathlib.Path:
        """The file of a target's top."""
        names = self.files(*target["filesets"])
        return ROOT / next(n for n in names if n.endswith(f"/{target['toplevel']}.v"))

    def all_of(self, name: str) -> list[str]:
        """The files of a target, with those that stand for what a tool makes."""
        made = MADE_BY_TOOLS[name][:1] if name in MADE_BY_TOOLS else ()
        return self.files(*self.core["targets"][name]["filesets"], *made)

    def boards(self) -> dict[str, str]:
        """The targets that have pins, and the filesets with these."""
        pins = {f for f, fileset in self.core["filesets"].items() if fileset["file_type"] in SITES}
        targets = self.core["targets"].items()
        return {n: f for n, t in targets for f in t["filesets"] if f in pins}

    def test_boards_have_their_pins(self) -> None:
        self.assertEqual(list(self.boards()), ["ulx3s", "arty"])
        for name, fileset in self.boards().items():
            (file,) = self.files(fileset)
            pattern = re.compile(SITES[self.core["filesets"][fileset]["file_type"]], re.MULTILINE)
            found = list(pattern.finditer((ROOT / file).read_text(encoding="utf-8")))
            _, made = MADE_BY_TOOLS.get(name, ("", "none"))
            pins = bitstream.pins_of(self.top_of(self.core["targets"][name]))
            self.assertEqual(
                sorted(m["pin"] for m in found),
                sorted(pin for pin in pins if not pin.startswith(made)),
                name,
            )
            sites = [m["site"] for m in found]
            self.assertGreater(len(sites), 5, name)
            self.assertEqual(len(set(sites)), len(sites), name)

    def test_the_board_is_made_for_the_core_that_is_listed(self) -> None:
        listed = json.loads((ROOT / "hls/configs/configs.json").read_text(encoding="utf-8"))
        thesis = next(c for c in listed if c["name"] == "thesis")
        board = (ROOT / "rtl/board/dynrt_board.v").read_text(encoding="utf-8")
        for parameter, key in (
            ("PACKETS", "packets"),
            ("CACHE_LINES", "lines"),
            ("SCAN_OUT", "scan_out"),
            ("SRAM_LATENCY", "sram_latency"),
        ):
            stated = project.searched(rf"parameter {parameter} = (\d+)", board)
            self.assertEqual(int(stated[1]), int(thesis[key]), parameter)

    def test_every_waiver_is_of_the_lint_targets(self) -> None:
        there = sorted((ROOT / "rtl" / "lint").glob("*.vlt"))
        self.assertEqual(self.files("waivers"), [p.relative_to(ROOT).as_posix() for p in there])

    def linted(self, name: str, without: str = "none") -> str:
        """What Verilator says of a target by its own options, without the files of such a name."""
        target = self.core["targets"][name]
        options = target["tools"]["verilator"]["verilator_options"]
        files = self.files(*target["filesets"])
        waivers = [ROOT / f for f in files if f.endswith(".vlt") and without not in f]
        folders = sorted({f"-I{(ROOT / f).parent}" for f in files if f.endswith(".vh")})
        sources = [ROOT / f for f in files if f.endswith(".v")]
        command = ["verilator", "--lint-only", *options, "--top-module", target["toplevel"]]
        return testing.run(*command, *folders, *waivers, *sources).stderr

    def test_the_lint_targets_of_boards_are_clean_by_their_waivers(self) -> None:
        for name, needed in (
            ("serial_lint", ""),
            ("arty_lint", "lint/arty"),
            ("ulx3s_lint", "lint/ulx3s lint/display vendor"),
        ):
            self.assertEqual(self.linted(name), "", name)
            for waiver in needed.split():
                self.assertIn("%Warning-", self.linted(name, waiver), name)

    def lists(self, *flags: str) -> dict[str, list[str]]:
        """The lines of each list that the command writes."""
        subprocess.run([ROOT / "scripts/file_lists", *flags, self.folder], check=True)
        names = file_lists.LISTS
        return {n: (self.folder / n).read_text(encoding="utf-8").splitlines() for n in names}

    def test_file_lists_name_what_is_there(self) -> None:
        for flags, start in (((), pathlib.Path("/")), (("--relative",), ROOT / "rtl")):
            lists = self.lists(*flags)
            self.assertLess(len(lists["dynrt_core.f"]), len(lists["dynrt_board.f"]))
            self.assertGreater(len(lists["dynrt_core.f"]), 25)
            for name, lines in lists.items():
                for line in lines:
                    path = pathlib.Path(line.removeprefix("+incdir+"))
                    if not line.startswith("-"):
                        self.assertEqual(path.is_absolute(), not flags, f"{name}: {line}")
                        self.assertTrue((start / path).exists(), f"{name}: {line}")

    def test_tools_read_the_lists_from_any_folder(self) -> None:
        self.lists()
        for command in (
            "verilator --lint-only -f {}/dynrt_lint.f",
            "verilator --lint-only -f {}/dynrt_board.f --top-module dynrt_board",
            "iverilog -g2005 -t null -s dynrt_core -f {}/dynrt_core.f",
        ):
            words = command.format(self.folder).split()
            for place in (self.folder, ROOT, ROOT / "rtl"):
                result = testing.run(*words, cwd=place)
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_the_cores_behind_a_bus_and_their_examples_are_clean(self) -> None:
        self.lists()
        for name in "dynrt_axi dynrt_wishbone axi_system wishbone_system dynrt_serial".split():
            result = testing.run("verilator", "--lint-only", "-f", self.folder / f"{name}.f")
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""), name)

    def test_the_lists_of_boards_lack_only_what_the_vendor_s_tool_has(self) -> None:
        self.lists()
        for top, beside in (("dynrt_arty", "rtl/arty"), ("dynrt_ulx3s", "verif/vendor")):
            command = f"iverilog -g2005 -t null -s {top} -f {self.folder}/{top}.f".split()
            self.assertIn("Unknown module type", testing.run(*command).stderr, top)
            result = testing.run(*command, "-y", ROOT / beside)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""), top)

    def test_the_lint_list_needs_its_waivers(self) -> None:
        self.lists()
        path = self.folder / "dynrt_lint.f"
        lines = path.read_text(encoding="utf-8").splitlines()
        without = [line for line in lines if not line.endswith(".vlt")]
        self.assertLess(len(without), len(lines))
        path.write_text("\n".join(without), encoding="utf-8")
        result = testing.run("verilator", "--lint-only", "-f", path)
        self.assertIn("PINCONNECTEMPTY", result.stderr)


if __name__ == "__main__":
    unittest.main()
