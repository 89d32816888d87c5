# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The worst paths of a placement, each kind once, with where they are from."""

import re
from collections import Counter

from dynrt_tools.hardware import source_names, timing_graph
from dynrt_tools.project import Json

KEPT_PATHS = 40
WALKED = 4000  # endpoints at most that are walked back from, the longest first
BIT = re.compile(r"\[\d+\]|_\d+$")


def describe(origin: source_names.Origin) -> Json:
    return {"unit": origin.unit, "signal": origin.signal, "source": origin.source}


def kind(start: source_names.Origin, end: source_names.Origin) -> tuple[str, ...]:
    """What the bits of one path have in common."""
    return (start.unit, BIT.sub("", start.signal), end.unit, BIT.sub("", end.signal))


def worst(timing: timing_graph.Timing, names: source_names.Names, asked_ns: float) -> Json:
    """The longest period, how many registers' inputs are too slow for the one asked for, and the
    worst paths. Paths that differ only in their bits are one: its worst, and their number."""
    ends = timing.endpoints()
    paths: dict[tuple[str, ...], Json] = {}
    counts: Counter[tuple[str, ...]] = Counter()
    for ns, end in ends[:WALKED]:
        hops = timing.path(end)
        start = names.origin(hops[0].cell, hops[0].out)
        finish = names.register(end[0])
        group = kind(start, finish)
        counts[group] += 1
        if group not in paths and len(paths) < KEPT_PATHS:
            paths[group] = path_of(ns, hops, names, start, finish)
    for group, path in paths.items():
        path["endpoints"] = counts[group]
    return {
        "longest_ns": round(ends[0][0], 3) if ends else 0.0,
        "endpoints": len(ends),
        "too_slow": sum(ns > asked_ns for ns, _ in ends),
        "paths": list(paths.values()),
    }


def path_of(
    ns: float,
    hops: list[timing_graph.Hop],
    names: source_names.Names,
    start: source_names.Origin,
    end: source_names.Origin,
) -> Json:
    logic, wire = sum(hop.logic_ns for hop in hops), sum(hop.wire_ns for hop in hops)
    return {
        "ns": round(ns, 3),
        "logic_ns": round(logic, 3),
        "wire_ns": round(wire, 3),
        "levels": len(hops) - 2,
        "from": describe(start),
        "to": {**describe(end), "pin": hops[-1].into},
        "hops": [
            {
                **describe(end if hop is hops[-1] else names.origin(hop.cell, hop.out)),
                "cell": hop.cell,
                "pin": hop.into,
                "logic_ns": round(hop.logic_ns, 3),
                "wire_ns": round(hop.wire_ns, 3),
                "fanout": hop.fanout,
            }
            for hop in hops
        ],
    }
