# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a memory behind the port costs beside banks of SRAM: frames of the clock-exact model at several
latencies, and with one key of `fast_port` changed for each row."""

import dataclasses
import itertools
import os
import pathlib
import tempfile

from dynrt_tools.bench import cores
from dynrt_tools.bench.run import Dynrt, RunFailed, rays, read_bytes
from dynrt_tools.command import Pool
from dynrt_tools.project import Json, Progress

SCENES = ("office", "cistern", "conference", "trees4000")  # the longest frame last
SRAM, PORT = "fast", "fast_port"
LATENCY = 30  # of the rows that change something else
CACHES = ("node", "list", "matrix", "second")


@dataclasses.dataclass(frozen=True)
class Row:
    """A core and its memory."""

    name: str
    keys: tuple[tuple[str, int | str], ...] = ()  # that differ from those of `like`
    like: str = PORT
    latency: int = LATENCY
    row_clocks: int = 0

    def flags(self) -> list[str]:
        flags = ["--no-hits"]
        if self.like == PORT:
            flags += ["--memory-latency", str(self.latency), "--row-clocks", str(self.row_clocks)]
        return flags


def one_key(key: str, *values: int | str) -> list[Row]:
    return [Row(f"{key} {value}", ((key, value),)) for value in values]


BASE = f"latency {LATENCY}"
LARGEST = "second_level 128"  # the most KB that it can have
ROWS = (
    Row(SRAM, like=SRAM),
    *(Row(f"latency {clocks}", latency=clocks) for clocks in (8, LATENCY, 100, 200)),
    Row("row_clocks 10", row_clocks=10),
    # Nothing of what fast_port does to read less, and a port no wider than a node.
    Row(
        "direct-mapped",
        (
            ("ways", 1),
            ("line_nodes", 1),
            ("triangle_matrix", "normal_consistent"),
            ("second_level", 0),
            ("port_bytes", 8),
        ),
    ),
    *one_key("ways", 1, 4),
    *one_key("second_level", 0, 16, 128),
    *one_key("line_nodes", 1, 4),
    *one_key("triangle_matrix", "normal_consistent"),
    *one_key("port_bytes", 8, 32),
    *one_key("pipelines", 2, 4),
    Row("pipelines 4, ways 4", (("pipelines", 4), ("ways", 4))),
)

SHARE, PIPELINES, READ = "share of SRAM", "frames of one pipeline", "bytes read per ray"
FIGURES = {SHARE: ".1%", PIPELINES: ".2f", READ: ".2f"}  # as they are shown
# At least so much of a row's figure in a scene.
ASKED = (
    (BASE, SHARE, {scene: 0.97 for scene in SCENES}),
    ("latency 100", SHARE, {"office": 0.9, "cistern": 0.9, "conference": 0.85}),
    ("pipelines 4", PIPELINES, {"office": 3.6, "cistern": 3.6, "conference": 3.2}),
)
# At most, half of what direct-mapped caches without second level read when the aim was set.
ASKED_READ = {"office": 11 / 2, "cistern": 6 / 2, "conference": 33 / 2, "trees4000": 157 / 2}


def busiest(units: Json) -> tuple[str, float]:
    """The unit that works in most of the clocks, and their share."""
    # Those before and behind the transformation work as often as it does, and for it.
    name = max(units, key=lambda unit: (units[unit]["utilisation"], unit == "transformation"))
    return name, units[name]["utilisation"]


def figures_of(frame: Json) -> Json:
    """What the table has of one frame, without what other frames must be known for."""
    if not frame["cycles"]:
        raise RunFailed(f"the frame of {frame['configuration']} has no clocks")
    unit, use = busiest(frame["units"])
    hits = {f"{cache} hits": frame["caches"].get(cache, {}).get("hit_rate") for cache in CACHES}
    return {
        "clocks": frame["cycles"],
        "rays per clock": rays(frame) / frame["cycles"],
        READ: read_bytes(frame) / rays(frame),
        **hits,
        "busiest unit": unit,
        "use": use,
        "port": frame["units"].get("memory_gather", {}).get("utilisation"),
    }


def compared(rows: list[tuple[Row, str, Json]]) -> list[Json]:
    """The frames as data, each beside that of SRAM and, of several pipelines, that of one."""
    clocks = {(row.name, scene): figures["clocks"] for row, scene, figures in rows}
    found = []
    for row, scene, figures in rows:
        keys = dict(row.keys)
        one = f"ways {keys['ways']}" if "ways" in keys else BASE
        found.append(
            {
                "row": row.name,
                "scene": scene,
                **figures,
                SHARE: clocks[SRAM, scene] / figures["clocks"],
                PIPELINES: clocks[one, scene] / figures["clocks"] if "pipelines" in keys else None,
            }
        )
    return found


def aims(frames: list[Json]) -> list[Json]:
    """What is asked of the frames, and whether they reach it."""
    of = {(frame["row"], frame["scene"]): frame for frame in frames}
    found = []
    for row, figure, wanted in ASKED:
        for scene, asked in wanted.items():
            found.append((row, figure, scene, asked, of[row, scene][figure] >= asked))
    for row, (scene, asked) in itertools.product((BASE, LARGEST), ASKED_READ.items()):
        found.append((row, READ, scene, asked, of[row, scene][READ] <= asked))
    return [
        {
            "row": row,
            "figure": figure,
            "scene": scene,
            "asked": asked,
            "reached": of[row, scene][figure],
            "verdict": "reached" if met else "missed",
        }
        for row, figure, scene, asked, met in found
    ]


def measure(dynrt: Dynrt, size: str, progress: Progress) -> Json:
    """A frame of each row and scene, as many at a time as there are processors, which the clocks do
    not depend on."""
    made: dict[tuple[object, ...], cores.Core] = {}
    with tempfile.TemporaryDirectory() as folder:
        for number, row in enumerate(ROWS, 1):
            progress(f"core of {row.name}, row {number} of {len(ROWS)}")
            config = pathlib.Path(folder, row.name.replace(" ", "_") + ".json")
            if (row.like, row.keys) not in made:
                core = cores.made(dynrt.program, config, row.like, dict(row.keys))
                made[row.like, row.keys] = core
        # The longest first.
        jobs = [(row, scene) for scene in reversed(SCENES) for row in ROWS]
        begun = itertools.count(1)

        def one(job: tuple[Row, str]) -> Json:
            row, scene = job
            progress(f"{row.name}: {scene}, frame {next(begun)} of {len(jobs)}")
            core = made[row.like, row.keys]
            flags = ("--schedule", str(core.schedules), *row.flags())
            return figures_of(dynrt.render(scene, "model", core.config, size, *flags).frame)

        with Pool(os.cpu_count()) as pool:
            figures = dict(zip(jobs, pool.map(one, jobs)))
    frames = compared([(row, scene, figures[row, scene]) for row in ROWS for scene in SCENES])
    return {"size": size, "frames": frames, "aims": aims(frames)}


def table(measured: Json) -> str:
    """A line for each row and scene, and one for each aim."""

    def share(value: float | None) -> str:
        return "-" if value is None else f"{100 * value:.1f}%"

    heads = "".join(f"{head:>8}" for head in (*CACHES, "port"))
    lines = [
        f"{'':32}{'clocks':>10}{'rays/clock':>12}{'of SRAM':>9}{'bytes/ray':>11}{heads}"
        "  busiest unit"
    ]
    for frame in measured["frames"]:
        times = frame[PIPELINES]
        of_sram = share(frame[SHARE]) if times is None else f"x{times:.2f}"
        hits = (*(frame[f"{cache} hits"] for cache in CACHES), frame["port"])
        lines.append(
            f"{frame['row']:20}{frame['scene']:12}{frame['clocks']:>10,}"
            f"{frame['rays per clock']:>12.4f}{of_sram:>9}{frame[READ]:>11.2f}"
            + "".join(f"{share(hit):>8}" for hit in hits)
            + f"  {frame['busiest unit']} {share(frame['use'])}"
        )
    lines.append("\nx: times the frames of one pipeline. Aims:")
    for aim in measured["aims"]:
        asked, reached = (
            format(aim[part], FIGURES[aim["figure"]]) for part in ("asked", "reached")
        )
        limit = "less" if aim["figure"] == READ else "more"
        lines.append(
            f"{aim['row']:20}{aim['scene']:12}{aim['figure']}: {asked} or {limit}, is {reached}: "
            f"{aim['verdict']}"
        )
    return "\n".join(lines)
