# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of the frames on the line between host and board, from the header that defines them."""

import itertools
import re

from dynrt_tools.docs import registers

FORMAT = "hls/units/link_format.h"
CONSTANT = re.compile(
    r"^inline constexpr unsigned (k\w+) =\s*([^;]+);(?:[ \t]*///<[ \t]*(.*))?$", re.MULTILINE
)
ENUMERATOR = re.compile(r"^  (k\w+)(?: = (\d+))?,(?:\s*///<\s*(.*))?$", re.MULTILINE)


def values(text: str, enum: str) -> list[tuple[str, int, str]]:
    """Name, number and meaning of each value of an enum that has a meaning beside it."""
    body = text.partition(f"enum {enum}")[2].partition("};")[0]
    found = []
    number = 0
    for name, stated, meaning in ENUMERATOR.findall(body):
        number = int(stated) if stated else number
        if meaning:
            found.append((name, number, meaning))
        number += 1
    return found


def enum_table(text: str, enum: str) -> list[str]:
    lines = ["| name | value | meaning |", "|---|---|---|"]
    for name, number, meaning in values(text, enum):
        lines.append(f"| `{name}` | {number} | {meaning} |")
    return lines


def constants(text: str) -> list[tuple[str, str, str]]:
    """Name, value and meaning of each number that has a meaning beside it."""
    return [(n, " ".join(v.split()), m) for n, v, m in CONSTANT.findall(text) if m]


def about(text: str) -> list[str]:
    """The comment at the head of the header, without the licence; examples stay indented."""
    head = itertools.takewhile(lambda line: line.startswith("//"), text.splitlines())
    return [line[3:] for line in head][3:]


def page() -> str:
    """The whole page."""
    text = registers.source(FORMAT)
    lines = ["| constant | value | meaning |", "|---|---|---|"]
    lines += [f"| `{name}` | `{value}` | {meaning} |" for name, value, meaning in constants(text)]
    return "\n".join(
        [
            "# Packets of the serial link",
            "",
            f"{registers.link(FORMAT)} defines them. [The link to a board](../explanation/link.md) "
            "explains their use.",
            "",
            *about(text),
            "",
            "## Commands",
            "",
            *enum_table(text, "class LinkCommand"),
            "",
            "## What a board says of itself",
            "",
            "Words of 32 bits in the answer to `kIdentify`:",
            "",
            *enum_table(text, "LinkIdentity"),
            "",
            "## Numbers",
            "",
            *lines,
            "",
        ]
    )
