# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of the thesis's chapter 7.2 as data: what each shows, along what, and what the thesis's
text says. The frames that a report renders follow from them, and so do its curves: another figure is
another entry of FIGURES."""

import dataclasses
import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from dynrt_tools.bench.scenes import THESIS as THESIS_RATES
from dynrt_tools.hardware.placed_clocks import THESIS_MHZ
from dynrt_tools.project import Json

PACKETS = (1, 2, 4, 8, 16, 24, 32, 48, 64)
LINES = tuple(2**n for n in range(10))
RATE = f"frames per second at {THESIS_MHZ} MHz"

# The flags of dynrt render that a frame has, each a word and its value. Of packets and lines the
# configuration has the largest value.
Point = Mapping[str, int | str]
MORTON: Point = {"order": "morton"}
SCANLINE: Point = {"order": "scanline"}


@dataclass(frozen=True)
class Series:
    """A curve of a figure: a figure of the runs (rows.py), with these flags."""

    label: str
    value: str
    flags: Point = dataclasses.field(default_factory=lambda: MORTON)

    @property
    def dashed(self) -> bool:
        return self.flags != MORTON


@dataclass(frozen=True)
class Mark:
    """A value that the thesis's text gives: at x, or for the whole width; low and high may be one."""

    low: float
    high: float
    x: int | None = None


@dataclass(frozen=True)
class Figure:
    name: str  # the thesis's numbers
    title: str
    along: str  # the flag that changes
    values: Sequence[int]
    unit: str
    series: Sequence[Series]
    limit: float | None = None  # the largest value that there can be
    said: str = ""  # by the thesis's text
    marks: Mapping[str, Mark] = dataclasses.field(default_factory=dict)  # by scene

    @property
    def file(self) -> str:
        return "figure_" + self.name.replace(".", "_").replace(" and ", "_and_")

    def along_values(self, configuration: Json) -> list[int]:
        """The values up to what a configuration has; all, if what changes is none of its keys."""
        most = configuration.get(self.along)
        return [value for value in self.values if most is None or value <= most]


UNITS = ("traversal", "list", "transformation", "intersection")
CACHES = {"traversal": "node", "list": "list", "transformation": "matrix"}

FIGURES = (
    Figure(
        "7.5 and 7.10",
        "Cache hit rate",
        "lines",
        LINES,
        "%",
        tuple(
            Series(
                f"{unit}{', scanline' if flags == SCANLINE else ''}", f"{cache} cache hits", flags
            )
            for flags in (MORTON, SCANLINE)
            for unit, cache in CACHES.items()
        ),
        limit=100,
        said="The Morton curve in place of scanlines raises the hit rate by about 10 to 20 %, most of "
        "all that of the list and of the transformation.",
    ),
    Figure(
        "7.6",
        "Hardware quality index QHW",
        "packets",
        PACKETS,
        "%",
        (Series("QHW", "QHW"),),
        said="The best is about 9.5 %, at 32 packets, in the scenes Gael and conference.",
        marks={scene: Mark(9.5, 9.5, 32) for scene in ("cistern", "conference")},
    ),
    Figure(
        "7.7",
        "Graphics hardware quality index QGHW",
        "packets",
        PACKETS,
        "rays a clock per million gates",
        (Series("QGHW", "QGHW"),),
        said="The best is at 32 packets too.",
    ),
    Figure(
        "7.8",
        "Use of units",
        "packets",
        PACKETS,
        "%",
        tuple(Series(unit, f"{unit} use") for unit in UNITS),
        limit=100,
        said="The use grows with the packets until that of one unit is near 100 %; those of the others "
        "keep their ratios to it.",
    ),
    Figure(
        "7.9",
        f"Frame rate at {THESIS_MHZ} MHz",
        "packets",
        PACKETS,
        "frames per second",
        (Series("frame rate", RATE),),
        said="Appendix A gives the typical frame rate of a scene; its Gael stands beside cistern.",
        marks={scene: Mark(*rates) for scene, rates in THESIS_RATES.items()},
    ),
)


def own_point(configuration: Json) -> Point:
    """All packets and lines that a configuration has."""
    return {"packets": configuration["packets"], "lines": configuration["lines"], **MORTON}


def point_of(configuration: Json, figure: Figure, series: Series, value: int) -> Point:
    return {**own_point(configuration), **series.flags, figure.along: value}


def points(configuration: Json, figures: Sequence[Figure] = FIGURES) -> list[Point]:
    """Every frame that the figures need of a configuration, each once."""
    found = {name_of(own := own_point(configuration)): own}
    for figure, series in ((f, s) for f in figures for s in f.series):
        for value in figure.along_values(configuration):
            point = point_of(configuration, figure, series, value)
            found.setdefault(name_of(point), point)
    return list(found.values())


def name_of(point: Point) -> str:
    """As files have it."""
    return "_".join(f"{flag}-{value}" for flag, value in point.items())


def flags_of(point: Point) -> str:
    """As dynrt render takes it."""
    return " ".join(f"--{flag} {value}" for flag, value in point.items())


@dataclass(frozen=True)
class Curve:
    configuration: str
    series: Series
    points: list[tuple[int, float]]

    @property
    def label(self) -> str:
        return f"{self.configuration}, {self.series.label}"


def curves(report: Json, figure: Figure, scene: str) -> Iterator[Curve]:
    """The curves of a figure for a scene, without points that are missing."""
    found = {
        (run["configuration"], name_of(run["flags"])): run
        for run in report["runs"]
        if run["scene"] == scene
    }
    drawn = [n for n, c in report["configurations"].items() if c["curves"]]
    for name, series in itertools.product(drawn, figure.series):
        configuration = report["configurations"][name]
        values = []
        for x in figure.along_values(configuration):
            run = found.get((name, name_of(point_of(configuration, figure, series, x))))
            if run and run.get(series.value) is not None:
                values.append((x, run[series.value]))
        if values:
            yield Curve(name, series, values)
