# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/reference/units.md: each unit's signals, state and latency, from hlsc.

scripts/unit_sheet FOLDER --write FILE.md   writes the page
scripts/unit_sheet FOLDER --check FILE.md   fails if FILE.md says anything else

FOLDER is build/PRESET/generated/CONFIG: the join (dynrt_core.json), and of every unit its Verilog
and its schedule report.
"""

import argparse
import pathlib
import re
import sys
from collections.abc import Iterable, Iterator
from typing import NoReturn

from dynrt_tools.project import Json, read_json

RAM = re.compile(
    r"hls_(ram_1r1w|register_file) #\(\.WIDTH\((\d+)\), \.ROWS\((\d+)\).*?\) "
    r"(\w+)_(?:ram|file) \("
)
SOURCE = re.compile(r"\b(units/\w+\.h)\b")
HEAD = """# The units of the core

Configuration `{config}`, scheduled for {clock}.
Every unit starts a transaction on every clock; *latency* is the clocks from its inputs to its
outputs, the FIFO at each output not counted. Widths are in bits, RAMs in rows x bits. Made by
`scripts/unit_sheet`; the target `units` renews it.

| unit | latency | registers between stages | RAM inside |
|---|---|---|---|
"""


def fail(message: str) -> NoReturn:
    sys.exit(f"unit_sheet: {message}")


def field(report: str, name: str) -> str:
    found = re.search(rf"^{name}\s+(.*)$", report, re.MULTILINE)
    if not found:
        fail(f"a schedule report has no line '{name}'")
    return found[1]


def signals(join: Json, unit: str) -> Iterator[tuple[str, str, str, str]]:
    """The unit's channels and shared RAMs: kind, the port's name, width, the other ends."""
    for channel in join["channels"]:
        for ends, others, kind in (("to", "from", "in"), ("from", "to", "out")):
            for end in channel[ends]:
                if end.startswith(unit + "."):
                    yield (
                        kind,
                        end.split(".")[1],
                        str(channel["width"]),
                        others_of(channel[others], "the board"),
                    )
    for ram in join["rams"]:
        size = f"{ram['rows']} x {ram['width']}"
        if ram["writer"].startswith(unit + "."):
            yield "writes", ram["writer"].split(".")[1], size, others_of(ram["readers"], "a bank")
        for reader in ram["readers"]:
            if reader.startswith(unit + "."):
                yield "reads", reader.split(".")[1], size, others_of([ram["writer"]], "a bank")


def others_of(ends: Iterable[str], outside: str) -> str:
    names = dict.fromkeys(re.sub(r"^slice_\d$", "slice", end.split(".")[0]) for end in ends)
    return ", ".join(f"`{name}`" for name in names) or outside


def page(folder: pathlib.Path) -> str:
    join = read_json(folder / "dynrt_core.json")
    # Units of one module, the four slices, are one row.
    units = {unit["module"]: unit["name"] for unit in reversed(join["units"])}
    rows, sections, clock = [], [], ""
    for module, unit in reversed(units.items()):
        report = (folder / f"{module}.txt").read_text(encoding="utf-8")
        verilog = (folder / f"{module}.v").read_text(encoding="utf-8")
        clock = field(report, "clock")
        rams = [
            f"`{name}` {rows_} x {width}{' (LUT)' if kind == 'register_file' else ''}"
            for kind, width, rows_, name in RAM.findall(verilog)
        ]
        stages = int(field(report, "stages"))
        registers = field(report, "registers").split()[0]
        rows.append(
            f"| [{module}](#{module}) | {stages} | {registers} | {', '.join(rams) or '-'} |"
        )
        source = SOURCE.search(verilog)
        if not source:
            fail(f"{module}.v names no source under units/")
        sections.append(
            f"\n## {module}\n\n[hls/{source[1]}](../../hls/{source[1]})\n\n"
            f"![Timing of {module}](waves/{module}.svg)\n\n"
            "| | signal | bits | other end |\n|---|---|---|---|\n"
            + "".join(
                f"| {kind} | `{name}` | {width} | {other} |\n"
                for kind, name, width, other in signals(join, unit)
            )
        )
    return HEAD.format(config=folder.name, clock=clock) + "\n".join(rows) + "\n" + "".join(sections)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=pathlib.Path, help="what hlsc and the join made")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--write", type=pathlib.Path, metavar="FILE.md")
    what.add_argument("--check", type=pathlib.Path, metavar="FILE.md")
    args = parser.parse_args()
    if not (args.folder / "dynrt_core.json").exists():
        fail(f"{args.folder} holds no dynrt_core.json; build the target `verilog` first")
    text = page(args.folder)
    if args.write:
        args.write.write_text(text, encoding="utf-8")
    elif not args.check.exists() or args.check.read_text(encoding="utf-8") != text:
        fail(f"{args.check} is stale; `ninja units` writes it again")
