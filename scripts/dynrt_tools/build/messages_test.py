# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Looks for messages of one name and namespace in two tables *_messages.h. The linker would keep one
text of the two without a word, and the other's program would print it."""

import pathlib
import re
import unittest

from dynrt_tools import project, testing

ROOMS = ("host", "hls", "verif")
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$", re.MULTILINE)
MESSAGE = re.compile(r"^inline constexpr \w[\w:]* (\w+)(?:\[\])? *=", re.MULTILINE)


def messages_of(root: pathlib.Path) -> list[tuple[str, str]]:
    """The full name of every message, and the file and line where it stands."""
    found = []
    for path in sorted(p for room in ROOMS for p in (root / room).rglob("*_messages.h")):
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


class Messages(testing.InFolder):
    def test_no_two_have_one_name(self) -> None:
        found = messages_of(project.ROOT)
        self.assertGreater(len(found), 100)
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


if __name__ == "__main__":
    unittest.main()
