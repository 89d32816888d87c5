# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of the thesis's chapter 7.2 for our cores: how busy the units are, how often the caches
hit, and the frame rate and the quality of the hardware over packets, lines, the memory's bandwidth and
pipelines, as one page with plots and tables, as CSV, JSON and SVG. The clocks are those of the native
model, which are the Verilog's."""

import argparse
import pathlib
import re
import sys

from dynrt_tools.hardware_report import additions, collect, page, plots, points
from dynrt_tools.hardware_report.figure import Figure
from dynrt_tools.hardware_report.figures import FIGURES
from dynrt_tools.hardware_report.jobs import Workflow
from dynrt_tools.project import Failed, Json
from dynrt_tools.report import report as shared
from dynrt_tools.report.collect import check_writable, written_first
from dynrt_tools.report.variants import base_configuration

SCENES = ("office", "cistern", "conference", "trees4000")
CURVES = ("full", "fast", "fast_port")
TABLE = ("thesis", "full", "fast", "fast_watertight", "fast_port")
FRAMES = 3  # of a walk
MOST_FRAMES = 100  # so that a job ends within the hour
MISSING = 1  # the exit code of a report in which something is missing


def parse() -> argparse.Namespace:
    parser = shared.Parser(
        prog="dynrt report hardware",
        description=__doc__,
        epilog="Exit codes: 0 success; 1 something is missing, and the page says what; 2 a mistake in "
        "the input or the flags. scripts/dynrt_tools/hardware_report/README.md describes the report.",
    )
    parser.add_argument(
        "scene",
        nargs="*",
        metavar="SCENE",
        help=f"built-in scenes or files (default: {' '.join(SCENES)})",
    )
    shared.add_program_arguments(parser)
    parser.add_argument(
        "--config",
        action="append",
        default=[],
        metavar="NAME",
        help="configuration that has curves, or a FILE.json with one; can be given several times "
        f"(default: {' '.join(CURVES)})",
    )
    parser.add_argument(
        "--table",
        action="append",
        default=[],
        metavar="NAME",
        help="configuration that stands in the table with all its packets and lines, beside those "
        f"that have curves; can be given several times (default: {' '.join(TABLE)})",
    )
    parser.add_argument(
        "--figure",
        action="append",
        default=[],
        metavar="NUMBER",
        help="only this figure of the thesis, or what the indices say of this project's additions; can "
        f"be given several times (default: {' '.join(numbers())})",
    )
    parser.add_argument(
        "--frames",
        type=int,
        default=FRAMES,
        metavar="N",
        help="frames of each scene's walk over which every figure is the mean, as dynrt walk spreads "
        f"them (default: {FRAMES})",
    )
    shared.add_job_arguments(parser, "hardware_report")
    parser.add_argument(
        "--drawings", type=pathlib.Path, metavar="FOLDER", help="write the drawings there too"
    )
    parser.add_argument(
        "--json", type=pathlib.Path, metavar="FILE", help="write the data to this file too"
    )
    return parser.parse_args()


def numbers() -> list[str]:
    """The thesis's numbers of the figures, and the table of additions."""
    return [*(number for figure in FIGURES for number in figure.numbers), additions.NAME]


def figures_of(named: list[str]) -> list[Figure]:
    """The figures with these numbers, or all."""
    for number in named:
        if number not in numbers():
            raise Failed(f"--figure {number}: unknown; the figures are {', '.join(numbers())}")
    return [f for f in FIGURES if not named or set(f.numbers) & set(named)]


def chosen(
    curves: list[str], table: list[str], figures: list[Figure], compared: bool
) -> dict[str, Json]:
    """The configurations by name, in the order of the table; `keys`, `named`, `curves`, `points` of
    each: those of the figures and, if they are `compared`, of the additions; or its own alone."""
    found: dict[str, Json] = {}
    for named in dict.fromkeys([*table, *curves]):
        path = pathlib.Path(named)
        name = re.sub(r"[^A-Za-z0-9_]", "_", path.stem) if path.suffix == ".json" else named
        if name in found:
            raise Failed(
                f"--config {named}: another configuration of this report is named '{name}'"
            )
        keys = base_configuration(named)
        if not keys["counters"]:
            raise Failed(
                f"--config {named}: it counts nothing, so nobody can tell the use of its units; set "
                "counters to true"
            )
        own, others = points.own_point(keys), additions.wanted(name, keys) if compared else []
        found[name] = {
            "keys": keys,
            "named": str(path.absolute()) if path.suffix == ".json" else named,
            "curves": named in curves,
            "points": points.points(keys, figures, others) if named in curves else [own],
        }
    return found


def check_outputs(args: argparse.Namespace) -> None:
    """Before the work."""
    check_writable(args.out)
    for flag, path, folder, other in (
        ("--json", args.json, args.json and args.json.absolute().parent, "a file elsewhere"),
        ("--drawings", args.drawings, args.drawings, "another"),
    ):
        if folder and not folder.is_dir():
            raise Failed(
                f"{flag} {path}: there is no folder '{path if folder == path else path.parent}'; "
                f"create it or name {other}"
            )


def made(args: argparse.Namespace) -> Json:
    """Runs the jobs that have no result yet and collects them."""
    if not 1 <= args.frames <= MOST_FRAMES:
        raise Failed(f"--frames {args.frames}: a report's walk has 1 to {MOST_FRAMES} frames")
    figures = figures_of(args.figure)
    compared = not args.figure or additions.NAME in args.figure
    curves, table = args.config or list(CURVES), args.table or list(TABLE)
    configurations = chosen(curves, table, figures, compared)
    shared.check_jobs(args, "a hardware report", "hlsc")
    known = shared.known_scenes(args, args.scene or list(SCENES))
    check_outputs(args)
    folder = shared.work_folder(args.out)
    workflow = Workflow(folder, args.program.resolve(), args.build.resolve(), args.expect)
    names = [figure.name for figure in figures] + [additions.NAME] * compared
    with workflow.alone():
        paths = {name: scene["path"] for name, scene in known.items()}
        workflow.prepare(paths, configurations, args.size, args.frames)
        failures = workflow.failures(args.jobs, args.slurm)
        report = collect.collect(folder, known, configurations, args.size, args.frames, names)
    report["missing"] = failures + report["missing"]
    if not report["runs"]:
        raise Failed(f"there is no walk to report; {report['missing'][0]}")
    return report


def run(args: argparse.Namespace) -> int:
    report = made(args)
    with written_first(args.out) as new:
        collect.write_json(new / "hardware.json", report)
        collect.write_csv(new / "hardware.csv", report)
        drawings = plots.write(new, report)
        page.write_page(new / "hardware.json", new / "hardware.html")
    if args.drawings:
        plots.write(args.drawings, report)
    if args.json:
        collect.write_json(args.json, report)
    for sentence in report["missing"]:
        print(f"dynrt: missing: {sentence}", file=sys.stderr)
    print(
        f"{len(report['runs'])} walks with {len(report['configurations'])} configurations through "
        f"{len(report['scenes'])} scenes: {args.out}/hardware.html, hardware.csv, hardware.json and "
        f"{len(drawings)} drawings"
    )
    return MISSING if report["missing"] else 0


def main() -> int:
    return shared.guarded(run, parse())
