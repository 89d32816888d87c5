# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of the error messages, from the tables that hold their wordings."""

import html
import json
import pathlib
import re
from collections.abc import Iterator

from dynrt_tools import project

MESSAGE = re.compile(
    r"^inline constexpr (?:char (?:k\w+)\[\]|Text (?:k\w+)) ?=\s*"  # the name
    r'((?:"(?:[^"\\]|\\.)*"\s*)+);',  # its literals
    re.MULTILINE,
)
LITERAL = re.compile(r'"(?:[^"\\]|\\.)*"')
HOLE = re.compile(r"\{[^{}]*\}")
ROOMS = {"hls/compiler": "hlsc", "host": "dynrt"}


def tables() -> Iterator[pathlib.Path]:
    """The headers that hold wordings."""
    for room in ROOMS:
        yield from sorted((project.ROOT / room).rglob("*messages.h"))


def wordings(text: str) -> Iterator[str]:
    """The messages of a header, with … where a value stands."""
    for literals in MESSAGE.findall(text):
        words = "".join(json.loads(part) for part in LITERAL.findall(literals))
        yield HOLE.sub("…", words.replace("{{", "\0").replace("}}", "\1")).translate(
            {0: "{", 1: "}"}
        )


def page() -> str:
    """Every wording, by program and room."""
    lines = [
        "# Error messages",
        "",
        "`dynrt` prints a mistake in the input or the flags as one sentence and exits with 2; 3 "
        "is a defect of `dynrt` itself. `hlsc` and the scripts exit with 1. A sentence says what "
        "is wrong and what would be right; … stands for a value. What is wrong in a configuration "
        "is said with the file and the line.",
    ]
    for room, program in ROOMS.items():
        lines += ["", f"## {program}"]
        for path in tables():
            name = path.relative_to(project.ROOT)
            found = list(wordings(path.read_text(encoding="utf-8")))
            if name.is_relative_to(room) and found:
                lines += ["", f"### {name.parent}", ""]
                lines += [f"- {html.escape(words, quote=False).strip()}" for words in found]
    return "\n".join(lines) + "\n"
