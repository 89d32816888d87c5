# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The comment at the head of a module of rtl/lib explains all its parameters and ports: below
"Parameters:" or "Ports:", a line "names  what they are", several names divided by commas."""

import re
import unittest

from dynrt_tools import project

FOLDER = project.ROOT / "rtl" / "lib"
DECLARED = re.compile(
    r"^\s*(parameter|input|output|inout)\b[^,)\n/]*?(\w+)\s*(?:=.*)?,?\s*(?://.*)?$"
)
DOCUMENTED = re.compile(r"^//   (\w+(?:, \w+)*)  +\S")


def declarations(text: str) -> dict[str, list[str]]:
    """The names of the module's parameters and of its ports, by section of the comment."""
    found: dict[str, list[str]] = {"Parameters": [], "Ports": []}
    head = text[text.index("\nmodule ") : text.index("\n);\n")]
    for line in head.splitlines():
        if match := DECLARED.match(line):
            found["Parameters" if match[1] == "parameter" else "Ports"].append(match[2])
    return found


def documented(text: str) -> dict[str, list[str]]:
    """The names that the comment before the module explains, by section."""
    found: dict[str, list[str]] = {}
    section = None
    for line in text[: text.index("\nmodule ")].splitlines():
        if match := re.match(r"^// (Parameters|Ports):$", line):
            section = found.setdefault(match[1], [])
        elif section is not None and (match := DOCUMENTED.match(line)):
            section += match[1].split(", ")
    return found


def problems(name: str, text: str) -> list[str]:
    """What the comment lacks or has too much, as sentences."""
    listed = []
    explained = documented(text)
    for section, names in declarations(text).items():
        known = explained.get(section, [])
        for missing in [n for n in names if n not in known]:
            listed.append(f'{name}: {missing} is not explained below "// {section}:"')
        for extra in [n for n in known if n not in names]:
            listed.append(f'{name}: {extra}, explained below "// {section}:", does not exist')
    return listed


class DocumentedTest(unittest.TestCase):
    """The modules, and the check itself."""

    def test_modules(self) -> None:
        """All modules of rtl/lib."""
        modules = sorted(FOLDER.glob("*.v"))
        self.assertGreater(len(modules), 5)
        for module in modules:
            text = module.read_text(encoding="utf-8")
            declared = declarations(text)
            self.assertGreater(len(declared["Ports"]), 2, f"{module.name}: no ports are found")
            self.assertGreater(len(declared["Parameters"]), 0, f"{module.name}: no parameters")
            self.assertEqual(problems(module.name, text), [])

    def test_finds_what_is_missing(self) -> None:
        """A port and a parameter without a line, and a line without a port."""
        text = (FOLDER / "hls_fork.v").read_text(encoding="utf-8")
        bad = text.replace("//   valid_i, ready_o, data_i", "//   valid_i, ready_o, gone_i")
        bad = bad.replace("//   WIDTH", "//  WIDTH")
        self.assertEqual(
            problems("hls_fork.v", bad),
            [
                'hls_fork.v: WIDTH is not explained below "// Parameters:"',
                'hls_fork.v: data_i is not explained below "// Ports:"',
                'hls_fork.v: gone_i, explained below "// Ports:", does not exist',
            ],
        )


if __name__ == "__main__":
    unittest.main()
