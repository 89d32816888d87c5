# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Counts the gates of a core's Verilog by the thesis's rule: logic, memory, and those of each
arithmetic unit."""

import argparse
import json
import pathlib
import sys
from collections import Counter
from collections.abc import Sequence

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.hardware import gate_count, gate_report, gate_rule, gate_units, rtl_files
from dynrt_tools.hardware.gate_report import CoreCounts
from dynrt_tools.hardware_report import findings
from dynrt_tools.hardware_report.figure import KEYS, Point
from dynrt_tools.project import Json

FEWER = 8  # a core with this part of the packets, or of the lines, tells what each of them costs


def figures(counts: CoreCounts) -> Json:
    """Of a core: the gates of its logic and of its memories, as C_RTC has them, and the logic of each
    unit that has floating-point operators, the sum over pipelines."""
    whole, bits = gate_report.all_gates(counts)
    memory = gate_rule.MEMORY_BIT * bits
    arithmetic: Counter[str] = Counter()
    for instance, count in counts.items():
        name = gate_units.plain_name(instance)
        if name.startswith(gate_units.ARITHMETIC):
            arithmetic[name] += count.logic
    return {"logic": whole - memory, "memory": memory, "arithmetic": dict(arithmetic)}


def cores(name: str, configuration: Json, curves: bool) -> dict[str, Json]:
    """The cores whose gates tell those of a configuration; of one that has curves also smaller ones."""
    found = {name: configuration}
    for key in ("packets", "lines") if curves else ():
        fewer = max(configuration.get("ways", 1), configuration[key] // FEWER)
        found[f"{name}-{key}{fewer}"] = {**configuration, key: fewer}
    return found


def is_counted(keys: Point) -> bool:
    """Whether an index is shown of the core that differs in these keys from a configuration: over the
    bandwidth, and over more pipelines, the figures have frame rates alone."""
    bandwidth = KEYS.keys() - {"pipelines"}
    return not bandwidth & keys.keys() and int(keys.get("pipelines", 1)) <= findings.MANY


def split(counted: Sequence[tuple[Json, Json]]) -> Json | None:
    """C_AU and C_IM as a fixed part, one per packet and one per line, from cores and their figures;
    None if the cores do not tell them."""
    points = [(core["packets"], core["lines"]) for core, _ in counted]
    if len(set(points)) < 3:
        return None
    parts = {
        cost: gate_rule.fit(points, [found[cost] for _, found in counted])
        for cost in ("logic", "memory")
    }
    return {
        part: {cost: values[i] for cost, values in parts.items()}
        for i, part in enumerate(("fixed", "packet", "line"))
    }


def of_core(keys: Json, counted: Json, parts: Json | None) -> Json:
    """What indices.py needs of a core: its figures, and what they are of."""
    stated = {key: keys[key] for key in ("packets", "lines")}
    return {**stated, "pipelines": keys.get("pipelines", 1), **counted, "split": parts}


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/variant_gates", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER", help="of the Verilog")
    parser.add_argument("output", type=pathlib.Path, metavar="FILE.json", help="of the figures")
    args = parser.parse_args()
    try:
        with Pool(1) as pool:
            counts = gate_count.count_core(rtl_files.units_in(args.folder), pool)
    except project.Failed as error:
        sys.exit(str(error))
    args.output.write_text(json.dumps(figures(counts), indent=1), encoding="utf-8")
