# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Tries one unit after a change: its native test, its lowering, Verilator's lint of its Verilog and
its co-simulation. Builds only the targets that these need."""

from __future__ import annotations

import argparse
import dataclasses
import pathlib
import re
import subprocess
import sys
import time
from collections.abc import Callable, Sequence

from dynrt_tools import project, unit_names
from dynrt_tools.hardware import rtl_files, verilator

ROOT = project.ROOT


class Refused(Exception):
    """A mistake, in a sentence."""


class Failed(Exception):
    """The output of a step that failed."""


@dataclasses.dataclass(frozen=True)
class Module:
    """A Verilog module and its co-simulation, as verif/unit/CMakeLists.txt writes it down."""

    config: str
    name: str
    stem: str  # of the header that has its unit
    cosimulation: str  # the target

    @property
    def target(self) -> str:
        """The CMake target that lowers it."""
        prefix = "" if self.config == rtl_files.CHECKED_IN else f"{self.config}_"
        return f"{prefix}{self.name}_verilog"


def read_modules(build: pathlib.Path) -> list[Module]:
    """The modules that a build co-simulates."""
    path = build / "cosimulated_units.txt"
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise Refused(
            f"{build} is not configured with hlsc ({path.name} is missing); run "
            "scripts/test --build-only, or: cmake --preset release"
        ) from error
    return [Module(*line.split("|")) for line in lines if line]


def chosen(modules: Sequence[Module], unit: str, config: str | None) -> list[Module]:
    """The modules of one header in one configuration: the named one, else the first that has it."""
    named = [m for m in modules if unit in (m.name, m.stem)]
    if not named:
        raise Refused(unit_names.unknown(unit, {m.name: m.stem for m in reversed(modules)}))
    config = config or named[0].config
    stems = [m.stem for m in named if m.config == config]
    found = [m for m in modules if m.config == config and m.stem in stems]
    if not found:
        having = dict.fromkeys(m.config for m in named)
        raise Refused(
            f"configuration '{config}' has no co-simulation of unit '{unit}'; these have one: "
            f"{', '.join(having)}"
        )
    return found


def run(command: Sequence[str | pathlib.Path]) -> str:
    """The output of a command; raises Failed with it if the command fails."""
    result = subprocess.run(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )
    if result.returncode != 0:
        raise Failed(result.stdout)
    return result.stdout


class Trial:
    """The steps for one unit, in the order in which they are run."""

    def __init__(self, build: pathlib.Path, modules: Sequence[Module]):
        self.build, self.modules = build, modules
        self.config, self.stem = modules[0].config, modules[0].stem

    @property
    def native_test(self) -> str | None:
        """The target of the native test, which few units lack."""
        has_test = (ROOT / "hls" / "units" / f"{self.stem}_test.cpp").is_file()
        return f"native_{self.stem}" if has_test else None

    def steps(self) -> list[tuple[str, Callable[[], str]]]:
        """Name and work of each step; the work gives a note about its result."""
        steps: list[tuple[str, Callable[[], str]]] = [("build", self.build_all)]
        if self.native_test:
            steps.append(("native test", self.run_native_test))
        return [
            *steps,
            ("lowering", self.describe_lowering),
            ("lint", self.lint),
            ("co-simulation", self.run_cosimulation),
        ]

    def build_all(self) -> str:
        """All at once, so that compilers and hlsc work side by side."""
        targets = [m.target for m in self.modules] + [self.modules[0].cosimulation]
        if self.native_test:
            targets.append(self.native_test)
        output = run(["ninja", "-C", self.build, *targets])
        counts = re.findall(r"^\[(\d+)/\d+\]", output, re.MULTILINE)
        return f"{counts[-1] if counts else 0} steps"

    def run_native_test(self) -> str:
        """The test of the unit's C++ alone."""
        return tests_in(run([self.build / "hls" / "units" / str(self.native_test)]))

    def describe_lowering(self) -> str:
        """The Verilog is there; says whether it is the one that is checked in."""
        names = [f"{m.name}.v" for m in self.modules]
        checked_in = rtl_files.checked_in(self.config)
        stale = [name for name in names if checked_in and not self.is_same(checked_in / name)]
        text = ", ".join(names)
        if stale:
            text += (
                f"; {', '.join(stale)} under rtl/generated/{self.config} is another, "
                f"ninja -C {self.build} update-generated renews it"
            )
        return text

    def is_same(self, old: pathlib.Path) -> bool:
        """Whether a checked-in file is what the build has."""
        new = self.build / "generated" / self.config / old.name
        return old.is_file() and old.read_bytes() == new.read_bytes()

    def lint(self) -> str:
        """Verilator's warnings, all of them, with the project's waivers."""
        folder = self.build / "generated" / self.config
        for module in self.modules:
            output = run(
                [
                    "verilator",
                    *("--lint-only", "-Wall", "+define+HLS_ASSERT", "--top-module", module.name),
                    *sorted((ROOT / "rtl" / "lint").glob("*.vlt")),
                    *("-y", ROOT / "rtl" / "lib", folder / f"{module.name}.v"),
                ]
            )
            if warnings := verilator.remarks(output):
                raise Failed(warnings)
        return "no warning"

    def run_cosimulation(self) -> str:
        """The unit's Verilog against its C++, without the tests that run for minutes."""
        program = self.build / "verif" / "unit" / self.modules[0].cosimulation
        return tests_in(run([program, "--gtest_filter=-*.Slow*"]))


def tests_in(output: str) -> str:
    """How many tests a GoogleTest program says that have passed."""
    passed = re.search(r"\[  PASSED  \] (\d+) tests?", output)
    if not passed or passed[1] == "0":
        raise Failed(output + "\nno test was run")
    return f"{passed[1]} tests"


def try_unit(trial: Trial) -> bool:
    """Runs the steps and prints a line for each; stops at the first that fails."""
    began = time.monotonic()
    for name, work in trial.steps():
        start = time.monotonic()
        try:
            text, verdict = work(), "passed"
        except Failed as failed:
            print(failed, file=sys.stderr)
            text, verdict = "the reason is above", "FAILED"
        print(f"{verdict}  {name:<14}{time.monotonic() - start:6.1f} s  {text}", flush=True)
        if verdict == "FAILED":
            return False
    print(f"{trial.stem} of configuration {trial.config}: {time.monotonic() - began:.1f} s")
    return True


def main() -> int:
    """The command scripts/try."""
    parser = argparse.ArgumentParser(
        prog="scripts/try",
        description=__doc__,
        epilog="Exit code: 0 if every step passed, 1 if not. A wrong UNIT prints the list of units.",
    )
    parser.add_argument(
        "unit", metavar="UNIT", help="a module, such as list, or the name of its header"
    )
    parser.add_argument(
        "--config", metavar="NAME", help="configuration (default: the first that has the unit)"
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        metavar="FOLDER",
        default=ROOT / "build" / "release",
        help="a build folder that is configured (default: build/release)",
    )
    args = parser.parse_args()
    try:
        modules = chosen(read_modules(args.build), args.unit, args.config)
        return 0 if try_unit(Trial(args.build.absolute(), modules)) else 1
    except Refused as refused:
        sys.exit(f"try: {refused}")
    except FileNotFoundError as error:
        sys.exit(f"try: {error.filename} is not installed; run scripts/setup")
