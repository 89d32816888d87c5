# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many clocks a packet takes round the traversal loop: from a node's fetch, found in the cache,
to the next node's fetch. Once as hlsc scheduled it, once as the RTL takes it."""

import math
import pathlib
from collections.abc import Callable

from dynrt_tools.experiments.frame import Work
from dynrt_tools.project import Failed, Json, read_json

# The units of the loop in their order. A schedule's stages are the clocks from a transaction's
# start to its token at the head of the unit's FIFO.
LOOP = ("node_fetch", "node_lookup", "plane_offset", "traversal_slice", "packet_decision")
OPTIONAL = ("plane_offset",)  # where the rays of a packet have one origin
# The channels of the loop with a buffer, which takes a clock: behind an arbiter, whose grant a lone
# packet finds where it left it, and before packet_decision, which waits for all slices.
BUFFERS = ("step", "decision", "traversal_event")
TRIANGLES_PER_CLUSTER = 16
FLAGS = ("--packets", "1", "--position=-10,0.01,0.02", "--look-at=100,0.01,0.02", "--up=0,1,0")


def scheduled(folder: pathlib.Path) -> tuple[int, str] | None:
    """The clocks by hlsc's schedules of a configuration, and those of each unit in words; None
    where there are no schedules."""
    stages, clock_ns = {}, 0.0
    for unit in LOOP:
        path = folder / f"{unit}.json"
        if path.exists():
            schedule = read_json(path)
            stages[unit], clock_ns = schedule["stages"], schedule["clock_ns"]
        elif unit not in OPTIONAL:
            return None
    parts = ", ".join(f"{unit} {n}" for unit, n in stages.items())
    return sum(stages.values()) + len(BUFFERS), f"at {clock_ns:g} ns: {parts}"


def write_avenue(path: pathlib.Path, clusters: int) -> None:
    """Clusters of small triangles around the x axis, none on it: rays along the axis go through
    nodes that separate the clusters and cut off their empty space, and into hardly any leaf."""
    lines: list[str] = []
    faces: list[str] = []
    for cluster in range(clusters):
        around = cluster * 2.399963  # the golden angle
        for triangle in range(TRIANGLES_PER_CLUSTER):
            turn = 1.7 * triangle
            x = cluster + 0.02 * triangle
            y = math.cos(around) + 0.1 * math.cos(turn)
            z = math.sin(around) + 0.1 * math.sin(turn)
            first = len(lines) + 1
            for at in ((0, 0, 0), (0.02, 0.02, 0), (0.02, 0, 0.02)):
                lines.append(f"v {x + at[0]:g} {y + at[1]:g} {z + at[2]:g}")
            faces.append(f"f {first} {first + 1} {first + 2}")
    path.write_text("\n".join([*lines, *faces]) + "\n", encoding="utf-8")


def measured(folder: pathlib.Path, render: Callable[[str, tuple[str, ...]], Json]) -> float:
    """Clocks per node fetch with one packet in flight: two frames that differ in the number of
    nodes alone, so that what else a packet does takes itself away. `render` takes scene and flags.
    """
    frames = []
    for clusters in (4, 16):
        scene = folder / f"avenue{clusters}.obj"
        write_avenue(scene, clusters)
        frames.append(render(str(scene), (*FLAGS, "--fov=0.5")))
    few, many = (Work.of(frame) for frame in frames)
    same = ("packets", "leaf_fetches", "list_entries", "triangles", "objects")
    if any(getattr(few, name) != getattr(many, name) for name in same):
        raise Failed(
            "the two avenues differ in more than their nodes; their trees must have changed"
        )
    return float(frames[1]["cycles"] - frames[0]["cycles"]) / (many.nodes - few.nodes)
