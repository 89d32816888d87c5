# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which change to the caches or to the layout lets a board whose memory binds render more: frames with
the SDRAM of cores that have another value of one key of `fast_port` (verif/sdram/levers.json)."""

import itertools
import os
import pathlib
import tempfile

from dynrt_tools.bench import board, cores
from dynrt_tools.bench.memory import PORT
from dynrt_tools.bench.run import Dynrt
from dynrt_tools.command import Pool
from dynrt_tools.project import ROOT, Json, Progress, read_json, write_json

LEVERS = ROOT / "verif" / "sdram" / "levers.json"
SCENES = ("office", "conference", "trees4000")  # where reads take most of the memory
SIZE = "256x192"
READ, TIMES = "bytes read per ray", "times the frames"
KEPT = ("clocks", "core_hz", READ, "share of the peak", "second hits")


def key_of(lever: Json) -> tuple[str, object]:
    """The key that a lever changes, with its value."""
    ((key, value),) = ((k, v) for k, v in lever.items() if k not in ("name", "like", "about"))
    return key, value


def schedules_of(dynrt: Dynrt, levers: list[Json], progress: Progress) -> dict[str, pathlib.Path]:
    """The folder with the schedules of each core's units."""
    found = {PORT: dynrt.program.parent / "generated" / PORT}
    with tempfile.TemporaryDirectory() as folder:
        for number, lever in enumerate(levers, 1):
            progress(f"Verilog of {lever['name']}, core {number} of {len(levers)}")
            config = pathlib.Path(folder, f"{lever['name']}.json")
            write_json(config, {key: value for key, value in lever.items() if key != "name"})
            found[lever["name"]] = cores.built(dynrt.program, config, "--verilog")
    return found


def row_of(name: str, lever: Json | None, scene: str, figures: Json, base: Json) -> Json:
    key, value = key_of(lever) if lever else (None, None)
    return {
        "lever": name,
        "key": key,
        "value": value,
        "scene": scene,
        **{figure: figures[figure] for figure in KEPT},
        TIMES: base["clocks"] / figures["clocks"],
        "times the bytes": figures[READ] / base[READ],
    }


def measure(dynrt: Dynrt, name: str, size: str, progress: Progress) -> Json:
    """A frame of each core and scene on the first system of the board."""
    levers: list[Json] = read_json(LEVERS)
    progress(f"building {len(levers)} programs for {name}")
    board.build(dynrt.program.parent, "sdram_frames_levers")
    schedules = schedules_of(dynrt, levers, progress)
    system = board.BOARDS[name]()[0]
    jobs = [(core, scene) for scene in reversed(SCENES) for core in schedules]
    begun = itertools.count(1)

    def one(job: tuple[str, str]) -> Json:
        core, scene = job
        progress(f"{core}: {scene}, frame {next(begun)} of {len(jobs)}")
        frame = board.frame_of(dynrt, core, schedules[core], scene, size, system)
        return board.figures_of(frame, system)

    with Pool(os.cpu_count()) as pool:
        measured = dict(zip(jobs, pool.map(one, jobs)))
    stated = {PORT: None} | {lever["name"]: lever for lever in levers}
    rows = [
        row_of(core, lever, scene, measured[core, scene], measured[PORT, scene])
        for core, lever in stated.items()
        for scene in SCENES
    ]
    return {"board": name, "size": size, "levers": rows}


def table(measured: Json) -> str:
    """Of each scene bytes per ray, frames per second, and these beside fast_port's."""
    lines = [f"{'':36}" + "".join(f"{scene:>30}" for scene in SCENES)]
    for name, rows in itertools.groupby(measured["levers"], lambda row: str(row["lever"])):
        cells = [
            f"{row[READ]:9.2f} B {row['core_hz'] / row['clocks']:7.1f}/s x{row[TIMES]:.3f}"
            for row in rows
        ]
        lines.append(f"{name:36}" + "".join(f"{cell:>30}" for cell in cells))
    return "\n".join(lines)
