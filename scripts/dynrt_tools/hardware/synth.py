# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Synthesizes the units and the whole core with Yosys and prints the cells of a
family that each takes, or its part of a device."""

import argparse
import pathlib
import sys

from dynrt_tools import options, project, unit_names
from dynrt_tools.command import Pool
from dynrt_tools.hardware import devices, rtl_files, synthesis
from dynrt_tools.project import Json


def print_areas(name: str, rows: dict[str, Json]) -> None:
    family = devices.FAMILIES[devices.family_of(name)]
    title = devices.DEVICES[name]["name"] if name in devices.DEVICES else family["name"]
    width = max(len("unit"), *(len(top) for top in rows))
    print(f"\n{title} ({family['synth'].split('; ')[-1].split(' -top')[0]})")
    print(f"{'unit':<{width}}" + "".join(f"{c:>9}" for c in devices.COLUMNS) + f"{'seconds':>9}")
    for top, row in rows.items():
        print(
            f"{top:<{width}}"
            + "".join(f"{row['area'][c]:>9}" for c in devices.COLUMNS)
            + f"{row['seconds']:>9.0f}"
        )
    print("each column counts cells of Yosys; LUT has those of logic alone")


def print_shares(name: str, rows: dict[str, Json]) -> None:
    """The part of the device that each takes, with the LUTs of carry cells and of LUT RAM."""
    has = devices.DEVICES[name]["has"]
    width = max(len("unit"), *(len(top) for top in rows))
    print(f"\n{'of the device':<{width}}" + "".join(f"{r:>11}        " for r in has))
    print(f"{'':<{width}}" + "".join(f"{n:>11,}        " for n in has.values()))
    for top, row in rows.items():
        taken = row["resources"]
        print(
            f"{top:<{width}}"
            + "".join(
                f"{taken.get(r, 0):>11,.0f} {100 * taken.get(r, 0) / n if n else 0:>5.1f} %"
                for r, n in has.items()
            )
        )
    print(f"{devices.formula(devices.family_of(name))}, in cells of Yosys")


def shares(name: str, rows: dict[str, Json]) -> Json:
    """The part of the device that each module takes, in percent, and that of its logic alone."""
    has = devices.DEVICES[name]["has"]
    luts = next(iter(has.values()))
    return {
        top: {r: round(100 * row["resources"].get(r, 0) / n, 1) for r, n in has.items() if n}
        | {"logic alone": round(100 * row["area"]["LUT"] / luts, 1)}
        for top, row in rows.items()
    }


def misfits(names: list[str], figures: dict[str, dict[str, Json]]) -> tuple[list[str], set[str]]:
    """A sentence for every module that a device cannot hold, and those that none of them holds."""
    sentences, nowhere = [], set()
    parts = [n for n in names if n in devices.DEVICES]
    for top in {top: None for n in parts for top in figures[n]}:
        short = {
            n: devices.shortages(n, figures[n][top]["resources"])
            for n in parts
            if top in figures[n]
        }
        sentences += [f"{top} does not fit {n}: {'; '.join(s)}" for n, s in short.items() if s]
        if short and all(short.values()):
            nowhere.add(top)
    return sentences, nowhere


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/synth",
        description=__doc__,
        epilog="The folder that DYNRT_CACHE names, else build/synth, keeps every result under a key "
        "of its sources.",
    )
    parser.add_argument(
        "unit",
        nargs="*",
        metavar="UNIT",
        help="units to synthesize, by module or header, or other modules of the core and the board "
        "(default: every unit, then the whole core)",
    )
    rtl_files.add_arguments(parser)
    parser.add_argument(
        "--device",
        action="append",
        metavar="NAME",
        help=f"a device ({', '.join(devices.DEVICES)}), or a family "
        f"({', '.join(devices.FAMILIES)}) for areas alone; may be repeated "
        "(default: ecp5-85 and virtex2-6000)",
    )
    parser.add_argument(
        "--core",
        default="dynrt_core",
        metavar="MODULE",
        help="the module that holds the whole core (default: dynrt_core)",
    )
    parser.add_argument("--units-only", action="store_true", help="leave out the whole core")
    options.add_jobs(parser, "Yosys processes")
    parser.add_argument(
        "--json", type=pathlib.Path, metavar="FILE", help="also write the figures as data"
    )
    return parser.parse_args()


def boards_of(args: argparse.Namespace, unit_files: list[pathlib.Path]) -> pathlib.Path | None:
    """The folder with the Verilog of boards, where modules outside the core are named and there is
    a build that makes it."""
    units = rtl_files.headers(unit_files)
    if set(args.unit) <= {*units, *units.values(), args.core}:
        return None
    try:
        rtl_files.find_build(args.build)
    except project.Failed:
        return None
    return rtl_files.made_by(args.build, rtl_files.FOR_BOARDS)


def chosen(
    args: argparse.Namespace, unit_files: list[pathlib.Path], files: list[pathlib.Path]
) -> list[str]:
    """The modules to synthesize; throws Failed for a name that is none's."""
    units = sorted(m for m in synthesis.modules(unit_files) if m != args.core)
    names = args.unit or [*units, *([] if args.units_only else [args.core])]
    known = synthesis.modules(files)
    headers = {m: m for m in known} | rtl_files.headers(unit_files)
    return unit_names.all_modules_of(names, headers)


def synthesize(name: str, top: str, files: list[pathlib.Path]) -> Json:
    family = devices.family_of(name)
    cells, seconds = synthesis.cells(
        top, files, devices.FAMILIES[family]["synth"], f"{top} on {name}"
    )
    return {
        "area": devices.area(family, cells),
        "seconds": seconds,
        "resources": devices.resources(family, cells),
    }


def main() -> int:  # pylint: disable=too-many-branches
    args = parse()
    names = args.device or ["ecp5-85", "virtex2-6000"]
    try:
        for name in names:
            devices.family_of(name)
    except devices.Unknown as error:
        project.fail(error)
    if args.json:
        project.check_output("--json", args.json)
    try:
        unit_files = rtl_files.generated(args.config, args.build)
        files = rtl_files.sources(unit_files, boards_of(args, unit_files))
        tops = chosen(args, unit_files, files)
    except project.Failed as error:
        project.fail(error)

    figures: dict[str, dict[str, Json]] = {name: {} for name in names}
    failed = False
    with Pool(args.jobs) as pool:
        # The core takes longest, so it starts first.
        jobs = {(n, t): pool.submit(synthesize, n, t, files) for t in reversed(tops) for n in names}
        for name in names:
            for top in tops:
                if sys.stderr.isatty():
                    print(f"\r\033[Ksynthesizing {top} for {name}", end="", file=sys.stderr)
                try:
                    figures[name][top] = jobs[name, top].result()
                except project.Failed as error:
                    print(f"synth: {error}", file=sys.stderr)
                    failed = True
            if sys.stderr.isatty():
                print("\r\033[K", end="", file=sys.stderr)
            if figures[name]:
                print_areas(name, figures[name])
                if name in devices.DEVICES:
                    print_shares(name, figures[name])
    sentences, nowhere = misfits(names, figures)
    for sentence in sentences:
        print(f"synth: {sentence}", file=sys.stderr)
    if args.json:
        parts = {
            key: {n: {top: row[key] for top, row in rows.items()} for n, rows in figures.items()}
            for key in ("area", "resources")
        }
        project.write_json(
            args.json,
            {
                "config": args.config,
                "counted": {n: devices.formula(devices.family_of(n)) for n in names},
                "devices": parts["area"],
                "resources": parts["resources"],
                "has": {n: devices.DEVICES[n]["has"] for n in names if n in devices.DEVICES},
                "shares": {n: shares(n, figures[n]) for n in names if n in devices.DEVICES},
                "latency": rtl_files.latencies(unit_files),
            },
        )
    return 1 if failed or nowhere else 0
