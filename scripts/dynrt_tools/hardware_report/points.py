# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The points of figures: for each, a frame is rendered on the configuration or on a core that differs
from it in a key."""

from collections.abc import Sequence

from dynrt_tools.hardware_report.figure import KEYS, MORTON, Figure, Point, Series
from dynrt_tools.project import Json


def own_value(configuration: Json, key: str) -> int:
    return int(configuration.get(key, 1))


def own_point(configuration: Json) -> Point:
    """All packets and lines that a configuration has."""
    return {"packets": configuration["packets"], "lines": configuration["lines"], **MORTON}


def point_of(configuration: Json, figure: Figure, series: Series, value: int) -> Point:
    point = {**own_point(configuration), **series.flags}
    if figure.along in KEYS and value == own_value(configuration, figure.along):
        return point  # the configuration itself
    return {**point, figure.along: value}


def points(configuration: Json, figures: Sequence[Figure]) -> list[Point]:
    """Every frame that the figures need of a configuration, each once."""
    found = {name_of(own := own_point(configuration)): own}
    for figure, series in ((f, s) for f in figures for s in f.series):
        for value in figure.along_values(configuration):
            point = point_of(configuration, figure, series, value)
            found.setdefault(name_of(point), point)
    return list(found.values())


def name_of(point: Point) -> str:
    """As files have it."""
    return "_".join(word if value is True else f"{word}-{value}" for word, value in point.items())


def flags_of(point: Point) -> str:
    """As dynrt render takes it."""
    return " ".join(
        f"--{flag}" if value is True else f"--{flag} {value}"
        for flag, value in point.items()
        if flag not in KEYS
    )


def keys_of(point: Point) -> Point:
    """The keys in which the point's core differs from the configuration."""
    return {key: value for key, value in point.items() if key in KEYS}


def core_of(configuration: str, point: Point) -> str:
    """The name of the point's core."""
    return "-".join([configuration, *(f"{k}{value}" for k, value in keys_of(point).items())])
