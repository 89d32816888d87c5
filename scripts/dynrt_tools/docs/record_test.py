# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Every command of runs.json is one that its program takes, and writes the data that it stands for."""

import argparse
import importlib
import pathlib
import re
import unittest
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.docs import record, results

RUNS = project.read_json(results.RESULTS / "data" / "runs.json")
REFERENCE = project.ROOT / "docs" / "reference" / "commands.md"
# Data that a command writes without naming the file.
OWN = {
    "fit_ecp5": "scripts/fit-delays --record",
    "fit_ecp5_8": "scripts/fit-delays --record",
    "fit_ice40_hx": "scripts/fit-delays --record",
    "build": "scripts/docs --times",
}


class Parsed(Exception):
    """The parser of a script took the words."""


def parse_script(words: list[str]) -> None:
    """Gives the words to the script's own parser; throws Parsed, or SystemExit where it refuses."""
    script = (project.ROOT / words[0]).read_text(encoding="utf-8")
    module = project.searched(r'command\.run\("([\w.]+)"\)', script)[1]
    main = importlib.import_module(f"dynrt_tools.{module}").main
    parse_args = argparse.ArgumentParser.parse_args

    def parsed(*arguments: object, **named: object) -> None:
        raise Parsed(parse_args(*arguments, **named))  # type: ignore[call-overload]

    with mock.patch.object(argparse.ArgumentParser, "parse_args", parsed):
        with mock.patch("sys.argv", words), mock.patch("sys.stderr"):
            main()


def unknown_flags(words: list[str], reference: str) -> list[str]:
    """The words of a call of dynrt that its help, as the reference shows it, does not have."""
    name = re.match(r"dynrt( [a-z]+)*", " ".join(["dynrt", *words[1:]]))
    assert name
    for end in range(len(name[0].split()), 1, -1):
        title = " ".join(name[0].split()[:end])
        section = re.search(rf"^#+ {title}$(.*?)^#", f"{reference}\n#", re.M | re.S)
        if section:
            flags = [word for word in words if word.startswith("--")]
            return [f for f in flags if not re.search(rf"{f}\b", section[1])]
    return words[1:2]


class Commands(unittest.TestCase):
    def test_each_is_one_that_its_program_takes(self) -> None:
        reference = REFERENCE.read_text(encoding="utf-8")
        for name, run in RUNS.items():
            for words in map(str.split, filter(None, run.get("command", "").split(" && "))):
                with self.subTest(f"{name}: {' '.join(words)}"):
                    if words[0].startswith("scripts/"):
                        self.assertRaises(Parsed, parse_script, words)
                    else:
                        self.assertEqual(words[0], "build/release/dynrt")
                        self.assertEqual(unknown_flags(words, reference), [])

    def test_each_writes_its_data(self) -> None:
        for name, run in RUNS.items():
            if name in OWN:
                self.assertIn(OWN[name], run["command"])
            elif "command" in run:
                file = re.escape(f"docs/results/data/{name}.json")
                self.assertRegex(run["command"], rf"--(json|record|data) {file}$")

    def test_wrong_ones_are_found(self) -> None:
        for wrong in ("scripts/bench --scene", "scripts/place --recrd x", "scripts/synth --jobs a"):
            with self.assertRaises(SystemExit, msg=wrong):
                parse_script(wrong.split())
        reference = REFERENCE.read_text(encoding="utf-8")
        for wrong, flag in (("info office --jsn x", "--jsn"), ("paint office", "paint")):
            words = ["build/release/dynrt", *wrong.split()]
            self.assertEqual(unknown_flags(words, reference), [flag])

    def test_data_commands_and_pages_belong_together(self) -> None:
        shown = {
            name for page in results.TEMPLATES.glob("*.md") for name in record.data_of(page.stem)
        }
        kept = {path.stem for path in (results.RESULTS / "data").glob("*.json")} - {"runs"}
        self.assertEqual(shown, kept)
        self.assertEqual(set(RUNS), kept)


class Record(testing.InFolder):
    def test_commands_run_in_order_until_one_fails(self) -> None:
        file = pathlib.Path(self.folder, "ran")
        calls = [
            (f"echo {n} >> {file}; exit {code}", [0, 1]) for n, code in enumerate((0, 1, 2, 0))
        ]
        with (
            mock.patch.object(record, "commands", lambda page: calls),
            mock.patch("builtins.print"),
        ):
            with self.assertRaisesRegex(project.Failed, "ends with 2; the data of x are not whole"):
                record.record("x")
        self.assertEqual(file.read_text(encoding="utf-8").split(), ["0", "1", "2"])

    def test_an_unknown_page_lists_those_that_there_are(self) -> None:
        with self.assertRaisesRegex(
            project.Failed,
            "--record speed: unknown; the pages are boards, build, devices, .*stress",
        ):
            record.commands("speed")


if __name__ == "__main__":
    unittest.main()
