# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What this project added to the thesis's machine, by the thesis's own measure: the indices of a core
that has an addition, beside those of the same core without it."""

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

from dynrt_tools.hardware_report import figures, points
from dynrt_tools.hardware_report.figure import WITHOUT_HITS, Point
from dynrt_tools.project import Json

NAME = "additions"  # as --figure takes it
INDICES = ("QHW", "QGHW")
FASTER, LARGER = "frame rate gained", "gates added"  # in percent
COLUMNS = (
    FASTER,
    LARGER,
    *(f"{index} {which}" for index in INDICES for which in ("without", "with")),
)


@dataclass(frozen=True)
class Addition:
    """Cores of a configuration, by the keys in which they differ from it."""

    name: str
    configuration: str
    without: Point
    having: Point = dataclasses.field(default_factory=dict)
    made: bool = False  # the core that has it is made for the scene

    def points(self, configuration: Json) -> tuple[Point, Point]:
        """Those of the core without it and of the core that has it; neither writes hit records."""
        bare: Point = {**points.own_point(configuration), **WITHOUT_HITS}
        having = points.made_point(configuration) if self.made else {**bare, **self.having}
        return {**bare, **self.without}, having


ADDITIONS = (
    # A plane's distance, boxes of objects and short stacks go with it.
    Addition("one origin for the rays of a packet", "fast", {"origins": "each"}),
    Addition("a line in each of two ways", "fast_port", {"ways": 1}),
    Addition("four ways, not two", "fast_port", {}, {"ways": 4}),
    Addition("a second level of 64 KB", "fast_port", {"second_level": 0}),
    Addition("128 KB, not 64", "fast_port", {}, {"second_level": 128}),
    *(
        Addition(f"{number} pipelines, not one", name, {}, {"pipelines": number})
        for name in ("fast", "fast_port")
        for number in (2, 4)
    ),
    Addition("a core made for the scene", "fast", {}, made=True),
)


def wanted(name: str, configuration: Json) -> list[Point]:
    """The points that the additions need of a configuration."""
    mine = [one for one in ADDITIONS if one.configuration == name]
    return [point for one in mine for point in one.points(configuration)]


def of(report: Json) -> list[Json]:
    """A row for each scene and addition whose configuration has curves; what is missing is None."""
    if NAME not in report["figures"]:
        return []
    curves = {name: one for name, one in report["configurations"].items() if one["curves"]}
    return [
        {"scene": scene, "addition": one.name, "configuration": one.configuration}
        | row_of(report["runs"], scene, one, curves[one.configuration])
        for scene in report["scenes"]
        for one in ADDITIONS
        if one.configuration in curves
    ]


def row_of(runs: Sequence[Json], scene: str, addition: Addition, configuration: Json) -> Json:
    place = (scene, addition.configuration)
    mine = [run for run in runs if (run["scene"], run["configuration"]) == place]

    def at(point: Point) -> Json:
        return next((run for run in mine if run["flags"] == point), {})

    before, after = map(at, addition.points(configuration))

    def more(figure: str) -> float | None:
        old, new = before.get(figure), after.get(figure)
        return None if old is None or new is None else 100 * (new / old - 1)

    found = {FASTER: more(figures.RATE), LARGER: more("C_AU + C_IM")}
    for index in INDICES:
        found |= {f"{index} without": before.get(index), f"{index} with": after.get(index)}
    return found
