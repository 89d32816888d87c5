# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The thesis's quality indices of a core (7.2.1, 7.2.2) from its gates and from frames, and what a
report says with them; table/hardware.json states how this project reads them."""

import argparse
import json
import operator
import pathlib
import sys
from collections import Counter
from collections.abc import Sequence

from dynrt_tools import project
from dynrt_tools.command import Pool
from dynrt_tools.experiments import figures
from dynrt_tools.experiments.figures import SCANLINE, WITHOUT_HITS, Point
from dynrt_tools.experiments.frame import RATE
from dynrt_tools.hardware import gate_count, gate_report, gate_rule, gate_units, rtl_files
from dynrt_tools.hardware.gate_report import CoreCounts
from dynrt_tools.project import Json

FEWER = 8  # a core with this part of the packets, or of the lines, tells what each of them costs
MANY = 4  # pipelines that the thesis's text has at the most
INDICES = ("QHW", "QGHW")
CACHES = ("node", "list", "matrix")
QUARTER = "lost at a quarter of the bandwidth"
HALF = "2 pipelines, by twice one at half the bandwidth"
SPEED_UPS = {number: f"speed-up of {number} pipelines" for number in (2, MANY)}
FINDINGS = (
    *(column for index in INDICES for column in (f"best {index}", f"{index} at packets")),
    *(f"{cache} cache hits gained" for cache in CACHES),
    QUARTER,
    *SPEED_UPS.values(),
    HALF,
    *(f"{index} of {MANY} pipelines" for index in INDICES),
)
GAINS = (
    "frame rate gained",
    "gates added",
    *(f"{index} {which}" for index in INDICES for which in ("without", "with")),
)


# ---- Gates ----


def gates_of(counts: CoreCounts) -> Json:
    """Of a core: the gates of its logic and of its memories, as C_RTC has them, and the logic of
    each unit that has floating-point operators, the sum over pipelines."""
    whole, bits = gate_report.all_gates(counts)
    memory = gate_rule.MEMORY_BIT * bits
    arithmetic: Counter[str] = Counter()
    for instance, count in counts.items():
        name = gate_units.plain_name(instance)
        if name.startswith(gate_units.ARITHMETIC):
            arithmetic[name] += count.logic
    return {"logic": whole - memory, "memory": memory, "arithmetic": dict(arithmetic)}


def smaller(configuration: Json) -> list[Json]:
    """The cores whose gates tell, beside its own, what packets and lines of a configuration
    cost."""
    fewest = configuration.get("ways", 1)
    return [
        {**configuration, key: max(fewest, configuration[key] // FEWER)}
        for key in ("packets", "lines")
    ]


def is_counted(keys: Point) -> bool:
    """Whether an index is shown of the core that differs in these keys from a configuration: over
    the bandwidth, and over more pipelines, the figures have frame rates alone."""
    bandwidth = figures.KEYS.keys() - {"pipelines"}
    return not bandwidth & keys.keys() and int(keys.get("pipelines", 1)) <= MANY


def split(counted: Sequence[tuple[Json, Json]]) -> Json | None:
    """C_AU and C_IM as a fixed part, one per packet and one per line, from cores and their gates;
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


def of_core(keys: Json, counted: Json | None, parts: Json | None = None) -> Json | None:
    """The gates of a core, and what they are of."""
    if counted is None:
        return None
    stated = {key: keys[key] for key in ("packets", "lines")}
    return {**stated, "pipelines": keys.get("pipelines", 1), **counted, "split": parts}


def costs(gates: Json, packets: int, lines: int) -> tuple[float, float] | None:
    """C_AU and C_IM with these packets and lines; None if the cores that were counted do not
    tell."""
    if (packets, lines) == (gates["packets"], gates["lines"]):
        return gates["logic"], gates["memory"]
    if not (parts := gates["split"]):
        return None
    logic, memory = (
        parts["fixed"][cost] + parts["packet"][cost] * packets + parts["line"][cost] * lines
        for cost in ("logic", "memory")
    )
    return logic, memory


def indices(gates: Json, frame: Json) -> Json:
    """QHW and QGHW of a frame; empty where the gates are not known."""
    cost = costs(gates, frame["packets"], frame["cache_lines"])
    if cost is None:
        return {}
    units, arithmetic, whole = frame["units"], gates["arithmetic"], sum(cost)
    working = sum(n * float(units[name]["utilisation"]) for name, n in arithmetic.items())
    use = working / sum(arithmetic.values())
    rays = frame["width"] * frame["height"] / frame["cycles"]
    own = gate_units.gates(frame["packets"], frame["cache_lines"])
    return {
        "C_AU + C_IM": whole,
        "thesis's C_RTC": gates["pipelines"] * own,
        "QGHW": 1e6 * rays / whole,
        "U_AU": 100 * use,
        "QHW": 100 * use * cost[0] / whole,
    }


# ---- What the runs of a report say ----


def findings(report: Json) -> list[Json]:
    """A row for each scene and configuration that has curves: where the indices are best, what the
    Morton curve gains over scanlines, what a slower memory costs and several pipelines bring. What
    is missing is None."""
    return [
        {"scene": scene, "configuration": name, **found_of(report["runs"], scene, name, one)}
        for scene in report["scenes"]
        for name, one in report["configurations"].items()
        if one["curves"]
    ]


def slower(configuration: Json, times: int) -> Point:
    """The key of the core whose memory has this part of the bandwidth."""
    if figures.is_behind_port(configuration):
        return {"port_bytes": figures.own_value(configuration, "port_bytes") // times}
    return {"memory_clocks": times * figures.own_value(configuration, "memory_clocks")}


def found_of(runs: Sequence[Json], scene: str, name: str, configuration: Json) -> Json:
    mine = [r for r in runs if (r["scene"], r["configuration"]) == (scene, name)]
    own = figures.own_point(configuration)

    def at(change: Point) -> Json | None:
        return next((r for r in mine if r["flags"] == {**own, **change}), None)

    found: Json = dict.fromkeys(FINDINGS)
    # The thesis's figures over packets are with all lines.
    along = [r for r in mine if r["flags"] == {**own, "packets": r["flags"].get("packets")}]
    for index in INDICES:
        known = [r for r in along if r.get(index) is not None]
        if len(known) > 1:
            best = max(known, key=operator.itemgetter(index))
            found |= {f"best {index}": best[index], f"{index} at packets": best["flags"]["packets"]}
    if (morton := at({})) and (scanline := at(SCANLINE)):
        for key in (f"{cache} cache hits" for cache in CACHES):
            found[f"{key} gained"] = morton[key] - scanline[key]
    if not (one := at(WITHOUT_HITS)):
        return found
    if quarter := at({**WITHOUT_HITS, **slower(configuration, 4)}):
        found[QUARTER] = 100 * (1 - quarter[RATE] / one[RATE])
    two, half = (
        at({**WITHOUT_HITS, **change}) for change in ({"pipelines": 2}, slower(configuration, 2))
    )
    if two and half:
        found[HALF] = two[RATE] / (2 * half[RATE])
    for number, column in SPEED_UPS.items():
        if several := at({**WITHOUT_HITS, "pipelines": number}):
            found[column] = several[RATE] / one[RATE]
            for index in INDICES if number == MANY else ():
                found[f"{index} of {MANY} pipelines"] = several.get(index)
    return found


def additions(report: Json) -> list[Json]:
    """A row for each scene and addition of this project whose configuration has curves: the indices
    of a core without it and with it. What is missing is None."""
    if figures.ADDED not in report["figures"]:
        return []
    known = {name: one for name, one in report["configurations"].items() if one["curves"]}
    return [
        {"scene": scene, "addition": one["name"], "configuration": one["configuration"]}
        | gain_of(report["runs"], scene, one, known[one["configuration"]])
        for scene in report["scenes"]
        for one in figures.ADDITIONS
        if one["configuration"] in known
    ]


def gain_of(runs: Sequence[Json], scene: str, addition: Json, configuration: Json) -> Json:
    place = (scene, addition["configuration"])
    mine = [run for run in runs if (run["scene"], run["configuration"]) == place]

    def at(point: Point) -> Json:
        return next((run for run in mine if run["flags"] == point), {})

    before, after = map(at, figures.added_points(addition, configuration))

    def more(figure: str) -> float | None:
        old, new = before.get(figure), after.get(figure)
        return None if old is None or new is None else 100 * (new / old - 1)

    found = dict(zip(GAINS, (more(RATE), more("C_AU + C_IM"))))
    for index in INDICES:
        found |= {f"{index} without": before.get(index), f"{index} with": after.get(index)}
    return found


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="scripts/variant_gates",
        description="Counts the gates of a core's Verilog by the thesis's rule: logic, memory, and "
        "those of each arithmetic unit.",
    )
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER", help="of the Verilog")
    parser.add_argument("output", type=pathlib.Path, metavar="FILE.json", help="of the figures")
    args = parser.parse_args()
    try:
        with Pool(1) as pool:
            counts = gate_count.count_core(rtl_files.units_in(args.folder), pool)
    except project.Failed as error:
        sys.exit(str(error))
    args.output.write_text(json.dumps(gates_of(counts), indent=1), encoding="utf-8")
