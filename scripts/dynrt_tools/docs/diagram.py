# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Draws the core's block diagram, grouped for a reader, from what the join of the units says.

scripts/diagram CORE.json --write FILE.svg   draws it (needs Graphviz)
scripts/diagram CORE.json --check FILE.svg   fails if FILE.svg shows other boxes or channels

CORE.json is build/PRESET/generated/thesis/dynrt_core.json. Units that work side by side are one
box, channels between the same two boxes one arrow.
"""

import argparse
import html
import pathlib
import re
import subprocess
import sys
from collections.abc import Iterator
from typing import NoReturn

from dynrt_tools.project import Json, read_json

# Which box of the picture stands for which units of the join.
MERGED = [
    (re.compile(r"slice_\d+"), "traversal_slice"),
    (re.compile(r"(\w+)_(lookup|fill)"), r"\1_cache"),
    (re.compile(r"bank[0-2]"), "scene_banks"),
    (re.compile(r"bank3"), "frame_bank"),
    (re.compile(r"bank[45]"), "hit_banks"),
]
LABELS = {
    "traversal_slice": "traversal slice\\n4 side by side",
    "scene_banks": "SRAM banks 0 to 2\\nnodes, lists, matrices",
    "frame_bank": "SRAM bank 3\\npixels",
    "hit_banks": "SRAM banks 4 and 5\\nhit records",
}
# The boxes of each group; from, to and style of each arrow, with its channels.
Groups = dict[str, dict[str, None]]
Arrows = dict[tuple[str, str, str], set[str]]
BANKS_GROUP = "Memory"
# Of the groups in the order of the join, over again if there are more.
COLOURS = ("#fff3d6", "#dcebfa", "#e4f3de", "#fbe3e0", "#ece4f7", "#eeeeee")
TITLE = re.compile(r'<g id="\w+" class="(?:node|edge)">\s*<title>(.*?)</title>', re.DOTALL)


def fail(message: str) -> NoReturn:
    sys.exit(f"diagram: {message}")


def box_of(port: str) -> str:
    unit = port.partition(".")[0]
    for pattern, box in MERGED:
        if pattern.fullmatch(unit):
            return pattern.sub(box, unit)
    return unit


def ends_of(join: Json) -> Iterator[tuple[str, str, str, str]]:
    """All that connects two boxes: from, to, name, and how it is drawn."""
    for channel in join["channels"]:
        for source in channel["from"]:
            yield from ((source, to, channel["name"], "solid") for to in channel["to"])
    for ram in join["rams"]:
        yield from ((ram["writer"], reader, ram["name"], "dashed") for reader in ram["readers"])
    for bank in join["banks"]:
        port, name = bank["port"], bank["name"]
        yield (port, name, "", "bold") if bank["write"] else (name, port, "", "bold")


def read(path: pathlib.Path) -> tuple[Groups, Arrows]:
    """The boxes of each group, and for each pair of boxes and kind of arrow the channels on it."""
    try:
        join = read_json(path)
        groups: Groups = {}
        arrows: Arrows = {}
        for unit in join["units"]:
            if not unit["group"]:
                fail(
                    f"unit '{unit['name']}' has no group; call join.group() before it is named in "
                    "hls/units/core.h"
                )
            groups.setdefault(unit["group"], {})[box_of(unit["name"])] = None
        for bank in join["banks"]:
            groups.setdefault(BANKS_GROUP, {})[box_of(bank["name"])] = None
        for source, target, channel, style in ends_of(join):
            ends = box_of(source), box_of(target)
            # Within a box there is nothing to show, unless the unit sends to itself.
            if ends[0] == ends[1] and source.partition(".")[0] != target.partition(".")[0]:
                continue
            arrows.setdefault((*ends, style), set()).add(re.sub(r"_\d$", "", channel))
    except (OSError, ValueError, KeyError, TypeError) as error:
        fail(f"{path} is no dynrt_core.json of this project ({error}); build the target `verilog`")
    return groups, arrows


def look(source: str, target: str, style: str) -> str:
    """Packets on their way are black, RAMs shared by two units dashed, memory traffic grey."""
    memory = any(end.startswith("memory_") for end in (source, target))
    if memory or (source == "startup" and "cache" in target):
        return ', color="#999999", fontcolor="#777777", constraint=false'
    if style == "dashed":
        return ', style=dashed, color="#3b6ea5", fontcolor="#3b6ea5"'
    return ", penwidth=2" if style == "bold" else ", weight=2"


def drawn(groups: Groups, arrows: Arrows) -> str:
    """The dot source of the grouped diagram."""
    lines = [
        "digraph core {",
        '  rankdir=TB; nodesep=0.35; ranksep=0.45; fontname="Helvetica";',
        '  node [shape=box, style="filled,rounded", fillcolor=white, fontname="Helvetica", '
        "fontsize=12];",
        '  edge [fontname="Helvetica", fontsize=9, arrowsize=0.7];',
    ]
    for number, (group, boxes) in enumerate(groups.items()):
        lines.append(
            f'  subgraph cluster_{number} {{ label="{group}"; style="filled,rounded"; '
            f'color="{COLOURS[number % len(COLOURS)]}"; fontsize=13;'
        )
        lines += [f'    {box} [label="{LABELS.get(box, box.replace("_", " "))}"];' for box in boxes]
        lines.append("  }")
    for (source, target, style), channels in sorted(arrows.items()):
        label = "\\n".join(c.replace("_", " ") for c in sorted(channels) if c)
        lines.append(f'  {source} -> {target} [label="{label}"{look(source, target, style)}];')
    return "\n".join([*lines, "}"]) + "\n"


def titles(groups: Groups, arrows: Arrows) -> list[str]:
    """What Graphviz calls the boxes and arrows in the SVG."""
    boxes = [box for group in groups.values() for box in group]
    return sorted(boxes + [f"{source}->{target}" for source, target, _ in arrows])


def labels(groups: Groups, arrows: Arrows) -> set[str]:
    channels = {c.replace("_", " ") for some in arrows.values() for c in some if c}
    return channels | set(groups)


def check(groups: Groups, arrows: Arrows, path: pathlib.Path) -> None:
    if not path.exists():
        fail(f"{path} is missing; `ninja diagram` draws it")
    svg = path.read_text(encoding="utf-8")
    shown = sorted(html.unescape(title) for title in TITLE.findall(svg))
    texts = {html.unescape(text) for text in re.findall(r"<text[^>]*>([^<]*)</text>", svg)}
    differing = sorted(set(shown) ^ set(titles(groups, arrows))) or sorted(
        labels(groups, arrows) - texts
    )
    if differing or shown != titles(groups, arrows):
        fail(
            f"{path} is stale ({', '.join(differing) or 'arrows between the same boxes'}); "
            "`ninja diagram` draws it again"
        )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("core", type=pathlib.Path, help="the join: dynrt_core.json")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--write", type=pathlib.Path, metavar="FILE.svg")
    what.add_argument("--check", type=pathlib.Path, metavar="FILE.svg")
    args = parser.parse_args()
    groups, arrows = read(args.core)
    if args.check:
        check(groups, arrows, args.check)
        return
    try:
        result = subprocess.run(
            ["dot", "-Tsvg"],
            input=drawn(groups, arrows),
            capture_output=True,
            text=True,
            check=True,
        )
    except FileNotFoundError:
        fail("there is no program 'dot'; install Debian's package graphviz")
    args.write.write_text(result.stdout, encoding="utf-8")
