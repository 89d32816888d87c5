# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Lowers a configuration's units with the hlsc of a build, for a clock and a device's delays."""

import pathlib
import subprocess

from dynrt_tools import project, unit_names
from dynrt_tools.hardware import rtl_files, synthesis


def find_build(named: pathlib.Path | None) -> pathlib.Path:
    folders = [named] if named else [project.ROOT / "build" / p for p in ("release", "dev")]
    for folder in folders:
        if (folder / "hls/compiler/hlsc").is_file() and (
            folder / "hls/units/list_units.txt"
        ).is_file():
            return folder
    raise project.Failed(
        f"no build with hlsc is in {' or '.join(map(str, folders))}; build the "
        "target hlsc, or name a build's folder with --build"
    )


def units(build: pathlib.Path, config: str = rtl_files.CHECKED_IN) -> dict[str, dict[str, str]]:
    """Module, header and type of the configuration's units, by module."""
    found = {}
    for line in (build / "hls/units/list_units.txt").read_text(encoding="utf-8").splitlines():
        name, module, header, kind = line.split("|")
        if name == config:
            found[module] = {"module": module, "header": header, "type": kind}
    return found


def headers(units_: dict[str, dict[str, str]]) -> dict[str, str]:
    """The header's name of each unit, by module."""
    return {m: unit_names.header_name(unit["header"]) for m, unit in units_.items()}


def lower(
    build: pathlib.Path,
    unit: dict[str, str],
    clock_ns: float,
    delay: str,
    config: str = rtl_files.CHECKED_IN,
) -> pathlib.Path:
    """The folder with the Verilog of a configuration's unit and hlsc's report for a delay model."""
    root, module = project.ROOT, unit["module"]
    include = build / "generated" / "include"
    hlsc = build / "hls" / "compiler" / "hlsc"
    header = f"{config}/{module}.h"
    sources = sorted(
        p
        for folder in ("hls/lowered", "hls/include", "hls/units")
        for p in (root / folder).rglob("*.h")
    )

    def make(folder: pathlib.Path) -> None:
        includes = [
            f
            for path in (root / "hls/lowered", root / "hls/include", root / "hls", include)
            for f in ("-I", str(path))
        ]
        result = subprocess.run(
            [
                hlsc,
                "--unit",
                unit["type"],
                "--module",
                module,
                "--header",
                header,
                *includes,
                "--clock-ns",
                str(clock_ns),
                "--delay",
                root / delay,
                "-o",
                folder / f"{module}.v",
                "--report",
                folder / f"{module}.txt",
                "--binding",
                folder / "ports.h",
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        if result.returncode != 0:
            raise project.Failed(result.stderr.strip().splitlines()[-1])

    said = [
        unit,
        clock_ns,
        (root / delay).read_text(encoding="utf-8"),
        hlsc.stat().st_mtime_ns,
        (include / "configs" / f"{config}.h").read_text(encoding="utf-8"),
    ]
    return synthesis.kept("lowered", said, sources, make)
