# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the README against the project: its length, and the files and folders that it names."""

import re
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")


class Readme(unittest.TestCase):
    def test_it_is_short(self) -> None:
        self.assertLessEqual(len(README.splitlines()), 120)

    def test_folders_are_those_of_the_project(self) -> None:
        listed = re.findall(
            r"^    ([\w/]+)  +\S",
            README.partition("## Where things are")[2].partition("\n## ")[0],
            re.MULTILINE,
        )
        for folder in listed:
            self.assertTrue((ROOT / folder).is_dir(), folder)
        tops = {folder.partition("/")[0] for folder in listed}
        there = {p.name for p in ROOT.iterdir() if p.is_dir() and p.name[0] not in "._"} - {"build"}
        self.assertEqual(tops, there)

    def test_files_that_it_names_are_there(self) -> None:
        names = re.findall(r"\]\(([\w./-]+)\)", README)
        names += re.findall(r"`((?:hls|docs|scripts)/[\w./-]+)`", README)
        names += re.findall(r"^    (scripts/[\w-]+)", README, re.MULTILINE)
        names = [name for name in names if "NAME" not in name]
        self.assertGreater(len(names), 8)
        for name in names:
            self.assertTrue((ROOT / name).exists(), name)

    def test_the_placed_clock_is_that_of_the_results(self) -> None:
        words: list[str] = []
        for name in ("thesis", "full", "fast"):
            clock = placed_clocks.of(name)
            self.assertEqual((clock.configuration, clock.seeds), (name, 3))
            self.assertEqual(clock.where, "Lattice LFE5U-85F, grade 6")  # "the slowest grade"
            words.append(
                f"`{name}`{' reaches' if not words else ''} {clock.mhz:g} MHz ({clock.day})"
            )
        said = f"{project.enumerated(words)}, medians of three seeds."
        self.assertIn(said, README.replace("\n", " "))


if __name__ == "__main__":
    unittest.main()
