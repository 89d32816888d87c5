# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many clocks a packet takes round the traversal loop: from a node's fetch, found in the cache,
to the next node's fetch. Once as hlsc scheduled it, once as the RTL takes it."""


import dataclasses
import math
import pathlib
import tempfile

from dynrt_tools.bench.run import Dynrt, Work
from dynrt_tools.project import read_json

# The units of the loop in their order. A schedule's stages are the clocks from a transaction's
# start to its token at the head of the unit's FIFO.
LOOP = ("node_fetch", "node_lookup", "plane_offset", "traversal_slice", "packet_decision")
OPTIONAL = ("plane_offset",)  # where the rays of a packet have one origin
# The channels of the loop with a buffer, which takes a clock: behind an arbiter, whose grant a lone
# packet finds where it left it, and before packet_decision, which waits for all slices.
BUFFERS = ("step", "decision", "traversal_event")


@dataclasses.dataclass
class Schedule:
    stages: dict[str, int]  # of each unit of the loop
    clock_ns: float

    @property
    def clocks(self) -> int:
        return sum(self.stages.values()) + len(BUFFERS)


def scheduled(folder: pathlib.Path) -> Schedule | None:
    """Reads hlsc's schedules of a configuration; None where they have not been made."""
    stages, clock_ns = {}, 0.0
    for unit in LOOP:
        path = pathlib.Path(folder, f"{unit}.json")
        if not path.exists():
            if unit in OPTIONAL:
                continue
            return None
        schedule = read_json(path)
        stages[unit] = schedule["stages"]
        clock_ns = schedule["clock_ns"]
    return Schedule(stages, clock_ns)


TRIANGLES_PER_CLUSTER = 16
CAMERA = ("--position=-10,0.01,0.02", "--look-at=100,0.01,0.02", "--up=0,1,0", "--fov=0.5")


def write_avenue(path: pathlib.Path, clusters: int) -> None:
    """Clusters of small triangles around the x axis, none on it: rays along the axis go through
    nodes that separate the clusters and cut off their empty space, and into hardly any leaf."""
    vertices: list[tuple[float, float, float]] = []
    faces = []
    for cluster in range(clusters):
        around = cluster * 2.399963  # the golden angle
        for triangle in range(TRIANGLES_PER_CLUSTER):
            turn = 1.7 * triangle
            x = cluster + 0.02 * triangle
            y = math.cos(around) + 0.1 * math.cos(turn)
            z = math.sin(around) + 0.1 * math.sin(turn)
            first = len(vertices) + 1
            vertices += [(x, y, z), (x + 0.02, y + 0.02, z), (x + 0.02, y, z + 0.02)]
            faces.append((first, first + 1, first + 2))
    lines = [f"v {x:g} {y:g} {z:g}" for x, y, z in vertices]
    lines += [f"f {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def measured(dynrt: Dynrt, config: str) -> float:
    """Clocks per node fetch with one packet in flight: two frames that differ in the number of
    nodes alone, so that what else a packet does takes itself away."""
    frames = []
    with tempfile.TemporaryDirectory() as folder:
        for clusters in (4, 16):
            scene = pathlib.Path(folder, f"avenue{clusters}.obj")
            write_avenue(scene, clusters)
            frames.append(
                dynrt.render(str(scene), "rtl", config, "64x48", "--packets", "1", *CAMERA).frame
            )
    few, many = frames[0], frames[1]
    same = ("packets", "leaf_fetches", "list_entries", "triangles", "objects")
    if any(getattr(Work.of(few), name) != getattr(Work.of(many), name) for name in same):
        raise AssertionError(
            "the two avenues differ in more than the nodes on the way; "
            "their trees must have changed"
        )
    return float(many["cycles"] - few["cycles"]) / (Work.of(many).nodes - Work.of(few).nodes)
