# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Prints how long the steps of a build took, from the log that Ninja keeps (.ninja_log)."""

from __future__ import annotations

import argparse
import dataclasses
import pathlib
import re
import sys

# The kind of a step, by the first pattern that one of its outputs matches.
KINDS = (
    ("compile", re.compile(r"\.(o|pch)$")),
    ("Verilate", re.compile(r"\.verilated/")),
    ("lower", re.compile(r"\.vh?$")),
    ("link", re.compile(r"\.(a|so)$|(^|/)[^/.]+$")),
)
OTHER = "other"


@dataclasses.dataclass(frozen=True)
class Step:
    """One command of a build."""

    seconds: float
    outputs: tuple[str, ...]

    @property
    def kind(self) -> str:
        """The kind of work that the command does."""
        for kind, pattern in KINDS:
            if any(pattern.search(output) for output in self.outputs):
                return kind
        return OTHER


class Refused(Exception):
    """A mistake, in a sentence."""


def read_lines(path: pathlib.Path) -> list[str]:
    """The entries of a log."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise Refused(f"{path}: {error.strerror}; name the .ninja_log of a build") from error
    if not lines or not lines[0].startswith("# ninja log"):
        raise Refused(f"{path}:1: is no log of Ninja; name the .ninja_log of a build")
    return lines[1:]


def steps_of(path: pathlib.Path, before: frozenset[str] = frozenset()) -> list[Step]:
    """The steps of a log, the longest first, without the entries `before`. A command with several
    outputs has one entry for each, with the same times and the same hash."""
    outputs: dict[tuple[int, int, str], list[str]] = {}
    for number, line in enumerate(read_lines(path), 2):
        if line in before:
            continue
        fields = line.split("\t")
        try:
            start, end, _, output, command = fields
            outputs.setdefault((int(start), int(end), command), []).append(output)
        except ValueError as error:
            raise Refused(
                f"{path}:{number}: is no entry of five fields that begins with two "
                "times; remove the log and build again"
            ) from error
    steps = [Step((end - start) / 1000, tuple(names)) for (start, end, _), names in outputs.items()]
    return sorted(steps, key=lambda step: -step.seconds)


def table_of_kinds(steps: list[Step]) -> str:
    """Of each kind the number of steps and their seconds, which is more than the clock showed where
    steps ran beside each other."""
    kinds: dict[str, list[float]] = {}
    for step in steps:
        kinds.setdefault(step.kind, []).append(step.seconds)
    rows = [
        f"  {kind:<10} {sum(seconds):9.1f} s in {len(seconds)} steps, the longest "
        f"{max(seconds):.1f} s"
        for kind, seconds in sorted(kinds.items(), key=lambda item: -sum(item[1]))
    ]
    return "\n".join(rows)


def table_of_longest(steps: list[Step], number: int) -> str:
    """The longest steps, one a line."""
    return "\n".join(
        f"{step.seconds:9.1f} s  {step.kind:<9} {step.outputs[0]}" for step in steps[:number]
    )


def main() -> int:
    """The command scripts/build_times."""
    parser = argparse.ArgumentParser(prog="scripts/build_times", description=__doc__)
    parser.add_argument(
        "log",
        nargs="?",
        type=pathlib.Path,
        metavar="LOG",
        default=pathlib.Path("build/release/.ninja_log"),
        help="the log (default: build/release/.ninja_log)",
    )
    parser.add_argument(
        "--longest",
        type=int,
        default=20,
        metavar="N",
        help="number of steps to list (default: 20)",
    )
    parser.add_argument(
        "--since",
        type=pathlib.Path,
        metavar="LOG",
        help="leave out the entries of this copy of the log, made before a build",
    )
    args = parser.parse_args()
    try:
        before = frozenset(read_lines(args.since)) if args.since else frozenset()
        steps = steps_of(args.log, before)
    except Refused as refused:
        sys.exit(f"build_times: {refused}")
    if args.longest > 0 and steps:
        print(table_of_longest(steps, args.longest))
    if steps:
        print(table_of_kinds(steps))
    return 0
