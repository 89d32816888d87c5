# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many packets and cache lines a scene rewards: clocks of a frame over powers of two, counted
on the native model by hlsc's schedules."""

import pathlib
from collections.abc import Callable, Iterator

from dynrt_tools.project import Progress
from dynrt_tools.specialise.analyst import Analyst, FrameCosts

Curve = dict[int, int]  # clocks of a frame by packets or lines
SEEN_ENOUGH = 1.5  # times the fewest clocks: slower still, nothing is measured


def powers_below(most: int, least: int = 1) -> Iterator[int]:
    power = 1 << (most.bit_length() - 1)
    while power >= least:
        if power < most:
            yield power
        power //= 2


def walk_down(
    clocks_of: Callable[[int], int], most: int, percent: float, least: int = 1
) -> tuple[Curve, int]:
    """Clocks by number, from the most down to the least that there may be, and the smallest number
    that costs at most so much."""
    base = clocks_of(most)
    curve, chosen, holds = {most: base}, most, True
    for number in powers_below(most, least):
        curve[number] = clocks_of(number)
        holds = holds and curve[number] <= base * (1 + percent / 100)
        chosen = number if holds else chosen
        if curve[number] > SEEN_ENOUGH * base:
            break
    return curve, chosen


def by_percent(percent: float, below: str, above: str = "") -> str:
    """As text, with one word for numbers below 0 and one for the others."""
    rounded = round(percent, 1)
    return f"{abs(rounded):.1f} % {below if rounded < 0 else above}".rstrip()


def reason(curve: Curve, chosen: int, percent: float, frame: str) -> str:
    """Why this number, with the next ones on both sides. `frame` is the frame that was measured."""
    most = max(curve)
    base = curve[most]

    def part(number: int) -> str:
        return f", with {number} " + by_percent(100 * (curve[number] / base - 1), "fewer", "more")

    words = f"with {most} {frame} takes {base:,} clocks"
    if chosen != most:
        words += part(chosen)
    below = [number for number in curve if number < chosen]
    if below:
        words += part(max(below))
    return f"{words}; {percent:g} % are allowed"


class Meter:
    """Clocks of a frame on the model of one configuration, with fewer packets and lines in use."""

    def __init__(
        self,
        analyst: Analyst,
        configuration: pathlib.Path,
        schedules: pathlib.Path,
        progress: Progress,
    ) -> None:
        self.analyst, self.configuration, self.schedules = analyst, configuration, schedules
        self.progress = progress
        self.known: dict[tuple[int, int], FrameCosts] = {}

    def frame(self, packets: int, lines: int) -> FrameCosts:
        if (packets, lines) not in self.known:
            self.progress(f"measuring a frame with {packets} packets and {lines} lines")
            self.known[packets, lines] = self.analyst.frame(
                self.configuration, self.schedules, packets, lines
            )
        return self.known[packets, lines]

    def clocks(self, packets: int, lines: int) -> int:
        return self.frame(packets, lines).clocks


def choose(
    meter: Meter,
    packets: int,
    lines: int,
    percent: float,
    frame: str = "a frame",
    least_lines: int = 1,
) -> tuple[dict[str, tuple[int, str]], dict[str, Curve]]:
    """The decisions for packets and lines, of which there must be `least_lines`, and the curves;
    `frame` says which is measured."""
    by_packets, few = walk_down(lambda n: meter.clocks(n, lines), packets, percent / 2)
    by_lines, short = walk_down(lambda n: meter.clocks(few, n), lines, percent / 2, least_lines)
    decided = {
        "packets": (few, reason(by_packets, few, percent / 2, frame)),
        "lines": (short, reason(by_lines, short, percent / 2, frame)),
    }
    return decided, {"packets": by_packets, "lines": by_lines}
