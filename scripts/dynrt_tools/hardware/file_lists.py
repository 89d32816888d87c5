# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes lists of the Verilog that dynrt.core describes, for tools that read files from a list:

    dynrt_core.f   the core
    dynrt_board.f  the core and its board
    dynrt_lint.f   the board for Verilator, with the waivers of rtl/lint, its top and -Wall
    dynrt_axi.f, dynrt_wishbone.f      the core behind a bus, likewise
    axi_system.f, wishbone_system.f    the examples that have it beside a memory, likewise
    dynrt_serial.f  the core with its host on a serial line, likewise
    dynrt_arty.f, dynrt_ulx3s.f  the tops of boards, for the vendors' tools: without waivers, and
                                 without what such a tool knows or makes (rtl/arty/mig_7series_0.v)

The names are absolute, so a list works in every folder:
    verilator --lint-only -f FOLDER/dynrt_lint.f
    iverilog -g2005 -t null -s dynrt_core -f FOLDER/dynrt_core.f
"""


import argparse
import pathlib
from collections.abc import Iterator

import yaml
from dynrt_tools import project

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


def _lines(core: project.Json, target: project.Json, folder: pathlib.PurePath) -> Iterator[str]:
    """The lines of a target's list; its files' names are those of dynrt.core, after `folder`."""
    if options := target.get("tools", {}).get("verilator"):
        yield from options["verilator_options"]
        yield f"--top-module {target['toplevel']}"
    files = [f for s in target["filesets"] for f in core["filesets"][s]["files"]]
    headers = [name for f in files if isinstance(f, dict) for name in f]
    # Constraints are for other tools than those that read lists.
    sources = [f for f in files if not isinstance(f, dict) and f.endswith((".v", ".vlt"))]
    yield from sorted({f"+incdir+{(folder / header).parent}" for header in headers})
    # Waivers hold for the files after them.
    for name in sorted(sources, key=lambda name: not name.endswith(".vlt")):
        yield str(folder / name)


def lists(root: pathlib.Path, relative: bool = False) -> dict[str, str]:
    """The text of each list by its file's name, with absolute names or those from rtl/ on."""
    core = yaml.safe_load((root / "dynrt.core").read_text(encoding="utf-8").partition("\n")[2])
    texts = {}
    for name, target in LISTS.items():
        lines = "".join(f"{line}\n" for line in _lines(core, core["targets"][target], root))
        texts[name] = lines.replace(f"{root}/rtl/", "") if relative else lines
    return texts


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="scripts/file_lists",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "folder", type=pathlib.Path, metavar="FOLDER", help="the folder that receives them"
    )
    parser.add_argument(
        "--relative",
        action="store_true",
        help="name files from the folder rtl on, for lists that move with a copy of it: "
        "-F of Verilator reads such a list, and other tools that run there",
    )
    args = parser.parse_args()
    if not args.folder.is_dir():
        project.fail(f"there is no folder '{args.folder}'; create it or name another")
    for name, text in lists(project.ROOT, args.relative).items():
        try:
            (args.folder / name).write_text(text, encoding="utf-8")
        except OSError as error:
            project.fail(f"{args.folder / name}: cannot be written: {error.strerror}")
    return 0
