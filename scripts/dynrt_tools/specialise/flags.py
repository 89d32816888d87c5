# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The flags of `dynrt specialise`, and which of them go on to the program."""

import argparse
import pathlib
from collections.abc import Iterable

from dynrt_tools.hardware import devices
from dynrt_tools.report import choose
from dynrt_tools.report.report import Parser, cores

# Flags of the program that say which view is rendered, and those that only `dynrt needs` has.
SEEN = (
    "--size",
    "--position",
    "--look-at",
    "--up",
    "--fov",
    "--light",
    "--mirror",
    "--reflections",
)
ASKED = ("--frames", "--from", "--to")
SEVERAL = ("--light", "--mirror")


def joined(words: Iterable[str]) -> list[str]:
    """The same words with every value behind its flag's =, as values may begin with a minus."""
    words, found = list(words), []
    while words:
        word = words.pop(0)
        found.append(f"{word}={words.pop(0)}" if word in SEEN + ASKED and words else word)
    return found


def parse(words: Iterable[str]) -> argparse.Namespace:
    parser = Parser(
        prog="dynrt specialise",
        description="Makes the smallest core that renders a "
        "scene to the same bits as a general one: its Verilog lacks the parts that the scene "
        "does not need.",
        epilog="The folder receives configuration.json, every key with the reason for its "
        "value, which --config of the other commands takes; analysis.json, the figures "
        "behind the decisions and the savings; and verilog/. docs/how-to/specialise.md "
        "explains more.",
    )
    parser.add_argument("scene", metavar="SCENE", help="a built-in scene or a file")
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        metavar="DIR",
        help="folder to write to (default: SCENE.specialised)",
    )
    parser.add_argument(
        "--config",
        metavar="NAME",
        help="configuration to start from, or a FILE.json "
        "with one (default: thesis; for a scene with lights or mirrors whitted, for "
        "one of other primitives than triangles primitives)",
    )
    parser.add_argument(
        "--max-error",
        type=float,
        metavar="E",
        help="choose the bits of the float too: the cheapest that keep the error of "
        "the frame below this, as `dynrt choose` does; without it, the bits are "
        "those of the general core",
    )
    parser.add_argument(
        "--measure",
        metavar="KIND.NAME",
        help=f"the error that --max-error bounds (default: {choose.DEFAULT_MEASURE})",
    )
    parser.add_argument(
        "--max-slowdown",
        type=float,
        default=2,
        metavar="PERCENT",
        help="the most that fewer packets and fewer cache lines may slow a frame down, "
        "one half each (default: 2)",
    )
    parser.add_argument(
        "--keep",
        action="append",
        default=[],
        metavar="KEY",
        help="leave this key of the configuration as it is in the general one; can "
        "be given several times",
    )
    parser.add_argument(
        "--device",
        action="append",
        metavar="NAME",
        help="a device that the core must fit, one of "
        f"{', '.join(devices.DEVICES)}; if several are given, it must fit one of them "
        "(default: ecp5-85)",
    )
    parser.add_argument(
        "--no-hardware",
        dest="hardware",
        action="store_false",
        help="synthesize nothing: neither area nor gates, in a fraction of the time",
    )
    parser.add_argument(
        "--json", type=pathlib.Path, metavar="FILE", help="write the same figures as data"
    )
    parser.add_argument(
        "--jobs",
        type=int,
        default=cores(),
        metavar="N",
        help="compilers and synthesizers at a time (default: the number of cores)",
    )
    scene = parser.add_argument_group("the view, as in `dynrt render` and `dynrt walk`")
    for flag in SEEN + ASKED:
        scene.add_argument(flag, action="append" if flag in SEVERAL else "store", metavar="VALUE")
    scene.add_argument("--uncompressed", action="store_true")
    for flag in ("--program", "--build", "--expect"):  # from the program
        parser.add_argument(flag, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--for-program", action="store_true", help=argparse.SUPPRESS)
    args = parser.parse_args(joined(words))
    args.device = args.device or ["ecp5-85"]
    return args


def passed_on(args: argparse.Namespace, names: Iterable[str]) -> list[str]:
    """These flags as the program takes them."""
    words = []
    for name in names:
        value = getattr(args, name.removeprefix("--").replace("-", "_"))
        for one in value if isinstance(value, list) else [value] if value is not None else []:
            words.append(f"{name}={one}")
    return words
