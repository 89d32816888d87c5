# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The flags of experiments."""

import argparse
import os
import pathlib
import sys
from collections.abc import Sequence
from typing import NoReturn

from dynrt_tools.experiments import figures, rows, table
from dynrt_tools.project import Json

MISTAKE = 2  # the exit code
EXITS = (
    "Exit codes: 0 success; 1 something is missing, and the page says what; 2 a mistake in the input "
    "or the flags. scripts/dynrt_tools/experiments/README.md describes the experiments and their files."
)


class Parser(argparse.ArgumentParser):
    """Reports a mistake in the flags as dynrt does."""

    def error(self, message: str) -> NoReturn:
        print(f"dynrt: {message}; {self.prog} --help lists what there is", file=sys.stderr)
        sys.exit(MISTAKE)


def cores() -> int:
    return len(os.sched_getaffinity(0))


def add_arguments(parser: argparse.ArgumentParser, size: str, out: str) -> None:
    """The flags of every experiment; `out` is the folder where none is named."""
    for flag, kind in (("--program", pathlib.Path), ("--build", pathlib.Path), ("--expect", str)):
        parser.add_argument(flag, type=kind, required=True, help=argparse.SUPPRESS)
    parser.add_argument(
        "--size", default=size, metavar="WxH", help=f"pixels of the images (default: {size})"
    )
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
        help="run the jobs on the Slurm cluster that sbatch knows; the folder of the report, the "
        "build and the cache must be on disks that its nodes share",
    )
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        default=pathlib.Path(out),
        metavar="FOLDER",
        help=f"folder of the report (default: {out}); FOLDER.work beside it keeps all measurements, so "
        "that an interrupted report goes on and the next one measures only the changes",
    )


def add_error_arguments(parser: argparse.ArgumentParser) -> None:
    """The flags that the error report and a choice have in common."""
    listed = table.FOLDER / "error.json"
    parser.add_argument(
        "--config",
        default="thesis",
        metavar="NAME",
        help="configuration that the variants are variants of, or a FILE.json with one (default: "
        "thesis; for light and reflection rays: whitted)",
    )
    parser.add_argument(
        "--variants",
        type=pathlib.Path,
        default=listed,
        metavar="FILE",
        help="variants by name, each an object of the keys that differ; default: those of "
        "scripts/dynrt_tools/experiments/table/error.json",
    )
    add_variant(parser, ", and that which the others differ from")
    add_arguments(parser, table.experiment("error")["size"], "error_report")


def add_variant(parser: argparse.ArgumentParser, more: str = "") -> None:
    parser.add_argument(
        "--variant",
        action="append",
        default=[],
        metavar="NAME",
        help=f"only this variant{more}; can be given several times",
    )


def add_hardware_arguments(parser: argparse.ArgumentParser, stated: Json) -> None:
    parser.add_argument(
        "--config",
        action="append",
        default=[],
        metavar="NAME",
        help="configuration that has curves, or a FILE.json with one; can be given several times "
        f"(default: {' '.join(stated['curves'])})",
    )
    parser.add_argument(
        "--table",
        action="append",
        default=[],
        metavar="NAME",
        help="configuration that stands in the table with all its packets and lines, beside those "
        f"that have curves; can be given several times (default: {' '.join(stated['table'])})",
    )
    parser.add_argument(
        "--figure",
        action="append",
        default=[],
        metavar="NUMBER",
        help="only this figure of the thesis, or what the indices say of this project's additions; can "
        f"be given several times (default: {' '.join(figures.numbers())})",
    )
    parser.add_argument(
        "--frames",
        type=int,
        default=stated["frames"],
        metavar="N",
        help="frames of each scene's walk over which every figure is the mean, as dynrt walk spreads "
        f"them (default: {stated['frames']})",
    )
    add_arguments(parser, stated["size"], "hardware_report")


def parse(name: str, words: Sequence[str]) -> argparse.Namespace:
    stated = table.experiment(name)
    parser = Parser(prog=f"dynrt report {name}", description=stated["about"], epilog=EXITS)
    scenes = scenes_of(name, stated)
    parser.add_argument(
        "scene",
        nargs="*",
        metavar="SCENE",
        help=f"built-in scenes or files (default: {' '.join(scenes)})",
    )
    if name == "error":
        add_error_arguments(parser)
        parser.add_argument(
            "--no-hardware",
            dest="hardware",
            action="store_false",
            help="lower and synthesize nothing: neither clocks nor area, in a third of the time",
        )
    elif name == "hardware":
        add_hardware_arguments(parser, stated)
    else:
        add_variant(parser)
        add_arguments(parser, stated["size"], f"{name}_report")
    parser.add_argument(
        "--json",
        type=pathlib.Path,
        metavar="FILE",
        help="write the data as the documents keep them",
    )
    parser.add_argument(
        "--drawings", type=pathlib.Path, metavar="FOLDER", help="draw the plots there as SVG"
    )
    args = parser.parse_args(words)
    args.scene = args.scene or scenes
    return args


def scenes_of(name: str, stated: Json) -> list[str]:
    if name in ("error", "hardware"):
        return list(stated["scenes"])
    return rows.scenes_of(stated, table.of_experiment(name))
