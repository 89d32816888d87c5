# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The comment at the head of a module of rtl/lib explains all its parameters and ports: below
"Parameters:" or "Ports:", a line "names  what they are", several names divided by commas. The line of
a parameter says which values it may have."""

import re
import unittest

from dynrt_tools import project

FOLDER = project.ROOT / "rtl" / "lib"
DECLARED = re.compile(
    r"^\s*(parameter|input|output|inout)\b[^,)\n/]*?(\w+)\s*(?:=.*)?,?\s*(?://.*)?$"
)
DOCUMENTED = re.compile(r"^//   (\w+(?:, \w+)*)  +\S")
RANGE = re.compile(
    r"at least \w+$|at least 0 and fewer|\d+ to \d+|else 0$|power of two|follows from"
)


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


def without_range(text: str) -> list[str]:
    """The parameters whose line does not say which values they may have."""
    lines = text.partition("// Parameters:\n")[2].partition("//\n")[0].splitlines()
    return [line.split()[1] for line in lines if not RANGE.search(line)]


def problems(name: str, text: str) -> list[str]:
    """What the comment lacks or has too much, as sentences."""
    listed = [f"{name}: the line of {n} does not say its range" for n in without_range(text)]
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
        bad = bad.replace("//   WIDTH", "//  WIDTH").replace("readers, at least 1", "readers")
        self.assertEqual(
            problems("hls_fork.v", bad),
            [
                "hls_fork.v: the line of OUTPUTS does not say its range",
                'hls_fork.v: WIDTH is not explained below "// Parameters:"',
                'hls_fork.v: data_i is not explained below "// Ports:"',
                'hls_fork.v: gone_i, explained below "// Ports:", does not exist',
            ],
        )


if __name__ == "__main__":
    unittest.main()
