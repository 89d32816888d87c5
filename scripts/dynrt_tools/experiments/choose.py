# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Finds the cheapest variant of the core that keeps an error of a scene's frame below a bound.

Each variant runs at the shortest period for which hlsc can schedule all its units. A variant costs
the time of a frame at that period times the part of an LFE5U-85F that its core takes: the
largest part that it takes of the LUTs, the flip-flops, the multipliers or the block RAMs, as this
part bounds the number of pipelines that fit. If two variants cost the same, the one with fewer LUTs
is cheaper."""

import argparse
import math
import pathlib
import sys
from collections.abc import Mapping

from dynrt_tools.experiments import page
from dynrt_tools.experiments.command import guarded, measured
from dynrt_tools.experiments.error import clock_ns, measures_of
from dynrt_tools.experiments.flags import MISTAKE, Parser, add_error_arguments
from dynrt_tools.experiments.rows import aligned
from dynrt_tools.hardware import devices
from dynrt_tools.project import Failed, Json, write_json

DEVICE = devices.DEVICES["ecp5-85"]
DEFAULT_MEASURE = "primary.t_p99"


def part_of_device(variant: Json) -> tuple[float, str]:
    """The largest part that its core takes of a resource of the device, and the resource."""
    return max((variant["takes"][name] / count, name) for name, count in DEVICE["has"].items())


def cost(variant: Json, frame: Json) -> tuple[float, int]:
    """To compare by: area times time, then LUTs. Area alone where no clocks are known."""
    return part_of_device(variant)[0] * frame.get("frame_ms", 1), variant["area"]["LUT"]


def directions() -> Mapping[str, str]:
    """Whether "less" or "more" is better, of every measure of error."""
    return {
        f"{m['group']}.{m['name']}": m["better"]
        for m in page.read_measures()
        if m["better"] in ("less", "more")
    }


def check_measure(runs: list[Json], named: str) -> None:
    found = {m for run in runs for m in measures_of(run)}
    known = [m for m in directions() if m in found]
    if named not in known:
        raise Failed(f"--measure {named}: this scene has none; its measures are {', '.join(known)}")


def worse(measure: str, value: float) -> float:
    """Orders figures of a measure, the least error first."""
    return -value if directions()[measure] == "more" else value


def holds(measure: str, value: float | None, bound: float) -> bool:
    if value is None:  # of a psnr: not one pixel differs
        return directions()[measure] == "more"
    return worse(measure, value) <= worse(measure, bound)


def choose(report: Json, measure: str, bound: float) -> tuple[list[Json], list[Json]]:
    """All variants that could render the scene, the cheapest first, and those of them that hold the
    bound."""
    runs = [run for run in report["runs"] if "refused" not in run]
    if not runs:
        raise Failed("no variant can render this scene; " + report["runs"][0]["refused"])
    check_measure(runs, measure)
    runs.sort(key=lambda run: cost(report["variants"][run["variant"]], run))
    return runs, [r for r in runs if holds(measure, measures_of(r).get(measure), bound)]


def number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


def table(report: Json, runs: list[Json], measure: str, bound: float) -> str:
    heads = ("variant", measure, "LUT", "mult", "BRAM", "clocks", "clock, ns", "ms")
    rows: list[tuple[str, ...]] = [(*heads, f"part of {DEVICE['name']}", "cost", "")]
    for run in runs:
        variant = report["variants"][run["variant"]]
        area, (part, resource) = variant["area"], part_of_device(variant)
        value = measures_of(run).get(measure)
        rows.append(
            (
                run["variant"],
                number(value),
                *(str(area[name]) for name in ("LUT", "mult", "BRAM")),
                str(run.get("clocks", "-")),
                number(clock_ns(variant)),
                number(run.get("frame_ms")),
                f"{100 * part:.1f} % of {resource}s",
                number(cost(variant, run)[0]),
                "holds" if holds(measure, value, bound) else "",
            )
        )
    return aligned(rows)


def check_bound(args: argparse.Namespace) -> None:
    """Refuses a mistake in the flags before anything is measured."""
    if args.measure not in directions():
        raise Failed(
            f"--measure {args.measure}: unknown; the measures are {', '.join(directions())}"
        )
    if not math.isfinite(args.max_error):
        raise Failed(f"--max-error {args.max_error}: must be a number")


def run_choice(args: argparse.Namespace) -> int:
    check_bound(args)
    report = measured(args, [args.scene])
    runs, holding = choose(report, args.measure, args.max_error)
    print(table(report, runs, args.measure, args.max_error) + "\n")
    if holding:
        best = holding[0]
        print(
            f"{best['variant']} is the cheapest with {args.measure} "
            f"{number(measures_of(best)[args.measure])}, the bound being {args.max_error:g}"
        )
        if args.json:
            keys = report["variants"][best["variant"]]["configuration"]
            write_json(args.json, {"measure": args.measure, "configuration": keys})
        return 0
    measurable = [r for r in runs if measures_of(r).get(args.measure) is not None]
    if not measurable:
        raise Failed(f"--measure {args.measure}: no variant has this figure on this scene")
    best = min(measurable, key=lambda r: worse(args.measure, measures_of(r)[args.measure]))
    print(
        f"dynrt: no variant reaches {args.measure} {args.max_error:g} on this scene; the best is "
        f"{best['variant']} with {number(measures_of(best)[args.measure])}",
        file=sys.stderr,
    )
    return MISTAKE


def main() -> int:
    parser = Parser(
        prog="dynrt choose",
        description=__doc__,
        epilog="Figures that `dynrt report error` has measured into the same --out are not "
        "measured again.",
    )
    parser.add_argument("scene", metavar="SCENE", help="a built-in scene or a file")
    parser.add_argument(
        "--max-error",
        type=float,
        required=True,
        metavar="E",
        help="the bound of the measure; for a PSNR, the least value",
    )
    parser.add_argument(
        "--measure",
        default=DEFAULT_MEASURE,
        metavar="KIND.NAME",
        help=f"the error that is bounded (default: {DEFAULT_MEASURE}); an unknown name "
        "prints the list of measures",
    )
    parser.add_argument(
        "--json",
        type=pathlib.Path,
        metavar="FILE",
        help="write the measure and the keys of the variant that is chosen as data",
    )
    add_error_arguments(parser)
    return guarded(run_choice, parser.parse_args())
