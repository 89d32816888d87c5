# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What each key that makes `fast` another core than `full` brings, and what the watertight test then
costs: frames of the clock-exact model and the room that Yosys counts, with one key more for each row,
in the order of hls/configs/configs.json."""

import dataclasses
import itertools
import os
import pathlib
import tempfile

from dynrt_tools.bench import cores
from dynrt_tools.bench.run import Dynrt, RunFailed
from dynrt_tools.hardware import area
from dynrt_tools.project import ROOT, Failed, Json, Progress, read_json

# Each configuration is like the one before it.
STEPS = ("full", "fast", "fast_watertight")
BASE = STEPS[0]
SCENES = ("office", "cistern", "conference", "trees4000")
ROOM = {"LUT4": "LUT4", "FF": "flip-flops", "block RAM": "block RAMs", "multiplier": "multipliers"}
NO_LEVER = {"name", "like", "about", "rtl", "counters", "scan_out"}


@dataclasses.dataclass
class Lever:
    """A key with its value, and all keys so far."""

    name: str
    value: object
    keys: Json


def levers(configurations: list[Json]) -> list[Lever]:
    """Nothing first, then key by key."""
    named = {one["name"]: one for one in configurations}
    found = [Lever(BASE, None, {})]
    for before, name in itertools.pairwise(STEPS):
        like = named[name]["like"]
        if like != before:
            raise RunFailed(f"{name} is like {like}, not like {before}, so no key is a step to it")
        for key, value in named[name].items():
            if key not in NO_LEVER:
                found.append(Lever(key, value, {**found[-1].keys, key: value}))
    return found


def frame_of(size: str, measured: Json) -> Json:
    """The figures of a frame that the table shows."""
    width, height = map(int, size.split("x"))
    clocks = measured["clocks"]
    work = {
        name.removesuffix(".transactions"): count
        for name, count in measured["counters"].items()
        if name.endswith(".transactions")
    }
    # Those before and behind the transformation work as often as it does, and for it.
    busiest = max(work, key=lambda unit: (work[unit], unit == "transformation"))
    return {
        "clocks": clocks,
        "rays per clock": width * height / clocks,
        "busiest unit": busiest,
        "use": work[busiest] / clocks,
        "wrong hits": measured["measures"]["primary"]["wrong_share"],
    }


def room_of(verilog: pathlib.Path) -> Json:
    """What the core in this folder takes of an ECP5, each of its units synthesized alone."""
    try:
        takes = area.hardware(verilog, jobs=os.cpu_count() or 1)["takes"]
    except Failed as error:
        raise RunFailed(str(error)) from error
    return {resource: takes[resource] for resource in ROOM}


def measure(dynrt: Dynrt, size: str, progress: Progress) -> list[Json]:
    """A row for each lever, with its room and each scene's frame."""
    rows = []
    steps = levers(read_json(ROOT / "hls" / "configs" / "configs.json"))
    with tempfile.TemporaryDirectory() as name:
        for number, lever in enumerate(steps, 1):
            config = pathlib.Path(name) / f"step_{number}.json"
            core = cores.made(dynrt.program, config, BASE, lever.keys)
            progress(f"{lever.name}, step {number} of {len(steps)}: Yosys counts its room")
            row: Json = {
                "lever": lever.name,
                "value": lever.value,
                "room": room_of(core.schedules),
            }
            for scene in SCENES:
                progress(f"{lever.name}, step {number} of {len(steps)}: {scene}")
                row[scene] = frame_of(size, dynrt.measure(scene, core.config, core.schedules, size))
            rows.append(row)
    return rows


def table(rows: list[Json]) -> str:
    """Rays a clock of each scene, the busiest unit's share of the clocks, and the room."""
    heads = "".join(f"{scene:>30}" for scene in SCENES)
    lines = [f"{'':26}{heads}" + "".join(f"{name:>13}" for name in ROOM.values())]
    for row in rows:
        value = "" if row["value"] is None else f" {row['value']}"
        cells = [
            f"{row[scene]['rays per clock']:.4f} {row[scene]['busiest unit']:>16} "
            f"{100 * row[scene]['use']:3.0f}%"
            for scene in SCENES
        ]
        room = "".join(f"{row['room'][resource]:13,.0f}" for resource in ROOM)
        lines.append(f"{row['lever'] + value:26}" + "".join(f"{cell:>30}" for cell in cells) + room)
    return "\n".join(lines)
