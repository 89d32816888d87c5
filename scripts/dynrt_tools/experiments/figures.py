# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of the thesis's chapter 7.2, as table/hardware.json describes them, and the walks
that they need: a point of a figure is a walk on a configuration or on a core that differs from it
in a key."""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from dynrt_tools.build import configs
from dynrt_tools.experiments import table
from dynrt_tools.project import Json

TABLE = table.experiment("hardware")
FIGURES: list[Json] = TABLE["figures"]
ADDITIONS: list[Json] = TABLE["additions"]
ADDED = "additions"  # as --figure takes the table of them

# The flags of a walk, each a word and its value, and the keys in which its core differs from the
# configuration. Of packets and lines the configuration has the largest value.
Point = Mapping[str, int | str]
FLAGS = ("packets", "lines", "order", "no-hits", "memory-latency")
MADE = "made"  # a point whose core is made for the scene, of the configuration
MORTON: Point = {"order": "morton"}
SCANLINE: Point = {"order": "scanline"}
# As the thesis's core writes none. The banks take a record in three clocks, so where several pipelines
# end more rays they would be what the figure shows.
WITHOUT_HITS: Point = {"no-hits": True}
LATENCY = 30  # in clocks, of a memory behind a port: that of a DRAM next to the chip
# The keys along which a figure may go, with their values where a configuration does not say otherwise:
# each other value is a core of its own.
KEYS = {"memory_clocks": 1, "port_bytes": 8, "pipelines": 1}


def numbers() -> list[str]:
    """The thesis's numbers of the figures, and the table of additions."""
    return [*(n for figure in FIGURES for n in figure["name"].split(" and ")), ADDED]


def is_behind_port(configuration: Json) -> bool:
    return configuration.get("memory") == "port"


def own_value(configuration: Json, key: str) -> int:
    return int(configuration.get(key, KEYS[key]))


def own_point(configuration: Json) -> Point:
    """All packets and lines that a configuration has."""
    own: Point = {"packets": configuration["packets"], "lines": configuration["lines"], **MORTON}
    return {**own, "memory-latency": LATENCY} if is_behind_port(configuration) else own


def axis_of(figure: Json, configuration: Json) -> Json:
    behind = "behind_port" in figure and is_behind_port(configuration)
    return dict(figure["behind_port" if behind else "axis"])


def over(figure: Json) -> str:
    """What x is, in words."""
    axis = figure["axis"]
    return str(axis.get("over", axis["along"]))


def x_of(axis: Json, value: int) -> float:
    return float(axis["of"] / value if "of" in axis else value * axis.get("each", 1))


def values_along(axis: Json, configuration: Json) -> list[int]:
    """The values that a configuration can have: none of a flag is larger than its own, and its
    other keys allow each."""
    along = axis["along"]
    most = None if along in KEYS else configuration.get(along)
    rules = [
        rule
        for rule in configs.load_configurations().RULES
        if rule.other == along and all(configuration.get(k) == v for k, v in rule.given.items())
    ]
    return [
        value
        for value in axis["values"]
        if (most is None or value <= most) and all(rule.wants.allows(value) for rule in rules)
    ]


def point_of(configuration: Json, axis: Json, series: Json, value: int) -> Point:
    point = {**own_point(configuration), **series.get("flags", {})}
    along = axis["along"]
    if along in KEYS and value == own_value(configuration, along):
        return point  # the configuration itself
    return {**point, along: value}


def points(
    configuration: Json, figures: Sequence[Json], others: Sequence[Point] = ()
) -> list[Point]:
    """Every walk that the figures need of a configuration, and others, each once."""
    found = [own_point(configuration)]
    for figure, series in ((f, s) for f in figures for s in f["series"]):
        axis = axis_of(figure, configuration)
        for value in values_along(axis, configuration):
            found.append(point_of(configuration, axis, series, value))
    return list({name_of(point): point for point in [*found, *others]}.values())


def added_points(addition: Json, configuration: Json) -> tuple[Point, Point]:
    """Those of the core without an addition and of the core that has it; neither writes hit
    records."""
    bare: Point = {**own_point(configuration), **WITHOUT_HITS}
    made: Json = {**bare, MADE: True}
    if addition.get("made"):  # which has packets and lines of its own
        return bare, {
            word: value for word, value in made.items() if word not in ("packets", "lines")
        }
    return {**bare, **addition.get("without", {})}, {**bare, **addition.get("with", {})}


def wanted(name: str, configuration: Json) -> list[Point]:
    """The points that the additions need of a configuration."""
    mine = [one for one in ADDITIONS if one["configuration"] == name]
    return [point for one in mine for point in added_points(one, configuration)]


def name_of(point: Point) -> str:
    return " ".join(word if value is True else f"{word} {value}" for word, value in point.items())


def flags_of(point: Point) -> list[str]:
    """As dynrt walk takes it, which writes hit records only if it is told to."""
    valued = [
        (f"--{flag}", str(point[flag])) for flag in point if flag in FLAGS and flag != "no-hits"
    ]
    return [*itertools.chain(*valued), *(() if "no-hits" in point else ("--hits",))]


def keys_of(point: Point) -> Point:
    """The keys in which the point's core differs from the configuration."""
    return {key: value for key, value in point.items() if key not in (*FLAGS, MADE)}


def core_at(configuration: Json, point: Point) -> Json:
    """The keys of the point's core."""
    return {**configuration, **keys_of(point)}


@dataclass(frozen=True)
class Curve:
    configuration: str
    series: Json
    points: list[tuple[float, float]]  # the smallest x first

    @property
    def dashed(self) -> bool:
        return "order" in self.series.get("flags", {})


def curves(report: Json, figure: Json, scene: str) -> Iterator[Curve]:
    """The curves of a figure for a scene, without points that are missing."""
    found = {
        (run["configuration"], name_of(run["flags"])): run
        for run in report["runs"]
        if run["scene"] == scene
    }
    names = [n for n, c in report["configurations"].items() if c["curves"]]
    for name, series in itertools.product(names, figure["series"]):
        configuration = report["configurations"][name]
        axis, values = axis_of(figure, configuration), []
        for value in values_along(axis, configuration):
            run = found.get((name, name_of(point_of(configuration, axis, series, value))))
            if run and run.get(series["value"]) is not None:
                values.append((x_of(axis, value), run[series["value"]]))
        if values:
            yield Curve(name, series, sorted(values))


def marks_of(figure: Json) -> Json:
    """What the thesis's text says of scenes: from `low` to `high`, at x or along the whole
    width."""
    marks = figure.get("marks", {})
    if marks == "rates":
        marks = {s: {"low": a, "high": b} for s, (a, b) in table.THESIS["rates"].items()}
    return {scene: {"x": None, **mark} for scene, mark in marks.items()}


def shown(report: Json) -> list[Json]:
    """The figures as the page draws them; one that no frame gives is not mentioned."""
    found = []
    for figure in (f for f in FIGURES if f["name"] in report["figures"]):
        plots = {
            scene: {
                "curves": [
                    {
                        "configuration": curve.configuration,
                        "label": curve.series["label"],
                        "dashed": curve.dashed,
                        "points": curve.points,
                    }
                    for curve in curves(report, figure, scene)
                ],
                "mark": marks_of(figure).get(scene),
            }
            for scene in report["scenes"]
        }
        if any(one["curves"] for one in plots.values()):
            told = {key: figure[key] for key in ("name", "title", "unit")}
            more = {"limit": figure.get("limit"), "said": figure.get("said", "")}
            several = len(figure["series"]) > 1
            found.append({**told, **more, "over": over(figure), "several": several, "plots": plots})
    return found
