# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Lowers a configuration's units with the hlsc of a build, for a clock and a device's delays."""

import pathlib
import subprocess
from collections.abc import Sequence

from dynrt_tools import project, unit_names
from dynrt_tools.hardware import rtl_files, synthesis

Words = list[str | pathlib.Path]  # of a command
OPTIONS = ("room", "uncertainty")  # of hlsc, which a unit states or not
FIELDS = ("module", "header", "type", *OPTIONS)  # of a unit


def units(build: pathlib.Path, config: str = rtl_files.CHECKED_IN) -> dict[str, dict[str, str]]:
    """The FIELDS of the configuration's units, by module. An option that is not stated is missing or
    empty."""
    found = {}
    for line in (build / "hls/units/list_units.txt").read_text(encoding="utf-8").splitlines():
        name, *fields = line.split("|")
        if name == config:
            found[fields[0]] = dict(zip(FIELDS, fields))
    return found


def headers(units_: dict[str, dict[str, str]]) -> dict[str, str]:
    """The header's name of each unit, by module."""
    return {m: unit_names.header_name(unit["header"]) for m, unit in units_.items()}


def command(
    build: pathlib.Path,
    unit: dict[str, str],
    clock_ns: float,
    delay: pathlib.Path,
    config: str = rtl_files.CHECKED_IN,
) -> Words:
    """hlsc for a configuration's unit, without the files that it shall write."""
    root = project.ROOT
    folders = [root / "hls/lowered", root / "hls/include", root / "hls"]
    includes = [f"-I{path}" for path in [*folders, _includes(build)]]
    return [
        _hlsc(build),
        *("--unit", unit["type"], "--module", unit["module"]),
        *("--header", f"{config}/{unit['module']}.h"),
        *includes,
        *("--clock-ns", str(clock_ns), "--delay", delay),
        *(word for name in OPTIONS if unit.get(name) for word in (f"--{name}", unit[name])),
    ]


def _hlsc(build: pathlib.Path) -> pathlib.Path:
    return build / "hls" / "compiler" / "hlsc"


def _includes(build: pathlib.Path) -> pathlib.Path:
    return build / "generated" / "include"


def run(arguments: Sequence[str | pathlib.Path]) -> None:
    """Runs hlsc; throws project.Failed with what it says."""
    result = subprocess.run(arguments, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        lines = result.stderr.strip().splitlines()
        raise project.Failed(lines[-1] if lines else f"hlsc ended with {result.returncode}")


def lower(
    build: pathlib.Path,
    unit: dict[str, str],
    clock_ns: float,
    delay: str,
    config: str = rtl_files.CHECKED_IN,
) -> pathlib.Path:
    """The folder with the Verilog of a configuration's unit and hlsc's report for a delay model."""
    root, module = project.ROOT, unit["module"]
    sources = sorted(
        p
        for folder in ("hls/lowered", "hls/include", "hls/units")
        for p in (root / folder).rglob("*.h")
    )

    def make(folder: pathlib.Path) -> None:
        run(
            [
                *command(build, unit, clock_ns, root / delay, config),
                *("-o", folder / f"{module}.v"),
                *("--report", folder / f"{module}.txt"),
                *("--binding", folder / "ports.h"),
            ]
        )

    said = [
        unit,
        clock_ns,
        (root / delay).read_text(encoding="utf-8"),
        _hlsc(build).stat().st_mtime_ns,
        (_includes(build) / "configs" / f"{config}.h").read_text(encoding="utf-8"),
    ]
    return synthesis.kept("lowered", said, sources, make)
