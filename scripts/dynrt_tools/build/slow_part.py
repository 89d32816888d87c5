# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs a part of the tests labelled slow, another one for each commit, while there is time.

The tests in the order of their names are dealt to N parts like cards, so that tests of one kind fall
into different parts. The commit's number modulo N chooses the part. Where time ends before a part
does, each round of N commits begins with another of its tests."""

import argparse
import dataclasses
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import time
from collections.abc import Callable, Sequence

from dynrt_tools import project


CTEST_SECONDS = 1500  # after which ctest stops a test that states no time of its own


@dataclasses.dataclass(frozen=True)
class Part:
    """One of several parts, and how often all parts came before."""

    number: int
    of: int
    round: int = 0

    def take(self, names: Sequence[str]) -> list[str]:
        """Its tests, in the order in which they start."""
        dealt = sorted(set(names))[self.number :: self.of]
        first = self.round % len(dealt) if dealt else 0
        return dealt[first:] + dealt[:first]


def commit_number(root: pathlib.Path) -> int:
    """The commits up to HEAD; in a shallow clone, which lacks some, a number from its hash."""

    def git(*words: str) -> str:
        done = subprocess.run(
            ["git", *words], cwd=root, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise project.Failed(
                f"git {' '.join(words)} in {root}: {done.stderr.strip()}; name the part yourself, "
                "such as --slow-part 3/10"
            )
        return done.stdout.strip()

    if git("rev-parse", "--is-shallow-repository") == "true":
        return int(git("rev-parse", "HEAD")[:8], 16)
    return int(git("rev-list", "--count", "HEAD"))


def chosen(text: str, number: Callable[[], int]) -> Part:
    """The part that K/N names, or of N parts that of a number."""
    *given, of = (int(word) for word in text.split("/"))
    if given:
        return Part(given[0], of)
    chosen_by = number()
    return Part(chosen_by % of, of, chosen_by // of)


def slow_tests(build: pathlib.Path) -> dict[str, float]:
    """The tests labelled slow, each with the seconds after which ctest stops it."""
    done = subprocess.run(
        ["ctest", "--test-dir", str(build), "--show-only=json-v1", "-L", "^slow$"],
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    found = {}
    for test in json.loads(done.stdout)["tests"]:
        stated = {p["name"]: p["value"] for p in test.get("properties", [])}
        found[test["name"]] = float(stated.get("TIMEOUT", CTEST_SECONDS))
    return found


def run_tests(build: pathlib.Path, names: Sequence[str]) -> bool:
    """Whether these tests pass, side by side."""
    pattern = "|".join(re.escape(name) for name in names)
    command = ["ctest", "--test-dir", str(build), "--output-on-failure", "--no-tests=error"]
    command += ["--parallel", str(len(names)), "-R", f"^({pattern})$"]
    return subprocess.run(command, check=False).returncode == 0


def run_part(
    names: Sequence[str],
    at_once: int,
    has_time: Callable[[Sequence[str]], bool],
    run: Callable[[Sequence[str]], bool],
) -> tuple[bool, list[str]]:
    """Runs the tests in their order, so many at once, while there is time for them. Gives whether all
    of them passed, and the tests that did not start."""
    passed = True
    left = list(names)
    while left and has_time(left[:at_once]):
        passed = run(left[:at_once]) and passed
        left = left[at_once:]
    return passed, left


def main() -> int:
    """What scripts/test --slow-part runs."""
    parser = argparse.ArgumentParser(prog="scripts/test", description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--slow-part", required=True, metavar="K/N")
    parser.add_argument("--seconds", type=float, required=True, help="how long tests may run")
    args = parser.parse_args()
    end: float = time.monotonic() + args.seconds
    try:
        part = chosen(args.slow_part, lambda: commit_number(project.ROOT))
    except project.Failed as failed:
        sys.exit(f"test: {failed}")
    limits = slow_tests(args.build)
    names = part.take(list(limits))
    print(
        f"== slow tests, part {part.number} of {part.of}: {' '.join(names) or 'none'}", flush=True
    )
    passed, left = run_part(
        names,
        os.cpu_count() or 1,
        lambda some: time.monotonic() + max(limits[name] for name in some) < end,
        functools.partial(run_tests, args.build),
    )
    if left:
        print(f"== no time was left for the slow tests {' '.join(left)}")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
