# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The clocks that cores reached when they were placed and routed: hls/configs/clocks.json, which
`scripts/place --clock` writes. Every figure of frames per second comes from there: those of the
program dynrt, of the scripts and of the pages."""

import dataclasses
import json
import pathlib
import re
from dataclasses import dataclass

from dynrt_tools import project

FILE = project.ROOT / "hls" / "configs" / "clocks.json"
THESIS_MHZ = 85  # the clock of the thesis's prototype, beside which figures are compared with it

# Figures that follow from counted clocks and a clock in MHz. Kept data leave them out.
RATE = re.compile(r"clock|clock_hz|(frames|displays)[ _]per[ _]second.*")

DIGITS = 1  # of a clock in MHz, behind the point


@dataclass(frozen=True)
class PlacedClock:
    """The clock of a core on a device, and the placement that measured it."""

    configuration: str
    device: str  # as scripts/place names it
    part: str  # the device in words
    grade: str  # empty on a device that has but one
    mhz: float  # median of the seeds
    lowest_mhz: float
    highest_mhz: float
    seeds: int
    placer: str  # with its version
    date: str  # on which it was placed: year, month and day
    verilog: str  # place_record.hash_of what was placed

    @property
    def where(self) -> str:
        """The device and its grade in words."""
        return self.part + (f", grade {self.grade}" if self.grade else "")

    @property
    def day(self) -> str:
        """The date in words."""
        return project.day(self.date)

    @property
    def key(self) -> tuple[str, str, str]:
        """Of these there is one clock."""
        return self.device, self.grade, self.configuration

    def of_core(self, configuration: str) -> str:
        """What the clock is for a configuration, in words."""
        text = f"at {self.mhz:g} MHz, placed: {self.configuration} on {self.where}"
        missing = f"; {configuration} was not placed and may miss it"
        return text + (missing if configuration != self.configuration else "")


def load(path: pathlib.Path = FILE) -> list[PlacedClock]:
    """Every clock; the first has the device and the grade that figures are for where no other is
    named."""
    try:
        clocks = [PlacedClock(**row) for row in project.read_json(path)]
    except (TypeError, ValueError) as error:
        raise project.Failed(f"{path}: cannot be read: {error}") from error
    keys = [clock.key for clock in clocks]
    for twice in {key for key in keys if keys.count(key) > 1}:
        raise project.Failed(f"{path}: has two clocks of {', '.join(twice)}; keep one")
    return clocks


def write(clock: PlacedClock, path: pathlib.Path = FILE) -> None:
    """States a clock, in place of the one of the same core, device and grade."""
    before = load(path)
    clocks = [clock if old.key == clock.key else old for old in before]
    clocks += [clock] if clock not in clocks else []
    rows = ",\n".join(f"  {json.dumps(dataclasses.asdict(row))}" for row in clocks)
    path.write_text(f"[\n{rows}\n]\n", encoding="utf-8")


def of(configuration: str, clocks: list[PlacedClock] | None = None) -> PlacedClock:
    """The clock of a configuration on the default device and grade. Where it was not placed the
    slowest clock there stands in, whose `configuration` says so."""
    clocks = clocks or load()
    first = clocks[0]
    there = [c for c in clocks if (c.device, c.grade) == (first.device, first.grade)]
    slowest = min(there, key=lambda clock: clock.mhz)
    return next((c for c in there if c.configuration == configuration), slowest)


def frames_per_second(cycles: float, mhz: float) -> float:
    return mhz * 1e6 / cycles


def rate_text(cycles: float, configuration: str, form: str) -> str:
    """Frames per second of a configuration at its placed clock; in brackets if that is the clock of
    another core."""
    clock = of(configuration)
    text = format(frames_per_second(cycles, clock.mhz), form)
    return text if clock.configuration == configuration else f"({text})"


def without_rates(data: object) -> object:
    """Measured data without the figures that follow from them and a clock."""
    if isinstance(data, dict):
        return {k: without_rates(v) for k, v in data.items() if not RATE.fullmatch(k)}
    return [without_rates(value) for value in data] if isinstance(data, list) else data
