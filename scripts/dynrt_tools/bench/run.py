# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs the program dynrt for scripts/bench and turns its counters into the work of a frame."""

import dataclasses
import functools
import os
import pathlib
import statistics
import subprocess
import tempfile
from collections.abc import Callable

from dynrt_tools.build import configs
from dynrt_tools.project import Failed, Json, Progress, read_json


class RunFailed(Failed):
    """dynrt refused or failed; the text is its own sentence."""


@dataclasses.dataclass
class Run:
    """One run of dynrt: its report, and its cost on this machine."""

    report: Json
    cpu_seconds: float  # user and system time of all its threads
    peak_bytes: int

    @property
    def frame(self) -> Json:
        return dict(self.report["frame"])


class Dynrt:
    """The program of one build."""

    def __init__(self, program: str | pathlib.Path) -> None:
        self.program = pathlib.Path(program).resolve()

    def _run(self, arguments: list[str]) -> Run:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            figures = folder / "figures.json"
            command: list[str | pathlib.Path] = [self.program, *arguments, "--json", figures]
            with open(folder / "errors", "w+", encoding="utf-8") as errors:
                process = subprocess.Popen(
                    command, stdout=subprocess.DEVNULL, stderr=errors, cwd=folder
                )
                # wait4, because subprocess does not give the time of a single child.
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
                errors.seek(0)
                sentence = errors.read().strip()
            if process.returncode != 0:
                raise RunFailed(sentence or f"{self.program} ended with {process.returncode}")
            report = read_json(figures)
        return Run(report, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024)

    def info(self, scene: str) -> Run:
        return self._run(["info", scene])

    def measure(self, scene: str, config: str, schedule: pathlib.Path, size: str) -> Json:
        """Clocks, counters and errors of a frame of the native model."""
        return self._run(
            ["measure", scene, "--config", config, "--schedule", str(schedule), "--size", size]
        ).report

    def render(self, scene: str, board: str, config: str, size: str, *flags: str) -> Run:
        return self._run(
            [
                "render",
                scene,
                "--board",
                board,
                "--config",
                config,
                "--size",
                size,
                "--out",
                "image.png",
                *flags,
            ]
        )


# The bytes of memory in a line of each cache, of a pixel and of its hit record.

# The keys of cores whose counters say how many triangles and objects packets meet: each of four rays
# goes through the transformation for every item, and a leaf is a node.
TELLING = {
    "packet_rays": 4,
    "datapath": "thesis",
    "lights": 0,
    "reflections": 0,
    "triangle_test": "unit_triangle",
}


@functools.cache
def _tells(configuration: str) -> bool:
    """Whether the counters of this configuration say so; of one that is not listed nobody knows."""
    listed = configs.load_configurations().listed().get(configuration)
    return listed is not None and all(listed[key] == value for key, value in TELLING.items())


@dataclasses.dataclass
class Work:
    """The work of a frame, in tokens of the whole frame. What the counters of a core do not say is
    None."""

    packets: int
    nodes: int  # fetched, both levels
    list_entries: int  # entries read, both levels
    vectors: int  # through the transformation
    steps: int | None = None  # inner nodes fetched
    leaf_fetches: int | None = None  # leaves fetched by a packet with a living ray
    triangles: int | None = None  # packets transformed to a triangle, after the mailbox
    objects: int | None = None  # packets transformed to an object, after the mailbox

    @staticmethod
    def of(frame: Json) -> "Work":
        tokens = frame["counters"]
        packets = tokens["shade_job.tokens"]
        nodes = tokens["node_lookup.transactions"]
        entries = tokens["list_lookup.transactions"]
        vectors = tokens.get("transformation.transactions", 0)
        if not _tells(frame["configuration"]):
            return Work(packets, nodes, entries, vectors)
        # Four candidates for every triangle, and four that reset the hits of a new packet.
        triangles = tokens["collect_hits.transactions"] // 4 - packets
        objects = tokens["transform_job.tokens"] - triangles - packets
        seen = entries - triangles - objects
        # The list gets a job for every leaf, entry already seen, triangle done and object done.
        leaves = tokens["list_job.tokens"] - seen - triangles - objects
        return Work(packets, nodes, entries, vectors, nodes - leaves, leaves, triangles, objects)

    def bound(self) -> int:
        """Clocks of the busiest unit alone: a node, a list entry or a vector a clock."""
        return max(self.nodes, self.vectors, self.list_entries)

    def per_packet(self, name: str) -> float | None:
        value = getattr(self, name)
        return None if value is None else float(value) / self.packets


def busiest(frame: Json) -> tuple[str, int]:
    """Name and transactions of the unit with most transactions."""
    units = frame["units"]
    return max(((name, int(u["transactions"])) for name, u in units.items()), key=lambda u: u[1])


def rays(frame: Json) -> int:
    return int(frame["width"] * frame["height"])


def read_bytes(frame: Json) -> int:
    """The bytes of the scene that came from the memory."""
    return int(frame["memory"]["bytes_read"])


def written_bytes(frame: Json) -> int:
    """Those of pixels and of hit records."""
    memory = frame["memory"]
    return int(memory["pixel_bytes_written"] + memory["hit_bytes_written"])


@dataclasses.dataclass
class Speed:
    """How much of something one core does in a second, over several pairs of runs."""

    median: float
    low: float
    high: float
    last: Run  # of the full size

    @staticmethod
    def measure(
        dynrt: Dynrt,
        board: str,
        scene: str,
        config: str,
        size: str,
        runs: int,
        amount: Callable[[Json], float],
        progress: Progress,
    ) -> "Speed":
        """`amount` of a frame per CPU second. From each run of `size` one of 2x2 pixels is taken
        away, so that import, tree and upload do not count, and neither does what else the machine
        is doing."""
        speeds = []
        for number in range(runs):
            progress(f"{board}, {config}, {size}: run {number + 1} of {runs}")
            run = dynrt.render(scene, board, config, size)
            start = dynrt.render(scene, board, config, "2x2")
            seconds = max(run.cpu_seconds - start.cpu_seconds, 1e-3)
            speeds.append((amount(run.frame) - amount(start.frame)) / seconds)
        return Speed(statistics.median(speeds), min(speeds), max(speeds), run)
