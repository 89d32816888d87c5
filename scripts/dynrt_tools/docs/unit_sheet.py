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
PORT = re.compile(r"^  (?:input|output) +wire (?:\[(\d+):0\] )?(\w+),?$", re.MULTILINE)
SOURCE = re.compile(r"\b(units/\w+\.h)\b")
# The unit that stands beside the core on the board.
BESIDE = "scan_out"
HEAD = """# The units of the core

Configuration `{config}`, scheduled for {clock}.
Every unit can start a transaction in every clock. *Latency* is the number of clocks from a token at its input
to the tokens after the FIFOs of its outputs: its stages. Widths are in bits, RAMs in rows x bits as
the unit addresses them.

A channel `x` that comes **in** is `x_valid_i`, `x_ready_o` and `x_data_i` in Verilog; one that goes **out** is
`x_valid_o`, `x_ready_i` and `x_data_o`. A RAM `x` that the unit **reads** is `x_en_o`, `x_addr_o` and
`x_data_i`; one that it **writes** has `x_data_o`. A **steady** value `x` is `x_i`, which does not change during a
frame. Each module also has `clk_i`, `rst_ni`, and for the counters `fire_o` (a transaction starts) and
`stall_o` (one could, but an output has no space). The parameters `X_DEPTH` and `X_BOUNDED` size the FIFO of the
output `x` ([Timing](timing.md) explains them). The last unit, `scan_out`, is on the board, outside the core.
`scripts/unit_sheet` makes this page; the target `units` renews it.

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


def other_ends(join: Json, unit: str) -> dict[str, str]:
    """What stands at the other end of each of the unit's ports, by the port's name."""
    found = {}
    for channel in join["channels"]:
        for ends, others in (("to", "from"), ("from", "to")):
            for end in channel[ends]:
                if end.startswith(unit + "."):
                    found[end.split(".")[1]] = others_of(channel[others], "the board")
    for ram in join["rams"]:
        for end in [ram["writer"], *ram["readers"]]:
            if end.startswith(unit + "."):
                opposite = ram["readers"] if end == ram["writer"] else [ram["writer"]]
                found[end.split(".")[1]] = others_of(opposite, "a bank")
    for bank in join["banks"]:
        if bank["port"].startswith(unit + "."):
            found[bank["port"].split(".")[1]] = f"{bank['name']} of the board"
    return found


def signals(verilog: str) -> Iterator[tuple[str, str, str]]:
    """The ports of a module without those that each has: kind, name, width."""
    bits = {name: int(high or 0) + 1 for high, name in PORT.findall(verilog)}
    for name in bits:
        stem = re.sub(r"_(valid_[io]|en_o|i)$", "", name)
        if name.endswith("_valid_i"):
            yield "in", stem, str(bits.get(f"{stem}_data_i", 0))
        elif name.endswith("_valid_o"):
            yield "out", stem, str(bits.get(f"{stem}_data_o", 0))
        elif name.endswith("_en_o"):
            kind = "reads" if f"{stem}_data_i" in bits else "writes"
            word = bits[f"{stem}_data_i" if kind == "reads" else f"{stem}_data_o"]
            yield kind, stem, f"{1 << bits.get(f'{stem}_addr_o', 0):,} x {word}"
        elif name.endswith("_i") and not re.search(r"_(data|ready)_i$|^(clk|rst_n)", name):
            yield "steady", stem, str(bits[name])


def others_of(ends: Iterable[str], outside: str) -> str:
    names = dict.fromkeys(re.sub(r"^slice_\d+$", "slice", end.split(".")[0]) for end in ends)
    return ", ".join(f"`{name}`" for name in names) or outside


def page(folder: pathlib.Path) -> str:
    join = read_json(folder / "dynrt_core.json")
    # Units of one module, the four slices, are one row. No join has the unit beside the core.
    units = {BESIDE: BESIDE} | {unit["module"]: unit["name"] for unit in reversed(join["units"])}
    rows, sections, clock = [], [], ""
    for module, unit in reversed(units.items()):
        report = (folder / f"{module}.txt").read_text(encoding="utf-8")
        verilog = (folder / f"{module}.v").read_text(encoding="utf-8")
        clock = field(report, "clock")
        others = other_ends(join, unit)
        outside = "the board" if unit == BESIDE else "the join"
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
                for kind, name, width in signals(verilog)
                for other in (others.get(name, "the frame" if name == "frame" else outside),)
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
