# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The flags of `dynrt specialise`, and which of them go on to the program."""

import argparse
import dataclasses
import json
import pathlib
import subprocess
from collections.abc import Iterable, Sequence

from dynrt_tools.hardware import devices
from dynrt_tools.experiments import choose
from dynrt_tools.experiments.flags import Parser, cores

OWN = ("--config", "--json")  # which `dynrt needs` has too, in another sense


@dataclasses.dataclass(frozen=True)
class Flag:
    """A flag of `dynrt needs` that `dynrt specialise` takes too (host/app/scene_flags.h)."""

    name: str
    value: str  # what stands for it in the help; empty if the flag has none
    several: bool
    of_frame: bool  # `dynrt render` has it too

    def add_to(self, parser: argparse._ActionsContainer) -> None:
        if not self.value:
            parser.add_argument(self.name, action="store_true")
            return
        action = "append" if self.several else "store"
        value = self.value.partition(" ")[0]  # without the default, which the program has
        parser.add_argument(self.name, action=action, metavar=value)

    def passed_on(self, args: argparse.Namespace) -> list[str]:
        """As the program takes what is given of it."""
        given = getattr(args, self.name.removeprefix("--").replace("-", "_"))
        if given is None or given is False:
            return []
        if given is True:
            return [self.name]
        return [f"{self.name}={one}" for one in (given if self.several else [given])]


def listed(program: str | None) -> list[Flag]:
    """The program knows its flags."""
    if program is None:
        return []
    text = subprocess.run(
        [program, "needs", "--list-flags"], stdout=subprocess.PIPE, text=True, check=True
    ).stdout
    flags = [Flag(**flag) for flag in json.loads(text)]
    return [flag for flag in flags if flag.name not in OWN]


def program_of(words: Sequence[str]) -> str | None:
    """The program that runs the script."""
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("--program")
    program: str | None = parser.parse_known_args(words)[0].program
    return program


def joined(words: Iterable[str], flags: Iterable[Flag]) -> list[str]:
    """The same words with every value behind its flag's =, as values may begin with a minus."""
    words, found = list(words), []
    with_value = {flag.name for flag in flags if flag.value}
    while words:
        word = words.pop(0)
        found.append(f"{word}={words.pop(0)}" if word in with_value and words else word)
    return found


def parse(words: Sequence[str]) -> argparse.Namespace:
    """The values of the flags; `flags` are those that are the program's too."""
    flags = listed(program_of(words))
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
        "with one (default: fast; for a scene with lights or mirrors whitted, for "
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
    for flag in flags:
        flag.add_to(scene)
    for name in ("--program", "--build", "--expect"):  # from the program
        parser.add_argument(name, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--for-program", action="store_true", help=argparse.SUPPRESS)
    args = parser.parse_args(joined(words, flags))
    args.flags = flags
    args.device = args.device or ["ecp5-85"]
    return args


def passed_on(args: argparse.Namespace, of_frame: bool) -> list[str]:
    """Those of the flags that are given and choose a frame, or those that choose the frames of a walk,
    as the program takes them."""
    return [
        word for flag in args.flags if flag.of_frame == of_frame for word in flag.passed_on(args)
    ]
