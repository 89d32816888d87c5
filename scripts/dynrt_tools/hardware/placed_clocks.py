# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The clocks that cores reached when they were placed and routed. Every figure of frames per second
comes from here: those of the program dynrt, of the scripts and of the pages.

Each file docs/results/data/place_core*.json is one placement that `scripts/place --keep` wrote; the
command stands in runs.json. This module alone knows how they are kept."""

import pathlib
import re
import statistics
from dataclasses import dataclass

from dynrt_tools import project
from dynrt_tools.hardware import devices, kept_placement, placers, rtl_files
from dynrt_tools.project import Json

DATA = kept_placement.DATA
FILES = "place_core*.json"
DEVICE = "ecp5-85"  # that figures are for where no other is named, at its default grade
THESIS_MHZ = 85  # the clock of the thesis's prototype, beside which figures are compared with it

# Figures that follow from counted clocks and a clock in MHz. Kept data leave them out.
RATE = re.compile(r"clock|clock_hz|(frames|displays)[ _]per[ _]second.*")

DIGITS = 1  # of a clock in MHz, behind the point


@dataclass(frozen=True)
class PlacedClock:
    """The clock of a core on a device, and the run that measured it."""

    device: str
    grade: str  # empty on a device that has but one
    configuration: str
    mhz: float  # median of the seeds
    lowest_mhz: float
    highest_mhz: float
    seeds: int
    placer: str  # with its version
    verilog: str  # kept_placement.hash_of what was placed
    earlier: bool  # the checked-in Verilog is another by now; of others nobody can tell
    command: str

    @property
    def where(self) -> str:
        """The device and its grade in words."""
        name = devices.DEVICES[self.device]["name"]
        return name + (f", grade {self.grade}" if self.grade else "")

    def of_core(self, configuration: str) -> str:
        """What the clock is for a configuration, in words."""
        text = f"at {self.mhz:g} MHz, placed: {self.configuration} on {self.where}"
        missing = f"; {configuration} was not placed and may miss it"
        return text + (missing if configuration != self.configuration else "")


def _read(path: pathlib.Path, data: Json) -> PlacedClock:
    runs = project.read_json(path.parent / "runs.json")
    if path.stem not in runs:
        raise project.Failed(f"{path.name}: runs.json names no command that measured it; add one")
    command = runs[path.stem]["command"]
    if rtl_files.CORE not in data["units"]:
        raise project.Failed(
            f"{path.name}: has no placement of {rtl_files.CORE}; '{command}' makes it"
        )
    try:
        return PlacedClock(
            device=data["device"],
            grade=data["grade"],
            configuration=data["config"],
            mhz=round(statistics.median(data["mhz"]), DIGITS),
            lowest_mhz=round(min(data["mhz"]), DIGITS),
            highest_mhz=round(max(data["mhz"]), DIGITS),
            seeds=data["seeds"],
            placer=f"{placers.PLACERS[data['device']]['program']} {data['placer']}",
            verilog=data["verilog"],
            earlier=kept_placement.is_earlier({"unit": rtl_files.CORE} | data),
            command=command,
        )
    except KeyError as error:
        raise project.Failed(f"{path.name}: has no {error}; '{command}' writes it") from error


def _order(clock: PlacedClock) -> tuple[object, ...]:
    grades = placers.PLACERS[clock.device]["grades"]
    return (
        clock.device != DEVICE,
        clock.device,
        grades.index(clock.grade) if clock.grade in grades else len(grades),
        clock.configuration != rtl_files.CHECKED_IN,
        clock.configuration,
    )


def load(folder: pathlib.Path = DATA) -> list[PlacedClock]:
    """Every placement of one core alone: the default device and grade first, and of each device and
    grade the checked-in configuration first."""
    files = {path: project.read_json(path) for path in folder.glob(FILES)}
    alone = {path: data for path, data in files.items() if data.get("copies", 1) == 1}
    clocks = sorted((_read(path, data) for path, data in alone.items()), key=_order)
    keys = [(c.device, c.grade, c.configuration) for c in clocks]
    for twice in {key for key in keys if keys.count(key) > 1}:
        raise project.Failed(
            f"{folder}: two files of {FILES} have a placement of {twice[2]} on {twice[0]}, grade "
            f"'{twice[1]}'; keep one"
        )
    if not clocks:
        raise project.Failed(f"{folder}: has no {FILES}; scripts/place --keep writes one")
    return clocks


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
