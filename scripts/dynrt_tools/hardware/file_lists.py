# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes which Verilog belongs together: lists for tools that read files from a list, and dynrt.core,
the description for FuseSoC of the same and more targets.

    dynrt_core.f   the core
    dynrt_board.f  the core and its board
    dynrt_lint.f   the board for Verilator, with the waivers of rtl/lint, its top and -Wall
    dynrt_axi.f, dynrt_wishbone.f      the core behind a bus, likewise
    axi_system.f, wishbone_system.f    the examples that have it beside a memory, likewise
    dynrt_serial.f  the core with its host on a serial line, likewise
    dynrt_arty.f, dynrt_ulx3s.f  the tops of boards, for the vendors' tools: without waivers, and
                                 without what such a tool knows or makes (rtl/arty/mig_7series_0.v)

From dynrt_axi.f on, hlsc makes the Verilog of the core, which needs a full build (scripts/test
--build-only); without one these are left out. The names are absolute, so a list works in every folder:
    verilator --lint-only -f FOLDER/dynrt_lint.f
    iverilog -g2005 -t null -s dynrt_core -f FOLDER/dynrt_core.f
"""

import argparse
import pathlib
import re
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

import yaml
from dynrt_tools import project
from dynrt_tools.hardware import rtl_files, synthesis
from dynrt_tools.project import Json

INCLUDED = re.compile(r'^`include "([^"]+)"', re.MULTILINE)
# What FuseSoC calls a file, by its suffix.
TYPES = {".v": "verilogSource", ".vlt": "vlt", ".sdc": "SDC", ".lpf": "LPF", ".xdc": "xdc"}
LINT = {"verilator": {"mode": "lint-only", "verilator_options": ["-Wall"]}}
LINT_ULX3S = {"verilator": {"mode": "lint-only", "verilator_options": ["-Wall", "--timing"]}}
HEAD = """\
CAPI=2:
# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# Made by scripts/file_lists; do not edit.
"""
BOARD_TIMING = "constraints/dynrt_board.sdc"


@dataclass(frozen=True)
class Target:
    """A top; the files of its hierarchy belong to it."""

    top: str
    core: str = "fast_port"
    tools: Json = field(default_factory=dict)  # for FuseSoC, the default one first
    beside: tuple[str, ...] = ()  # patterns of other files
    without: tuple[str, ...] = ()  # modules that the vendor's tool has or makes

    def files(self, made: pathlib.Path | None) -> list[pathlib.Path]:
        """Sources, headers, and what stands beside them; `made` is the folder of the build."""
        if there := rtl_files.checked_in(self.core):
            core = rtl_files.units_in(there)
        else:
            assert made is not None  # or the target is left out
            core = rtl_files.units_in(made / self.core)
        needed = synthesis.needed(self.top, rtl_files.sources(core, made))
        sources = [path for path in needed if path.stem not in self.without]
        included = {name for p in sources for name in INCLUDED.findall(p.read_text("utf-8"))}
        folders = [project.ROOT / "rtl/board", *rtl_files.include_folders(sources)]
        headers = {f / name for f in folders for name in included if (f / name).is_file()}
        waivers = ["rtl/lint/*.vlt"] if "verilator" in self.tools else []
        patterns = (*waivers, *self.beside)
        return sources + sorted(headers) + [p for b in patterns for p in found(b)]


def found(pattern: str) -> list[pathlib.Path]:
    return sorted(project.ROOT.glob(pattern))


TARGETS = {
    "default": Target("dynrt_board", "thesis"),
    "core_alone": Target("dynrt_core", "thesis"),
    "lint": Target("dynrt_board", "thesis", LINT),
    "synth": Target("dynrt_board", "thesis", {"yosys": {"arch": "ecp5"}}, (BOARD_TIMING,)),
    "link": Target("board_link"),
    "display": Target("ecp5_display"),
    # The same board around a core with a memory port, whose pins are the top's.
    "port_synth": Target(
        "dynrt_board",
        tools={"yosys": {"arch": "ecp5"}},
        beside=(BOARD_TIMING, "constraints/memory_port.sdc"),
    ),
    "axi": Target("dynrt_axi"),
    "wishbone": Target("dynrt_wishbone"),
    "axi_lint": Target("dynrt_axi", tools=LINT),
    "wishbone_lint": Target("dynrt_wishbone", tools=LINT),
    "axi_example": Target("axi_system", tools=LINT),
    "wishbone_example": Target("wishbone_system", tools=LINT),
    "ulx3s": Target(
        "dynrt_ulx3s",
        "fast_ulx3s",
        {
            "trellis": {
                "yosys_synth_options": ["-nowidelut"],
                "nextpnr_options": ["--85k", "--package", "CABGA381", "--speed", "6"],
            }
        },
        ("constraints/ulx3s.lpf",),
    ),
    "ulx3s_lint": Target(
        "dynrt_ulx3s", "fast_ulx3s", LINT_ULX3S, ("verif/vendor/*.v", "verif/vendor/*.vlt")
    ),
    "serial": Target("dynrt_serial"),
    "serial_lint": Target("dynrt_serial", tools=LINT),
    # Vivado makes the DDR3's controller (docs/how-to/arty.md).
    "arty": Target(
        "dynrt_arty",
        tools={"vivado": {"part": "xc7a100tcsg324-1"}},
        beside=("constraints/arty_a7.xdc",),
        without=("mig_7series_0",),
    ),
    "arty_lint": Target("dynrt_arty", tools=LINT),
    "arty_synth": Target("dynrt_arty", tools={"yosys": {"arch": "xilinx"}}),
}
LISTS = {
    "dynrt_core.f": "core_alone",
    "dynrt_board.f": "default",
    "dynrt_lint.f": "lint",
    "dynrt_axi.f": "axi_lint",
    "dynrt_wishbone.f": "wishbone_lint",
    "axi_system.f": "axi_example",
    "wishbone_system.f": "wishbone_example",
    "dynrt_serial.f": "serial_lint",
    "dynrt_arty.f": "arty",
    "dynrt_ulx3s.f": "ulx3s",
}
Named = Callable[[pathlib.Path], str]  # what a file is called in a list


def file_list(target: Target, files: Iterable[pathlib.Path], named: Named) -> str:
    """The text of a list."""
    lines = []
    if "verilator" in target.tools:
        lines += [*target.tools["verilator"]["verilator_options"], f"--top-module {target.top}"]
    folders = {path.parent for path in files if path.suffix == ".vh"}
    lines += sorted(f"+incdir+{named(folder)}" for folder in folders)
    # Waivers hold for the files after them; constraints are for other tools than read lists.
    for suffix in (".vlt", ".v"):
        lines += [named(path) for path in files if path.suffix == suffix]
    return "".join(f"{line}\n" for line in lines)


def core_file(files: dict[str, list[pathlib.Path]], named: Named) -> str:
    """The text of dynrt.core for the targets of these names, with their files."""
    version = project.searched(
        r"project\(dynrt VERSION ([\d.]+)", (project.ROOT / "CMakeLists.txt").read_text("utf-8")
    )
    filesets: dict[str, Json] = {}
    targets: dict[str, Json] = {}
    for name, paths in files.items():
        used = []
        for suffix, kind in TYPES.items():
            of_kind = [
                p for p in paths if p.suffix == suffix or (suffix, p.suffix) == (".v", ".vh")
            ]
            fileset = {
                "files": [
                    {named(p): {"is_include_file": True}} if p.suffix == ".vh" else named(p)
                    for p in of_kind
                ],
                "file_type": kind,
            }
            same = next((n for n, known in filesets.items() if known == fileset), "")
            if of_kind:
                used.append(same or f"{name}_{suffix[1:]}")
                filesets[used[-1]] = fileset
        target = TARGETS[name]
        targets[name] = {"filesets": used, "toplevel": target.top}
        if target.tools:
            targets[name] |= {"default_tool": next(iter(target.tools)), "tools": target.tools}
    core = {
        "name": f"dynrt::dynrt:{version[1]}",
        "description": "Ray tracing core for dynamic scenes",
        "filesets": filesets,
        "targets": targets,
    }
    text = yaml.dump(core, Dumper=_Plain, sort_keys=False, width=100)
    return f"{HEAD}{text}"


class _Plain(yaml.SafeDumper):
    """Writes a value that occurs twice twice."""

    def ignore_aliases(self, data: object) -> bool:
        return True


def checked_in_core_file() -> str:
    """That of the project's folder: the targets whose Verilog is checked in."""
    targets = {n: t.files(None) for n, t in TARGETS.items() if rtl_files.checked_in(t.core)}
    return core_file(targets, lambda path: path.relative_to(project.ROOT).as_posix())


def installed(path: pathlib.Path, made: pathlib.Path | None) -> str:
    """A file's name in an installed folder `rtl`, which has the constraints beside its own."""
    if made and path.is_relative_to(made):
        return f"generated/{path.relative_to(made)}"
    if path.parent.name == "constraints":
        return path.name
    return path.relative_to(project.ROOT / "rtl").as_posix()


def texts(made: pathlib.Path | None, relative: bool) -> dict[str, str]:
    """The text of each file, by its name, for the targets that there is the Verilog of."""
    files = {n: t.files(made) for n, t in TARGETS.items() if made or rtl_files.checked_in(t.core)}
    if relative:  # models of vendors' cells are for tests, and not installed
        files = {n: paths for n, paths in files.items() if "vendor" not in str(paths[-1].parent)}

    def named(path: pathlib.Path) -> str:
        return installed(path, made) if relative else str(path)

    lists = {
        name: file_list(TARGETS[target], files[target], named)
        for name, target in LISTS.items()
        if target in files
    }
    return {**lists, "dynrt.core": core_file(files, named)}


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/file_lists",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "folder",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the folder that receives them; in the project's own, dynrt.core has the targets whose "
        "Verilog is checked in, and no list is written",
    )
    parser.add_argument(
        "--relative",
        action="store_true",
        help="name files from the folder rtl on, for lists that move with a copy of it: "
        "-F of Verilator reads such a list, and other tools that run there",
    )
    rtl_files.add_build(parser)
    args = parser.parse_args()
    if not args.folder.is_dir():
        project.fail(f"there is no folder '{args.folder}'; create it or name another")
    if args.folder.samefile(project.ROOT):
        written = {"dynrt.core": checked_in_core_file()}
    else:
        written = texts(boards_of(args.build), args.relative)
    for name, text in written.items():
        try:
            (args.folder / name).write_text(text, encoding="utf-8")
        except OSError as error:
            project.fail(f"{args.folder / name}: cannot be written: {error.strerror}")
    return 0


def boards_of(build: pathlib.Path | None) -> pathlib.Path | None:
    """The folder with the Verilog of boards; says what is left out without it."""
    try:
        rtl_files.find_build(build)
    except project.Failed as error:
        print(f"file_lists: cores behind a port are left out: {error}", file=sys.stderr)
        return None
    try:
        return rtl_files.made_by(build, rtl_files.FOR_BOARDS)
    except project.Failed as error:
        project.fail(error)
