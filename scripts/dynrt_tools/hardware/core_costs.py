# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Says what the core whose Verilog is in a folder takes of a device, as JSON: its cells, its gates
by the thesis's rule, the stages of its units, and why it fits none of the devices, if it fits none.
Without a folder it only checks that Yosys and the devices are there."""

import argparse
import pathlib
import sys

from dynrt_tools import options
from dynrt_tools.command import Pool
from dynrt_tools.hardware import area, devices, gate_count, gate_rule, synthesis
from dynrt_tools.project import Failed, Json, json_text, show_progress


def gates_of(folder: pathlib.Path, jobs: int) -> Json:
    show_progress("counting gates by the thesis's rule")
    with Pool(jobs) as pool:
        counts = gate_count.count_core(sorted(folder.glob("*.v")), pool).values()
    bits = sum(count.bits for count in counts)
    return {
        "gates": sum(count.logic for count in counts) + gate_rule.MEMORY_BIT * bits,
        "memory_bits": bits,
    }


def synthesized(folder: pathlib.Path, device: str, jobs: int) -> Json:
    show_progress(f"synthesizing for {devices.DEVICES[device]['name']}")
    return area.hardware(folder, devices.family_of(device), jobs)


def check(names: list[str]) -> None:
    synthesis.tool_version("yosys", "-V", "yosys")
    for name in names:
        if name not in devices.DEVICES:
            raise Failed(f"--device {name}: unknown; the devices are {', '.join(devices.DEVICES)}")


def misfits(folder: pathlib.Path, takes: Json, names: list[str], jobs: int) -> str | None:
    """Why the core fits none of these devices, or nothing; it takes `takes` of the first."""
    lacks = []
    for name in names:
        taken = takes if name == names[0] else synthesized(folder, name, jobs)["takes"]
        short = devices.shortages(name, taken)
        if not short:
            return None
        lacks.append(f"{devices.DEVICES[name]['name']} lacks room: {'; '.join(short)}")
    return ". ".join(lacks)


def costs_of(folder: pathlib.Path, names: list[str], jobs: int) -> Json:
    found = synthesized(folder, names[0], jobs)
    return {
        **found["takes"],
        **gates_of(folder, jobs),
        "stages": found["schedule"]["stages"],
        "misfit": misfits(folder, found["takes"], names, jobs),
    }


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/core_costs", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, nargs="?", metavar="FOLDER")
    parser.add_argument(
        "--device",
        action="append",
        metavar="NAME",
        help=f"one of {', '.join(devices.DEVICES)}; if several are given, the core must fit one of "
        "them, and the figures are of the first (default: ecp5-85)",
    )
    options.add_jobs(parser, "synthesizers")
    for name in ("--build", "--expect"):  # that made_by_script() gives to each script
        parser.add_argument(name, help=argparse.SUPPRESS)
    parser.add_argument(
        "--for-program",
        action="store_true",
        help="for programs: print a mistake in place of the figures",
    )
    args = parser.parse_args()
    names = args.device or ["ecp5-85"]
    try:
        check(names)
        costs = costs_of(args.folder, names, args.jobs) if args.folder else {}
    except Failed as error:
        show_progress("")
        if not args.for_program:
            sys.exit(f"core_costs: {error}")
        print(error)
        return 1
    show_progress("")
    print(json_text(costs))
    return 0
