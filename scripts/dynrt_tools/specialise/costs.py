# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The costs of a core: its part of a device, its gates by the thesis's rule, its stages."""

import pathlib

from dynrt_tools.command import Pool
from dynrt_tools.hardware import area, devices, gate_count, gate_rule, synthesis
from dynrt_tools.project import Failed, Json, Progress

# The figures that are printed of both cores, and their names.
COSTS = {
    "LUT4": "LUTs",
    "LUT6": "LUTs",
    "FF": "flip-flops",
    "multiplier": "multipliers",
    "block RAM": "block RAMs",
    "gates": "gates by the thesis's rule",
    "memory_bits": "bits of memory in these",
    "stages": "pipeline stages of all units",
    "clocks": "clocks of a frame",
}


def gates_of(folder: pathlib.Path, jobs: int) -> Json:
    with Pool(jobs) as pool:
        counts = gate_count.count_core(sorted(folder.glob("*.v")), pool).values()
    bits = sum(count.bits for count in counts)
    return {
        "gates": sum(count.logic for count in counts) + gate_rule.MEMORY_BIT * bits,
        "memory_bits": bits,
    }


def check_tools() -> None:
    synthesis.tool_version("yosys", "-V", "yosys")


def synthesized(folder: pathlib.Path, device: str, jobs: int, progress: Progress) -> Json:
    progress(f"synthesizing for {devices.DEVICES[device]['name']}")
    return area.hardware(folder, devices.family_of(device), jobs)


def costs_of(folder: pathlib.Path, device: str, jobs: int, progress: Progress) -> Json:
    """Of the core whose Verilog is in this folder."""
    found = synthesized(folder, device, jobs, progress)
    progress("counting gates by the thesis's rule")
    return {**found["takes"], **gates_of(folder, jobs), "stages": found["schedule"]["stages"]}


def less(general: Json, special: Json) -> Json:
    """By how much less the made core takes, in percent of the general one."""
    return {
        name: round(100 * (1 - special[name] / general[name]), 1)
        for name in general
        if name in special and general[name]
    }


def check_devices(names: list[str]) -> None:
    for name in names:
        if name not in devices.DEVICES:
            raise Failed(f"--device {name}: unknown; the devices are {', '.join(devices.DEVICES)}")


def misfits(
    folder: pathlib.Path, costs: Json, names: list[str], jobs: int, progress: Progress
) -> str | None:
    """Why the core fits none of these devices, or nothing; `costs` are of the first."""
    lacks = []
    for name in names:
        taken = {r: n for r, n in costs.items() if r in devices.DEVICES[name]["has"]}
        if name != names[0]:
            taken = synthesized(folder, name, jobs, progress)["takes"]
        short = devices.shortages(name, taken)
        if not short:
            return None
        lacks.append(f"{devices.DEVICES[name]['name']} lacks room: {'; '.join(short)}")
    return ". ".join(lacks)
