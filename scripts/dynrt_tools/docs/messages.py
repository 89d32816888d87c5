# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of the error messages, from the sources that throw them."""

import ast
import html
import pathlib
import re
from collections.abc import Iterator

from dynrt_tools import project

LITERALS = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
TABLE = re.compile(rf"^inline constexpr (?:char k\w+\[\]|Text k\w+) ?=\s*{LITERALS};", re.MULTILINE)
CONSTANT = re.compile(rf"^constexpr char (k\w+)\[\] ?=\s*{LITERALS};", re.MULTILINE)
THROWN = re.compile(
    r"\b(?:refuse|refuse_option|UserError|Exceeded)\(\s*(?:fmt::format\(\s*)?"
    rf'(?:"\w+",\s*)?(?:{LITERALS}[,)]|(k\w+)\b)'
)
LITERAL = re.compile(r'"(?:[^"\\]|\\.)*"')
HOLE = re.compile(r"\{[^{}]*\}")
PROGRAMS = {"hls/compiler": "hlsc", "host": "dynrt"}


def wordings(path: pathlib.Path) -> list[str]:
    """The messages of a source in their order, with … where a value stands."""
    text = path.read_text(encoding="utf-8")
    if path.name.endswith("_messages.h"):
        return [worded(literals) for literals in TABLE.findall(text)]
    constants = dict(CONSTANT.findall(text))
    thrown = [literals or constants.get(name, "") for literals, name in THROWN.findall(text)]
    return [worded(literals) for literals in dict.fromkeys(thrown) if " " in literals]


def worded(literals: str) -> str:
    words = "".join(ast.literal_eval(part) for part in LITERAL.findall(literals))
    return HOLE.sub("…", words.replace("{{", "\0").replace("}}", "\1")).translate({0: "{", 1: "}"})


def sources(folder: pathlib.Path) -> Iterator[pathlib.Path]:
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".h", ".cpp") and not path.stem.endswith("_test"):
            yield path


def page() -> str:
    """Every wording, by program and folder."""
    lines = [
        "# Error messages",
        "",
        "`dynrt` prints a mistake in the input or the flags as one sentence and exits with 2; 3 "
        "is a defect of `dynrt` itself. `hlsc` and the scripts exit with 1. A sentence names the "
        "mistake and the correction; … stands for a value. A message about a configuration starts "
        "with its file and line.",
    ]
    for part, program in PROGRAMS.items():
        lines += ["", f"## {program}"]
        folders: dict[pathlib.Path, list[str]] = {}
        for path in sources(project.ROOT / part):
            folder = folders.setdefault(path.parent.relative_to(project.ROOT), [])
            folder += wordings(path)
        for name, found in folders.items():
            if found:
                lines += ["", f"### {name}", ""]
                lines += [f"- {html.escape(words, quote=False).strip()}" for words in found]
    return "\n".join(lines) + "\n"
