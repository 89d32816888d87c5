# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Figures of pages against the data of the runs that they come from."""

import dataclasses
import json
import pathlib
import re
import shutil
import tempfile
import unittest
from unittest import mock

from dynrt_tools import project
from dynrt_tools.docs import made, results
from dynrt_tools.hardware import placed_clocks

# A percentage, or a number of thousands that is not rounded to them.
MEASURED = re.compile(r"\d ?%|\d,(?!000)\d{3}\b")


class Figures(unittest.TestCase):
    """A page of one template and its data."""

    def setUp(self) -> None:
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "data").mkdir()
        (self.folder / "templates").mkdir()
        self.write("runs", {"a": {"command": "measure a", "measured": "today"}})

    def write(self, name: str, data: object) -> None:
        """Keeps data."""
        path = self.folder / "data" / f"{name}.json"
        path.write_text(json.dumps(data), encoding="utf-8")

    def page(self, text: str) -> str:
        """The page that a template of this text becomes."""
        (self.folder / "templates" / "p.md").write_text(text, encoding="utf-8")
        return results.pages(self.folder)["results/p.md"]

    def test_a_figure_comes_from_the_data(self) -> None:
        self.write("a", {"rows": [{"scene": "x", "core": "y", "clocks": 12345, "part": 0.5}]})
        page = self.page("{{a:rows/x+y/clocks|,}} {{a:rows/x/part|*100 .1f}}\n")
        self.assertTrue(page.startswith("12,345 50.0\n"))
        self.assertIn("| [a.json](data/a.json) | today | `measure a` |", page)

    def test_a_figure_may_be_a_sum_or_a_ratio(self) -> None:
        self.write("a", {"x": 3, "y": 1, "n": 8, "x%n": 7})
        self.assertTrue(self.page("{{a:x&y}} {{a:x&y%n|.2f}} {{a:x%n}}\n").startswith("4 0.50 7\n"))

    def test_a_figure_may_be_not_measured_yet(self) -> None:
        self.write("a", {"x": None})
        page = self.page("{{a:x|.1f}} {{a:x/y|,}}\n")
        self.assertTrue(page.startswith("not measured not measured\n"))

    def test_clocks_become_frames_per_second(self) -> None:
        self.write("a", {"clocks": 2_000_000})
        clock = dataclasses.replace(placed_clocks.load()[0], mhz=120.5)
        with mock.patch.object(placed_clocks, "load", lambda: [clock]):
            page = self.page(
                "{{a:clocks|@thesis .2f}} {{a:clocks|@full .1f}} {{a:clocks|@85 .1f}} "
                "{{placed:thesis/mhz}} {{placed:thesis/where}}\n"
            )
        self.assertTrue(
            page.startswith("60.25 (60.2) 42.5 120.5 Lattice LFE5U-85F, grade 6\n"), page[:80]
        )
        self.assertNotIn("placed.json", page)

    def test_a_field_that_no_placed_clock_has_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "p.md:1: a placed clock has no 'ghz'; it has "):
            self.page("{{placed:thesis/ghz}}\n")

    def test_a_figure_of_two_lines_is_named(self) -> None:
        self.write("a", {"x y": 1})
        with self.assertRaisesRegex(project.Failed, "p.md:1: '{{' begins no figure"):
            self.page("{{a:x\ny}}\n")

    def test_a_changed_figure_makes_the_page_old(self) -> None:
        self.write("a", {"clocks": 1})
        docs = self.folder
        made.renew({"results/p.md": self.page("{{a:clocks}} clocks\n")}, docs)
        self.write("a", {"clocks": 2})
        self.assertEqual(
            made.stale({"results/p.md": self.page("{{a:clocks}} clocks\n")}, docs),
            ["docs/results/p.md:1: differs from its sources; scripts/docs --renew writes it"],
        )

    def test_a_page_without_its_data_is_named_with_its_line(self) -> None:
        with self.assertRaises(project.Failed) as caught:
            self.page("text\n{{a:clocks}}\n")
        self.assertEqual(
            str(caught.exception),
            "docs/results/templates/p.md:2: there is no a.json; 'measure a' measures it",
        )

    def test_a_figure_that_the_data_lack_is_named(self) -> None:
        self.write("a", {"clocks": 1})
        with self.assertRaisesRegex(project.Failed, "p.md:1: a.json has no 'rays' of 'rays'"):
            self.page("{{a:rays}}\n")


class Plots(unittest.TestCase):
    """The picture of the page on variants."""

    def test_its_points_are_those_of_the_data(self) -> None:
        variants = results.Data(results.RESULTS / "data").load("error")["rows"]
        picture = (project.ROOT / "docs" / "pictures" / "error.svg").read_text(encoding="utf-8")
        shown = re.findall(r'aria-label="([^:"]+): ([^ ]+), ([^"]+)"', picture)
        expected = [
            (v["variant"], v[cost], v["primary.wrong_share"])
            for cost in ("frame_ms", "LUT")
            for v in variants
        ]
        self.assertEqual([name for name, _, _ in shown], [name for name, _, _ in expected])
        for (name, *labels), (_, *values) in zip(shown, expected):
            for label, value in zip(labels, values):
                number = float(label.replace(",", ""))
                self.assertAlmostEqual(number, value, delta=0.01 * abs(value), msg=name)


class Elsewhere(unittest.TestCase):
    """Pages without data of their own."""

    def test_the_first_hour_shows_the_frame_of_the_data(self) -> None:
        rows = results.Data(results.RESULTS / "data").load("scenes")["rows"]
        shown = ("office", "fast")
        row = next(row for row in rows if (row["scene"], row["variant"]) == shown)
        cycles = row["clocks"]
        clock = placed_clocks.of("fast")
        text = (project.ROOT / "docs" / "first-hour.md").read_text(encoding="utf-8")
        rate = placed_clocks.frames_per_second(cycles, clock.mhz)
        self.assertIn(
            f"\nframe       {cycles:,} cycles, {rate:.2f} frames per second at {clock.mhz:g} MHz, ",
            text,
        )
        self.assertIn(
            f"\nclock       {clock.mhz:g} MHz, placed: fast on {clock.where}, median of {clock.seeds} "
            f"seeds ({clock.lowest_mhz:g} to {clock.highest_mhz:g} MHz), on {clock.date}\n",
            text,
        )
        busy, cache = row["frame"]["units"]["node_fetch"], row["frame"]["caches"]["node"]
        self.assertRegex(
            text, rf"\n  node_fetch +{busy['transactions']:,} +{100 * busy['utilisation']:.1f} % "
        )
        self.assertRegex(
            text, rf"\n  node cache +{cache['lookups']:,} +{100 * cache['hit_rate']:.2f} % "
        )

    def test_they_link_to_figures_that_somebody_measured(self) -> None:
        docs = project.ROOT / "docs"
        pages = [*docs.glob("explanation/*.md"), *docs.glob("how-to/*.md")]
        self.assertGreater(len(pages), 20)
        for page in pages:
            for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
                found = MEASURED.search(line)
                self.assertIsNone(
                    found, f"{page}:{number}: '{found and found[0]}' belongs on a page of results"
                )


class Readme(unittest.TestCase):
    """The table of the README."""

    def test_its_figures_are_those_of_the_data(self) -> None:
        data = results.Data(results.RESULTS / "data")
        rows = data.load("scenes")["rows"]
        text = (project.ROOT / "README.md").read_text(encoding="utf-8")
        cell = r" ([^|]+) \|"
        table = re.findall(rf"^\| `(\w+)`[^|]*\| `(\w+)` \|{3 * cell}$", text, re.M)
        shown = {(scene, core): tuple(figures) for scene, core, *figures in table}
        expected = {}

        def rates(core: str, cycles: float) -> tuple[str, str]:
            return results.rate_of(cycles, core, ".1f"), results.rate_of(cycles, "85", ".1f")

        for row in rows:
            scene, core, cycles = row["scene"], row["variant"], row["clocks"]
            if core == "fast" or scene == "office":
                expected[scene, core] = *rates(core, cycles), row["thesis's frames per second"]
        prototype = expected["office", "full"][-1]
        cycles = data.load("office_thesis")["frame"]["cycles"]
        expected["office", "thesis"] = *rates("thesis", cycles), prototype
        self.assertEqual(shown, expected)
        share = round(data.figure("synth", "shares/ecp5-85/dynrt_core/LUT4"))
        self.assertIn(f"`thesis` takes {share} % of the LUTs", text)


if __name__ == "__main__":
    unittest.main()
