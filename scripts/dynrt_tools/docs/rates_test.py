# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Every figure of frames per second in the README and the pages follows from kept clocks of a frame
and a clock in MHz that somebody measured: the placed one, or the thesis's."""

import pathlib
import re
import unittest

from dynrt_tools import project
from dynrt_tools.docs import results
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.hardware.placed_clocks import THESIS_MHZ

# "45.1 frames per second", "26 frames of `office` a second"
RATE = re.compile(r"(\d[\d,.]*)\)? frames(?: of \S+)? (?:per|a) second")
AT = re.compile(r"frames (?:per|a) second at (\d[\d.]*) MHz")
# What the clock was when a version came out stays in its notes.
HISTORY = ("CHANGELOG.md",)


def pages() -> list[pathlib.Path]:
    """Every page of words but the templates, whose figures are not filled in."""
    found = [*project.ROOT.glob("*.md"), *(project.ROOT / "docs").rglob("*.md")]
    return [p for p in found if p.parent != results.RESULTS / "templates" and p.name not in HISTORY]


def frames() -> list[tuple[str, int]]:
    """The configuration and the clocks of each frame whose data are kept."""
    data = results.Data(results.RESULTS / "data")
    rows = [(row["variant"], row["clocks"]) for row in data.load("scenes")["rows"]]
    alone = data.load("office_thesis")["frame"]
    return [*rows, (alone["configuration"], alone["cycles"])]


def follows(figure: str) -> bool:
    """Whether a figure is the rate of a kept frame, to the figure's last digit."""
    digits = len(figure.partition(".")[2])
    return any(
        figure == f"{placed_clocks.frames_per_second(cycles, mhz):.{digits}f}"
        for core, cycles in frames()
        for mhz in (placed_clocks.of(core).mhz, THESIS_MHZ)
    )


def problems(text: str) -> list[str]:
    """The figures of a page that follow from nothing."""
    flat = text.replace("\n", " ")
    clocks = {float(mhz) for mhz in (THESIS_MHZ, *(c.mhz for c in placed_clocks.load()))}
    wrong = [m[0] for m in RATE.finditer(flat) if not follows(m[1])]
    return wrong + [m[0] for m in AT.finditer(flat) if float(m[1]) not in clocks]


class Rates(unittest.TestCase):
    def test_each_figure_follows_from_the_data(self) -> None:
        figures = 0
        for page in pages():
            text = page.read_text(encoding="utf-8")
            figures += len(RATE.findall(text.replace("\n", " ")))
            self.assertEqual(problems(text), [], page)
        self.assertGreater(figures, 2)

    def test_a_wrong_figure_is_found(self) -> None:
        clock = placed_clocks.of("thesis")
        cycles = next(n for core, n in frames() if core == "thesis")
        right = placed_clocks.frames_per_second(cycles, clock.mhz)
        self.assertEqual(problems(f"{right:.1f} frames\nper second at {clock.mhz:g} MHz"), [])
        self.assertEqual(
            problems(f"{right + 0.2:.1f} frames of `office` a second"),
            [f"{right + 0.2:.1f} frames of `office` a second"],
        )
        self.assertEqual(problems("frames per second at 120 MHz"), ["frames per second at 120 MHz"])

    def test_kept_data_hold_no_rates(self) -> None:
        for path in (results.RESULTS / "data").glob("*.json"):
            data = project.read_json(path)
            self.assertEqual(
                placed_clocks.without_rates(data),
                data,
                f"{path.name} keeps figures that follow from clocks; scripts/docs --record drops them",
            )


if __name__ == "__main__":
    unittest.main()
