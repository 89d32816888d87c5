# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Looks for two messages of one name and namespace in the tables *_messages.h: the linker would keep
one of the two texts, and the program would print it for both. And for messages below the program,
host/app, that name one of its flags: other programs use that code, and have other flags.
"""

import pathlib
import re
import unittest

from dynrt_tools import project, testing

FOLDERS = ("host", "hls", "verif")
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$", re.MULTILINE)
MESSAGE = re.compile(r"^inline constexpr \w[\w:]* (\w+)(?:\[\])? *=", re.MULTILINE)

COMMENT = re.compile(r"^\s*//.*")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
SCRIPT = re.compile(r"scripts/\w+(?: --?[\w-]+)*")
FLAG = re.compile(r"(?!^--[\w-]+$)(?:^|.*?[\s'(])(--[a-z][\w-]*)")


def messages_of(root: pathlib.Path) -> list[tuple[str, str]]:
    """The full name of every message, and the file and line where it stands."""
    found = []
    for path in sorted(p for folder in FOLDERS for p in (root / folder).rglob("*_messages.h")):
        text = path.read_text(encoding="utf-8")
        namespace = project.searched(NAMESPACE.pattern, text)[1]
        for match in MESSAGE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            place = f"{path.relative_to(root).as_posix()}:{line}"
            found.append((f"{namespace}::{match[1]}", place))
    return found


def repeated(messages: list[tuple[str, str]]) -> list[str]:
    """A sentence for each message whose name another one has before it."""
    first: dict[str, str] = {}
    sentences = []
    for name, place in messages:
        if name in first:
            sentences.append(f"{place}: {name} stands in {first[name]} too; rename one")
        first.setdefault(name, place)
    return sentences


def messages_with_flags(root: pathlib.Path) -> list[str]:
    """A sentence for each text with the flag of a program below host/app. A flag that stands alone
    is an argument for a script, and one behind a script's name is that script's."""
    sentences = []
    for path in sorted((root / "host").rglob("*")):
        name = path.relative_to(root).as_posix()
        if path.suffix not in (".h", ".cpp", ".in") or path.stem.endswith("_test"):
            continue
        if name.startswith("host/app/"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            for text in LITERAL.findall(COMMENT.sub("", line)):
                if flag := FLAG.search(SCRIPT.sub("", text)):
                    sentences.append(
                        f"{name}:{number}: a message names the flag {flag[1]}, which only host/app "
                        "knows; name the value, or move the message there"
                    )
    return sentences


class Messages(testing.InFolder):
    def test_no_two_have_one_name(self) -> None:
        found = messages_of(project.ROOT)
        self.assertGreater(len(found), 5)
        self.assertEqual(repeated(found), [])

    def test_a_name_in_two_tables_is_found(self) -> None:
        table = 'namespace {} {{\n\ninline constexpr char kNone[] =\n    "none";\n\n}}\n'
        testing.write_tree(
            self.folder,
            {
                "host/a/a_messages.h": table.format("our::messages"),
                "host/b/b_messages.h": table.format("our::messages"),
                "host/c/c_messages.h": table.format("our::other::messages"),
            },
        )
        self.assertEqual(
            repeated(messages_of(self.folder)),
            [
                "host/b/b_messages.h:3: our::messages::kNone stands in host/a/a_messages.h:3 too; "
                "rename one"
            ],
        )

    def test_none_below_the_program_names_a_flag(self) -> None:
        self.assertEqual(messages_with_flags(project.ROOT), [])

    def test_a_flag_below_the_program_is_found(self) -> None:
        testing.write_tree(
            self.folder,
            {
                "host/app/a_messages.h": 'char kA[] = "--size {}: too large";\n',
                "host/board/a_test.cpp": 'expect("--size 3: too large");\n',
                "host/board/b_messages.h": 'char kB[] =\n    "{}: no such board; give --board";\n',
                "host/board/run.cpp": 'run("scripts/test --build-only", "--rtl");\n// "--size 3: x"\n',
                "host/render/c.cpp": 'throw UserError("--size 0: write more");\n',
            },
        )
        self.assertEqual(
            [sentence.partition(", which")[0] for sentence in messages_with_flags(self.folder)],
            [
                "host/board/b_messages.h:2: a message names the flag --board",
                "host/render/c.cpp:1: a message names the flag --size",
            ],
        )


if __name__ == "__main__":
    unittest.main()
