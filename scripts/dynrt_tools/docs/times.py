# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The data of the page of build times, from the tables that scripts/demo and scripts/test print."""

import pathlib
import re
from typing import Any

from dynrt_tools import project

DATA = project.ROOT / "docs" / "results" / "data" / "build.json"
RUNS = {
    "demo": "scripts/demo on a bare machine",
    "fast": "scripts/test --fast after it",
    "all": "scripts/test after that",
}
HEADING = "== seconds"
PART = re.compile(r"^(\w[\w ]*?) +(\d+\.\d) s$")
KIND = re.compile(r"^  (\w+) +(\d+\.\d) s in (\d+) steps, the longest (\d+\.\d) s$")
BUILDING = ("packages", "configure", "build")


def read(log: pathlib.Path) -> dict[str, Any]:
    """The last table of a log: seconds of each part, and of the build's steps by their kind."""
    try:
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError as error:
        raise project.Failed(f"{log}: {error.strerror}; name what the run printed") from error
    if HEADING not in lines:
        raise project.Failed(
            f"{log}:1: has no line '{HEADING}'; name what scripts/demo or scripts/test printed"
        )
    start = len(lines) - lines[::-1].index(HEADING)
    run: dict[str, Any] = {"steps": {}}
    for line in lines[start:]:
        if part := PART.match(line):
            run[part[1]] = float(part[2])
        elif kind := KIND.match(line):
            run["steps"][kind[1]] = {
                "seconds": float(kind[2]),
                "number": int(kind[3]),
                "longest": float(kind[4]),
            }
        else:
            break
    if "in all" not in run:
        raise project.Failed(
            f"{log}:{start}: the table has no line 'in all'; the run did not reach its end"
        )
    return run


def minutes(runs: dict[str, Any]) -> dict[str, float | None]:
    """How long each thing takes that somebody waits for; None where a run is not measured."""
    demo, fast, every = (runs.get(name) for name in RUNS)
    picture = demo["in all"] / 60 if demo else None
    built = None
    if picture is not None and fast:
        built = picture + sum(fast.get(part, 0.0) for part in BUILDING) / 60
    return {
        "first picture": picture,
        "everything built": built,
        "fast tests": after(built, fast),
        "all tests": after(built, every),
    }


def after(built: float | None, tested: dict[str, Any] | None) -> float | None:
    """The minutes until the tests of a run are done, from nothing."""
    seconds = tested.get("test") if tested else None
    return None if built is None or seconds is None else built + seconds / 60


def keep(name: str, log: pathlib.Path, data: pathlib.Path = DATA) -> None:
    """Puts the times of a run into the data."""
    if name not in RUNS:
        raise project.Failed(f"--times {name}: unknown; the runs are {', '.join(RUNS)}")
    kept = project.read_json(data)
    kept["runs"][name] = read(log)
    kept["minutes"] = minutes(kept["runs"])
    project.write_json(data, kept)
