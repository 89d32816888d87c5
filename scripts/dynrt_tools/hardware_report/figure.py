# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What describes a figure of a hardware report: along what it goes, its curves, and what the thesis
gives beside them."""

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from dynrt_tools.project import Json

# The flags of dynrt render that a frame has, each a word and its value, and the keys in which its core
# differs from the configuration. Of packets and lines the configuration has the largest value.
Point = Mapping[str, int | str]
MORTON: Point = {"order": "morton"}
SCANLINE: Point = {"order": "scanline"}
# As the thesis's core writes none. The banks take a record in three clocks, so where several pipelines
# end more rays they would be what the figure shows.
WITHOUT_HITS: Point = {**MORTON, "no-hits": True}
# The keys along which a figure may go: each of their values is a core of its own. They are 1 where a
# configuration does not say otherwise.
KEYS = ("memory_clocks", "pipelines")


@dataclass(frozen=True)
class Series:
    """A curve of a figure: a figure of the runs (rows.py), with these flags."""

    label: str
    value: str
    flags: Point = dataclasses.field(default_factory=lambda: MORTON)

    @property
    def dashed(self) -> bool:
        return self.flags["order"] != MORTON["order"]


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
    along: str  # the flag that changes, or the key
    values: Sequence[int]
    unit: str
    series: Sequence[Series]
    limit: float | None = None  # the largest value that there can be
    said: str = ""  # by the thesis's text
    marks: Mapping[str, Mark] = dataclasses.field(default_factory=dict)  # by scene
    whole: float | None = None  # x is this divided by the value; without it, the value itself
    measure: str = ""  # what x is then

    @property
    def file(self) -> str:
        return "figure_" + self.name.replace(".", "_").replace(" and ", "_and_")

    @property
    def numbers(self) -> list[str]:
        return self.name.split(" and ")

    @property
    def over(self) -> str:
        """What x is, in words."""
        return self.measure or self.along

    def x_of(self, value: int) -> float:
        return self.whole / value if self.whole else value

    def along_values(self, configuration: Json) -> list[int]:
        """The values up to what a configuration has; all, if what changes is none of its flags."""
        most = None if self.along in KEYS else configuration.get(self.along)
        return [value for value in self.values if most is None or value <= most]
