# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What describes a figure of a hardware report: along what it goes, its curves, and what the thesis
gives beside them."""

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from dynrt_tools.build import configs
from dynrt_tools.project import Json

# The flags of dynrt render that a frame has, each a word and its value, and the keys in which its core
# differs from the configuration. Of packets and lines the configuration has the largest value.
Point = Mapping[str, int | str]
FLAGS = ("packets", "lines", "order", "no-hits", "memory-latency")
MADE = "made"  # a point whose core is made for the scene, of the configuration
MORTON: Point = {"order": "morton"}
SCANLINE: Point = {"order": "scanline"}
# As the thesis's core writes none. The banks take a record in three clocks, so where several pipelines
# end more rays they would be what the figure shows.
WITHOUT_HITS: Point = {**MORTON, "no-hits": True}
# Of a memory behind a port, in clocks: that of a DRAM next to the chip.
LATENCY = 30
# The keys along which a figure may go, with their values where a configuration does not say otherwise:
# each other value is a core of its own.
KEYS = {"memory_clocks": 1, "port_bytes": 8, "pipelines": 1}


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
class Axis:
    along: str  # the flag that changes, or the key
    values: Sequence[int]
    measure: str = ""  # what x is, if not the value
    x_of: Callable[[int], float] = float

    @property
    def over(self) -> str:
        """What x is, in words."""
        return self.measure or self.along

    def along_values(self, configuration: Json) -> list[int]:
        """The values that a configuration can have: none of a flag is larger than its own, and its
        other keys allow each."""
        most = None if self.along in KEYS else configuration.get(self.along)
        rules = [
            rule
            for rule in configs.load_configurations().RULES
            if rule.other == self.along
            and all(configuration.get(key) == value for key, value in rule.given.items())
        ]
        return [
            value
            for value in self.values
            if (most is None or value <= most) and all(rule.wants.allows(value) for rule in rules)
        ]


def is_behind_port(configuration: Json) -> bool:
    return configuration.get("memory") == "port"


@dataclass(frozen=True)
class Figure:
    name: str  # the thesis's numbers
    title: str
    axis: Axis
    unit: str
    series: Sequence[Series]
    limit: float | None = None  # the largest value that there can be
    said: str = ""  # by the thesis's text
    marks: Mapping[str, Mark] = dataclasses.field(default_factory=dict)  # by scene
    behind_port: Axis | None = None  # in place of `axis` where the memory is behind a port

    @property
    def file(self) -> str:
        return "figure_" + self.name.replace(".", "_").replace(" and ", "_and_")

    @property
    def numbers(self) -> list[str]:
        return self.name.split(" and ")

    @property
    def over(self) -> str:
        return self.axis.over

    def axis_of(self, configuration: Json) -> Axis:
        return self.behind_port if self.behind_port and is_behind_port(configuration) else self.axis
