# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the README against the project: its length, and the files and folders that it names."""

import re
import unittest

from dynrt_tools.project import ROOT, read_json

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

    def test_frame_rates_are_those_of_the_results(self) -> None:
        data = ROOT / "docs" / "results" / "data"
        measured = {
            (row["scene"], row["configuration"]): row["frames per second at 85 MHz"]
            for row in read_json(data / "scenes.json")["scenes"]
        }
        frame = read_json(data / "office_thesis.json")["frame"]
        measured["office", "thesis"] = 85e6 / frame["cycles"]
        rows = re.findall(r"^\| `(\w+)`.*?\| `(\w+)` \| ([\d.]+) \|", README, re.MULTILINE)
        self.assertEqual(len(rows), 5)
        for scene, configuration, shown in rows:
            self.assertAlmostEqual(float(shown), measured[scene, configuration], delta=0.051)

    def test_the_placed_clock_is_that_of_the_results(self) -> None:
        data = ROOT / "docs" / "results" / "data"
        core = read_json(data / "place_core.json")["units"]["dynrt_core"]
        cycles = read_json(data / "office_thesis.json")["frame"]["cycles"]
        synth = read_json(data / "synth.json")
        share = (
            synth["resources"]["ecp5-85"]["dynrt_core"]["LUT4"] / synth["has"]["ecp5-85"]["LUT4"]
        )
        text = README.replace("\n", " ")
        self.assertIn(f"`thesis` reaches {core['MHz, median']} MHz", text)
        self.assertIn(f"that makes {1e9 / core['placed, ns'] / cycles:.1f} frames", text)
        self.assertIn(f"`thesis` takes {round(100 * share)} % of the LUTs", text)


if __name__ == "__main__":
    unittest.main()
