# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The tools that place and route: how each is called, and what its report says."""

import contextlib
import json
import pathlib
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypedDict

from dynrt_tools import project

CONSTRAINTS = project.ROOT / "constraints"
# A report states the clock that was asked for in whole picoseconds.
SAME_CLOCK = 0.005


class Placer(TypedDict):
    """The tool that places and routes for a device."""

    program: str
    cell: str  # the logic cell in its report
    where: str  # one gets the tool from
    flags: list[str]
    constraints: tuple[str, str]  # flag and file
    grades: tuple[str, ...]  # speed grades, the default first


# The wrapper has four pins, so any package will do.
PLACERS: dict[str, Placer] = {
    "ice40-hx8k": {
        "program": "nextpnr-ice40",
        "cell": "ICESTORM_LC",
        "where": "Debian's package nextpnr-ice40 has it, and scripts/setup installs that",
        "flags": ["--hx8k", "--package", "ct256"],
        "constraints": ("--pcf", "place_ice40.pcf"),
        "grades": (),
    },
    "ecp5-85": {
        "program": "nextpnr-ecp5",
        "cell": "TRELLIS_COMB",
        "where": "Debian 12 has no package of it, Debian 13 has; or build it from the nextpnr project",
        # By the timing weight, the first seed of one netlist of the core reached 108 MHz with 25, 127
        # with 60 and 121 with 100; the placer's own is 10.
        "flags": ["--85k", "--package", "CABGA381", "--placer-heap-timingweight", "60"],
        "constraints": ("--lpf", "place_ecp5.lpf"),
        "grades": ("6", "7", "8"),
    },
}


class PlacerFailed(project.Failed):
    """Why a placement has no result."""


class DoesNotFit(PlacerFailed):
    """The tool's word that the design is too large for the device."""


# What nextpnr says where cells are left over, in the order of its steps.
TOO_LARGE = (
    "no Bels remaining",
    "no BELs remaining",
    "Unable to place cell",
    "unable to find a placement location",
    "Unable to find legal placement",
)


@dataclass(frozen=True)
class Report:
    """What the tool says of a placement that is routed."""

    cells: int
    utilization: dict[str, int]
    mhz: float


def grade_of(device: str, asked: str) -> str:
    """The speed grade to place for: the one asked for, or the device's default."""
    grades = PLACERS[device]["grades"]
    if not asked:
        return grades[0] if grades else ""
    if asked not in grades:
        there = f"its grades are {', '.join(grades)}" if grades else "it has but one"
        raise project.Failed(f"--grade {asked}: {device} has no such speed grade; {there}")
    return asked


def flags(device: str, grade: str) -> list[str]:
    """All that says to the tool what the device is."""
    placer = PLACERS[device]
    option, constraints = placer["constraints"]
    return [
        *placer["flags"],
        *(["--speed", grade] if grade else []),
        option,
        str(CONSTRAINTS / constraints),
    ]


def constraints_text(device: str) -> str:
    """What the constraints state, without comments."""
    text = (CONSTRAINTS / PLACERS[device]["constraints"][1]).read_text(encoding="utf-8")
    stated = (line.partition("#")[0].strip() for line in text.splitlines())
    return "".join(f"{line}\n" for line in stated if line)


def run(command: list[str], program: str, timeout: float) -> None:
    """Places and routes; throws PlacerFailed with the sentence in which the tool said why."""
    try:
        result = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=timeout
        )
    except subprocess.TimeoutExpired as error:
        raise PlacerFailed(
            f"{program} ran out of time, {timeout:.0f} seconds; --timeout gives it more"
        ) from error
    except OSError as error:
        raise PlacerFailed(f"{program} cannot be started: {error.strerror}") from error
    if result.returncode == 0:
        return
    errors = [
        line.removeprefix("ERROR: ")
        for line in (result.stderr + result.stdout).splitlines()
        if line.startswith("ERROR")
    ]
    said = errors[-1] if errors else f"{program} ended with exit code {result.returncode}"
    raise (DoesNotFit if any(t in said for t in TOO_LARGE) else PlacerFailed)(said)


@contextlib.contextmanager
def reading(program: str) -> Iterator[None]:
    """Throws PlacerFailed where the program's report does not hold what is read within."""
    try:
        yield
    except FileNotFoundError as error:
        raise PlacerFailed(f"{program} wrote no report") from error
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise PlacerFailed(
            f"the report of this version of {program} reads otherwise than that of 0.4 to 0.11: "
            f"{unreadable(error)}"
        ) from error


def read_report(path: pathlib.Path, device: str, asked_mhz: float) -> Report:
    """Reads a report; throws PlacerFailed where it does not hold what is read here."""
    program, cell = PLACERS[device]["program"], PLACERS[device]["cell"]
    with reading(program):
        report: Any = json.loads(path.read_text(encoding="utf-8"))
        used = {name: int(counts["used"]) for name, counts in report["utilization"].items()}
        clocks = {
            name: (float(clock["achieved"]), float(clock["constraint"]))
            for name, clock in report["fmax"].items()
        }
        cells = used[cell]
    if not clocks:
        raise PlacerFailed(f"the report of {program} names no clock")
    for name, (_, constraint) in clocks.items():
        if abs(constraint / asked_mhz - 1) > SAME_CLOCK:
            raise PlacerFailed(
                f"{program} was asked for {asked_mhz:.2f} MHz and placed for {constraint:.2f} of "
                f"{name}; no FREQUENCY may stand in "
                f"constraints/{PLACERS[device]['constraints'][1]}"
            )
    return Report(cells, used, min(achieved for achieved, _ in clocks.values()))


def unreadable(error: Exception) -> str:
    return f"it has no {error}" if isinstance(error, KeyError) else str(error)
