# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Renders scenes with many variants of the core and compares each with the truth: error, time and
area of every variant as CSV and as one page with plots and pictures. Each variant runs at the
shortest period for which hlsc can schedule all its units."""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from typing import NoReturn

from dynrt_tools.build import fingerprint
from dynrt_tools.build.whole import require_whole
from dynrt_tools.command import INTERRUPTED
from dynrt_tools.project import ROOT, Failed, Json, read_json
from dynrt_tools.report import variants as listed
from dynrt_tools.report.collect import check_writable, collect, scene_name, scene_path, write
from dynrt_tools.report.workflow import Workflow

MISTAKE = 2


class Parser(argparse.ArgumentParser):
    """Reports a mistake in the flags as dynrt does."""

    def error(self, message: str) -> NoReturn:
        print(f"dynrt: {message}; {self.prog} --help lists what there is", file=sys.stderr)
        sys.exit(MISTAKE)


def cores() -> int:
    return len(os.sched_getaffinity(0))


def add_program_arguments(parser: argparse.ArgumentParser) -> None:
    """The first flags of every report: those that the program gives, and the size."""
    parser.add_argument("--program", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--build", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--expect", required=True, help=argparse.SUPPRESS)
    parser.add_argument(
        "--size", default="512x384", metavar="WxH", help="pixels of the images (default: 512x384)"
    )


def add_job_arguments(parser: argparse.ArgumentParser, out: str) -> None:
    """The last flags of every report; `out` is the folder where none is named."""
    parser.add_argument(
        "--jobs",
        type=int,
        default=cores(),
        metavar="N",
        help="jobs at a time (default: the number of cores)",
    )
    parser.add_argument(
        "--slurm",
        action="store_true",
        help="run the jobs on the Slurm cluster that sbatch knows; the folder of "
        "the report, the build and the cache must be on disks that its nodes share",
    )
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        default=pathlib.Path(out),
        metavar="FOLDER",
        help=f"folder of the report (default: {out}); "
        "FOLDER.work beside it keeps all measurements, so that an interrupted "
        "report goes on and the next one measures only the changes",
    )


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The flags that a report and a choice have in common."""
    add_program_arguments(parser)
    parser.add_argument(
        "--config",
        default="thesis",
        metavar="NAME",
        help="configuration that the variants are variants of, or a FILE.json "
        "with one (default: thesis; for light and reflection rays: whitted)",
    )
    parser.add_argument(
        "--variants",
        type=pathlib.Path,
        default=listed.LISTED,
        metavar="FILE",
        help="variants by name, each an object of the keys that differ; default: "
        "those of scripts/dynrt_tools/report/variants.json",
    )
    parser.add_argument(
        "--variant",
        action="append",
        default=[],
        metavar="NAME",
        help="only this one, and that which the others differ from; can be given several times",
    )
    add_job_arguments(parser, "error_report")


def describe(program: pathlib.Path, scene: str, size: str) -> str:
    """A scene in a line; refuses one that dynrt does not read, or pictures of this size."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "info.json"
        result = subprocess.run(
            [program, "info", scene, "--size", size, "--json", path],
            capture_output=True,
            text=True,
            check=False,
        )
        if result.returncode != 0:
            raise Failed(result.stderr.strip().removeprefix("dynrt: "))
    line = next((x for x in result.stdout.splitlines() if x.startswith("scene ")), scene)
    return line.removeprefix("scene").strip()


def check_jobs(args: argparse.Namespace, work: str, parts: str) -> None:
    """Refuses flags that no job could be run with, or a build that lacks parts that `work` needs."""
    if args.jobs < 1:
        raise Failed(f"--jobs {args.jobs}: at least one is needed")
    build = read_json(args.build)
    require_whole(build, work, parts)
    if fingerprint.fingerprint(build) != args.expect:
        raise Failed("the sources have changed since this program was built; build it again")


def known_scenes(args: argparse.Namespace, scenes: list[str]) -> dict[str, Json]:
    """By the names that a report gives them: the path of each, and a line about it."""
    known: dict[str, Json] = {}
    for scene in scenes:
        path = scene_path(scene)
        if scene_name(scene) in known:
            raise Failed(
                f"{scene}: another scene of this report has the same name, "
                f"'{scene_name(scene)}'; make two reports"
            )
        known[scene_name(scene)] = {"path": path, "about": describe(args.program, path, args.size)}
    return known


def work_folder(out: pathlib.Path) -> pathlib.Path:
    """Where the jobs of a report keep their results."""
    return out.absolute().with_name(out.name + ".work")


def measured(
    args: argparse.Namespace, scenes: list[str], hardware: bool = True
) -> tuple[Json, dict[str, pathlib.Path]]:
    """Runs the jobs that have no result yet, and gives the result of collect()."""
    base = listed.base_configuration(args.config)
    # The lists of the project are for every core; of a user's list each variant is meant.
    own = args.variants.resolve().is_relative_to(ROOT / "scripts")
    variants = listed.chosen(listed.read_variants(args.variants, base, own), args.variant)
    check_jobs(args, "measuring variants", "hlsc, CGAL and Embree")
    known = known_scenes(args, scenes)
    check_writable(args.out)
    folder = work_folder(args.out)
    workflow = Workflow(folder, args.program.resolve(), args.build.resolve(), args.expect)
    with workflow.alone():
        workflow.prepare(
            {name: scene["path"] for name, scene in known.items()}, variants, args.size, hardware
        )
        workflow.run(args.jobs, args.slurm)
        return collect(folder, known, variants, args.size)


def run(args: argparse.Namespace) -> None:
    report, pictures = measured(args, args.scene or ["office"], args.hardware)
    refused = [r for r in report["runs"] if "refused" in r]
    if len(refused) == len(report["runs"]):
        raise Failed("no variant can render any of the scenes; " + refused[0]["refused"])
    write(args.out, report, pictures)
    for one in refused:
        print(f"{one['variant']}: not with {one['scene']}: {one['refused']}")
    print(
        f"{len(report['runs']) - len(refused)} frames of {len(report['variants'])} variants and "
        f"{len(report['scenes'])} scenes: {args.out}/error.html, error.csv and error.json"
    )


def guarded(act: Callable[[argparse.Namespace], int | None], args: argparse.Namespace) -> int:
    """The exit code of a command, whose mistakes are one sentence each."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return act(args) or 0
    except Failed as error:
        print(f"dynrt: {error}", file=sys.stderr)
    except OSError as error:
        print(f"dynrt: {error.filename or args.out}: {error.strerror}", file=sys.stderr)
    except KeyboardInterrupt:
        print("\ndynrt: interrupted; the same command goes on from here", file=sys.stderr)
        return INTERRUPTED
    return MISTAKE


def main() -> int:
    parser = Parser(
        prog="dynrt report error",
        description=__doc__,
        epilog="scripts/dynrt_tools/report/README.md describes the report.",
    )
    parser.add_argument(
        "scene", nargs="*", metavar="SCENE", help="built-in scenes or files (default: office)"
    )
    add_arguments(parser)
    parser.add_argument(
        "--no-hardware",
        dest="hardware",
        action="store_false",
        help="lower and synthesize nothing: neither clocks nor area, in a third of the time",
    )
    return guarded(run, parser.parse_args())
