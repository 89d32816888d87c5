# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Places and routes units with registers around their ports, several seeds each, and holds the
clock that they reach against the one that hlsc's delay model predicts.

Units are lowered for the device's delay model. Those that do not fit the device, or all where its
tool is missing, get Yosys's own timing for 7-series, which knows the delay of cells but not of
wires."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import statistics
import sys

from dynrt_tools import project
from dynrt_tools.hardware import area, devices, placing, rtl_files, synthesis
from dynrt_tools.project import Json


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/place",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="The folder that DYNRT_CACHE names, else build/synth, keeps every result under a key "
        "of its sources.",
    )
    parser.add_argument(
        "unit",
        nargs="*",
        metavar="UNIT",
        help="units to place (default: every unit; on ecp5-85 the whole core too)",
    )
    parser.add_argument(
        "--device",
        default="ice40-hx8k",
        metavar="NAME",
        help=f"one of {', '.join(placing.TOOLS)} (default: ice40-hx8k)",
    )
    parser.add_argument(
        "--clock-ns",
        type=float,
        default=10.0,
        metavar="NS",
        help="the period that hlsc schedules for (default: 10)",
    )
    parser.add_argument("--seeds", type=int, default=5, metavar="N", help="placements (default: 5)")
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        help="the build whose hlsc lowers (default: build/release, else build/dev)",
    )
    parser.add_argument(
        "--jobs",
        type=int,
        default=os.cpu_count(),
        metavar="N",
        help="tools at a time (default: the number of cores)",
    )
    parser.add_argument(
        "--json", type=pathlib.Path, metavar="FILE", help="also write the figures as data"
    )
    return parser.parse_args()


def examine(unit: dict[str, str], args: argparse.Namespace, build: pathlib.Path) -> Json:
    """All that is known of a unit on the device."""
    name = unit["module"]
    device = devices.DEVICES[args.device]
    try:
        folder = placing.lower(build, unit, args.clock_ns, device["delay"])
    except project.Failed as error:
        return {"unit": name, "note": f"not lowered: {error}"}
    files = rtl_files.hand_written() + [folder / f"{name}.v"]
    row: Json = {"unit": name} | area.schedule((folder / f"{name}.txt").read_text(encoding="utf-8"))
    family = device["family"]
    cells, _ = synthesis.cells(name, files, devices.FAMILIES[family]["synth"], name)
    row["resources"] = devices.resources(family, cells)
    short = devices.shortages(args.device, row["resources"])
    tool = placing.TOOLS[args.device]
    if short:
        row["note"] = "does not fit: " + "; ".join(short)
    elif not shutil.which(tool["program"]):
        row["note"] = f"{tool['program']} is not on the PATH"
    else:
        try:
            row["placed"] = [
                placing.place(args.device, name, files, seed, 1000 / args.clock_ns)
                for seed in range(1, args.seeds + 1)
            ]
        except placing.DoesNotFit as error:
            row["note"] = f"does not fit: {error}"
    if "placed" not in row:
        row["logic_ns"] = placing.logic_delay(name, files)
    return row


HEAD = (
    "unit",
    "stages",
    "predicted ns",
    "cells",
    "MHz, median",
    "range",
    "placed ns",
    "of predicted",
)


def cells_of(row: Json) -> tuple[object, ...]:
    placed = row.get("placed")
    if "stages" not in row:
        return (row["unit"], "", "", "", "", "", "", row["note"])
    if not placed:
        return (
            row["unit"],
            row["stages"],
            f"{row['longest_path_ns']:.2f}",
            "",
            "",
            "",
            "",
            f"{row['note']}; cells alone {row['logic_ns']:.2f} ns on 7-series",
        )
    clocks = sorted(p["mhz"] for p in placed)
    middle = statistics.median(clocks)
    return (
        row["unit"],
        row["stages"],
        f"{row['longest_path_ns']:.2f}",
        placed[0]["cells"],
        f"{middle:.0f}",
        f"{clocks[0]:.0f} to {clocks[-1]:.0f}",
        f"{1000 / middle:.2f}",
        f"{100 * 1000 / middle / row['longest_path_ns']:.0f} %",
    )


def main() -> int:
    args = parse()
    if args.device not in placing.TOOLS:
        project.fail(
            f"there is no way to place on '{args.device}'; the devices are "
            f"{', '.join(placing.TOOLS)}"
        )
    if args.json:
        project.check_output("--json", args.json)
    tool = placing.TOOLS[args.device]
    if not shutil.which(tool["program"]):
        print(
            f"place: {tool['program']} is not on the PATH ({tool['where']}); what follows is "
            "Yosys's own timing",
            file=sys.stderr,
        )
    try:
        build = placing.find_build(args.build)
        units = placing.units(build)
        for name in args.unit:
            if name not in units:
                project.fail(f"there is no unit '{name}'; the units are {', '.join(units)}")
        rows = []
        print("".join(f"{h:<19}" if i == 0 else f"{h:>14}" for i, h in enumerate(HEAD)))
        with concurrent.futures.ThreadPoolExecutor(max(1, args.jobs)) as pool:
            for job in [pool.submit(examine, units[n], args, build) for n in args.unit or units]:
                row = job.result()
                rows.append(row)
                print(
                    "".join(
                        f"{c:<19}" if i == 0 else f"{c:>14}" for i, c in enumerate(cells_of(row))
                    ),
                    flush=True,
                )
        if args.device == "ecp5-85" and not args.unit and shutil.which(tool["program"]):
            files = rtl_files.core_files()
            core = placing.place(args.device, "dynrt_core", files, 1, 1000 / args.clock_ns)
            print(f"dynrt_core: {core['cells']} cells, {core['mhz']:.0f} MHz")
    except project.Failed as error:
        project.fail(error)
    if args.json:
        args.json.write_text(
            json.dumps({"device": args.device, "clock_ns": args.clock_ns, "units": rows}, indent=2)
            + "\n",
            encoding="utf-8",
        )
    return 0
