# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Counts the cells that the hardware of a configuration takes, from the Verilog that hlsc made.

Yosys synthesizes each unit alone, and the figures count it as often as the core has it. The FIFOs
and RAMs that join the units are synthesized with the units as black boxes. Many units are equal in
several configurations; such a unit is synthesized once (synthesis.py).
"""

import argparse
import json
import pathlib
import re
import sys
import tempfile
from collections import Counter

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import devices, rtl_files, synthesis
from dynrt_tools.project import Json

FAMILY = "ecp5"
JOIN = rtl_files.CORE
HEAD = r"^module .*?^\);"  # of a module: its ports


def without_comments(verilog: str) -> str:
    """The text that decides the result; a comment that names another source line does not."""
    return re.sub(r"//[^\n]*", "", verilog)


def black_box(verilog: str) -> str:
    """A module's ports alone."""
    return (
        "(* blackbox *)\n"
        + project.searched(HEAD, without_comments(verilog), re.MULTILINE | re.DOTALL)[0]
        + "\nendmodule\n"
    )


def cells_of(top: str, texts: dict[str, str], family: str) -> dict[str, int]:
    """Cells by type of module `top`, made of sources by file name."""
    with tempfile.TemporaryDirectory() as folder:
        files = rtl_files.library()
        for name, text in texts.items():
            path = pathlib.Path(folder, name)
            path.write_text(text, encoding="utf-8")
            if name.endswith(".v"):
                files.append(path)
        return synthesis.cells(top, files, devices.FAMILIES[family]["synth"], top)[0]


def figures_of(family: str, cells: dict[str, int], count: int) -> Json:
    return {
        "instances": count,
        "area": devices.area(family, cells),
        "takes": devices.resources(family, cells),
    }


def total(units: dict[str, Json], key: str) -> Json:
    """Of all units together, each as often as the core has it."""
    sums: Json = {}
    for unit in units.values():
        for name, number in unit[key].items():
            sums[name] = sums.get(name, 0) + unit["instances"] * number
    return sums


def schedule(report: str) -> Json:
    """Stages and longest path out of hlsc's report of a unit."""
    stages = int(project.searched(r"^stages +(\d+)$", report)[1])
    paths = re.findall(r"^ +\d+ +\d* +([0-9.]+)  ", report, re.MULTILINE)
    return {"stages": stages, "longest_path_ns": max(map(float, paths))}


def period(report: str) -> float:
    """For which hlsc scheduled a unit, in ns, out of its report."""
    return float(project.searched(r"^clock +([0-9.]+) ns", report)[1])


def hardware(folder: pathlib.Path, family: str = FAMILY, jobs: int = 1) -> Json:
    """The figures of error.json about a variant's hardware, for the core in this folder."""
    parts = rtl_files.instances(folder / f"{JOIN}.v")
    instances = Counter(part.module for part in parts if part.module != rtl_files.COUNTERS)
    texts = {m: (folder / f"{m}.v").read_text(encoding="utf-8") for m in instances}
    join = {f"{m}.v": black_box(text) for m, text in texts.items()}
    for name in (f"{JOIN}.v", f"{JOIN}.vh"):
        join[name] = without_comments((folder / name).read_text(encoding="utf-8"))
    sources = {m: {f"{m}.v": without_comments(text)} for m, text in texts.items()} | {JOIN: join}
    with Pool(jobs) as pool:
        found = {m: pool.submit(cells_of, m, files, family) for m, files in sources.items()}
        cells = {m: one.result() for m, one in found.items()}
    units, periods = {}, []
    for module, count in instances.items():
        report = (folder / f"{module}.txt").read_text(encoding="utf-8")
        periods.append(period(report))
        units[module] = {**figures_of(family, cells[module], count), **schedule(report)}
    units[JOIN] = figures_of(family, cells[JOIN], 1)
    return {
        "area": total(units, "area"),
        "takes": total(units, "takes"),
        "units": units,
        "schedule": {
            "stages": sum(u.get("stages", 0) for u in units.values()),
            "clock_ns": max(periods),
        },
    }


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="scripts/variant_hardware",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER", help="of the Verilog")
    parser.add_argument("output", type=pathlib.Path, metavar="FILE.json", help="of the figures")
    args = parser.parse_args()
    try:
        figures = hardware(args.folder)
    except project.Failed as error:
        sys.exit(str(error))
    args.output.write_text(json.dumps(figures, indent=1), encoding="utf-8")
