# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The points of figures: for each, a frame is rendered on the configuration or on a core that differs
from it in a key."""

from collections.abc import Sequence

from dynrt_tools.hardware_report.figure import (
    FLAGS,
    KEYS,
    LATENCY,
    MADE,
    MORTON,
    Figure,
    Point,
    Series,
    is_behind_port,
)
from dynrt_tools.project import Json


def own_value(configuration: Json, key: str) -> int:
    return int(configuration.get(key, KEYS[key]))


def own_point(configuration: Json) -> Point:
    """All packets and lines that a configuration has."""
    own: Point = {"packets": configuration["packets"], "lines": configuration["lines"], **MORTON}
    return {**own, "memory-latency": LATENCY} if is_behind_port(configuration) else own


def point_of(configuration: Json, figure: Figure, series: Series, value: int) -> Point:
    point = {**own_point(configuration), **series.flags}
    along = figure.axis_of(configuration).along
    if along in KEYS and value == own_value(configuration, along):
        return point  # the configuration itself
    return {**point, along: value}


def points(
    configuration: Json, figures: Sequence[Figure], others: Sequence[Point] = ()
) -> list[Point]:
    """Every walk that the figures need of a configuration, and others, each once."""
    found = {name_of(own := own_point(configuration)): own}
    for figure, series in ((f, s) for f in figures for s in f.series):
        for value in figure.axis_of(configuration).along_values(configuration):
            point = point_of(configuration, figure, series, value)
            found.setdefault(name_of(point), point)
    for point in others:
        found.setdefault(name_of(point), point)
    return list(found.values())


def name_of(point: Point) -> str:
    """As files have it."""
    return "_".join(word if value is True else f"{word}-{value}" for word, value in point.items())


def flags_of(point: Point) -> str:
    """As dynrt walk takes it, which writes hit records only if it is told to."""
    valued = [flag for flag in point if flag in FLAGS and flag != "no-hits"]
    found = [f"--{flag} {point[flag]}" for flag in valued]
    return " ".join(found if "no-hits" in point else [*found, "--hits"])


def keys_of(point: Point) -> Point:
    """The keys in which the point's core differs from the configuration."""
    return {key: value for key, value in point.items() if key not in (*FLAGS, MADE)}


def is_own(point: Point) -> bool:
    """Whether the point's core is the configuration itself."""
    return not keys_of(point) and MADE not in point


def made_point(configuration: Json) -> Point:
    """Of a core made for the scene, which has packets and lines of its own."""
    own: Json = {**own_point(configuration), "no-hits": True, MADE: True}
    return {word: value for word, value in own.items() if word not in ("packets", "lines")}


def core_at(configuration: Json, point: Point) -> Json:
    """The keys of the point's core."""
    return {**configuration, **keys_of(point)}


def core_of(configuration: str, point: Point, scene: str = "{scene}") -> str:
    """The name of the point's core, which may depend on the scene."""
    if MADE in point:
        return f"{configuration}-made-{scene}"
    return "-".join([configuration, *(f"{k}{value}" for k, value in keys_of(point).items())])
