# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Collects the results of a hardware report's jobs, as README.md says, and writes the report."""

import csv
import pathlib
from collections.abc import Iterator, Sequence

from dynrt_tools.bench.scenes import THESIS as THESIS_RATES
from dynrt_tools.build import configs
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.hardware_report import additions, findings, gates, indices, points, rows, walks
from dynrt_tools.hardware_report.figure import KEYS, MADE, Point
from dynrt_tools.project import Json, read_json, write_rows


class Results:
    """What the jobs have left in a folder. What was made of keys, Verilog or a model that are no
    longer there does not count: the job that would have renewed it failed."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder

    def _read(self, path: pathlib.Path, core: str) -> Json | None:
        made_of = (self.folder / "cores" / f"{core}.json", self.folder / "cores" / core / "verilog")
        there = all(one.exists() for one in (path, *made_of))
        return dict(read_json(path)) if there else None

    def gates(self, core: str) -> Json | None:
        return self._read(self.folder / "cores" / core / "gates.json", core)

    def keys(self, core: str) -> Json:
        """Of a core made for a scene."""
        return configs.read_file(self.folder / "cores" / f"{core}.json")

    def frame(self, walk: str, scene: str, configuration: str, point: Point) -> Json | None:
        """The mean of the frames of a walk."""
        folder = self.folder / "frames" / walk / scene / configuration
        core = points.core_of(configuration, point, scene)
        if not points.is_own(point) and not (self.folder / "models" / f"{core}.so").exists():
            return None
        found = self._read(folder / f"{points.name_of(point)}.json", core)
        return (
            None if found is None else walks.mean([f["figures"] for f in found["walk"]["frames"]])
        )


def gates_of(results: Results, name: str, one: Json) -> Json | None:
    """The gates of a configuration, split by packets and lines if it has curves."""
    cores = gates.cores(name, one["keys"], one["curves"])
    counted = [(core, results.gates(n)) for n, core in cores.items()]
    own = counted[0][1]
    if own is None:
        return None
    whole = [(core, figures_) for core, figures_ in counted if figures_ is not None]
    return gates.of_core(one["keys"], own, gates.split(whole))


def gates_at(results: Results, scene: str, name: str, one: Json, point: Point) -> Json | None:
    """The gates of the core that a point has in place of the configuration."""
    core = points.core_of(name, point, scene)
    if (own := results.gates(core)) is None:
        return None
    keys = results.keys(core) if MADE in point else points.core_at(one["keys"], point)
    return gates.of_core(keys, own, None)


def collect(
    folder: pathlib.Path,
    scenes: dict[str, Json],
    configurations: dict[str, Json],
    size: str,
    frames: int,
    drawn: Sequence[str],
) -> Json:
    """The content of hardware.json. `missing` says where frames are missing; why, the caller knows."""
    results = Results(folder)
    report: Json = {
        "size": size,
        "frames": frames,
        "figures": list(drawn),
        "reading": list(indices.READING),
        "scenes": {name: {"about": scene["about"]} for name, scene in scenes.items()},
        "configurations": {},
        "table": [],
        "findings": [],
        "additions": [],
        "runs": [],
        "missing": [],
    }
    for name, one in configurations.items():
        report["configurations"][name] = {
            "about": one["keys"]["about"],
            "packets": one["keys"]["packets"],
            "lines": one["keys"]["lines"],
            **{key: points.own_value(one["keys"], key) for key in KEYS},
            **{key: one["keys"][key] for key in ("memory", "ways")},
            "curves": one["curves"],
            "clock": placed_clocks.of(name).of_core(name),
            "gates": gates_of(results, name, one),
        }
    for scene in scenes:
        for name, one in configurations.items():
            counted = report["configurations"][name]["gates"]
            absent = 0
            for point in one["points"]:
                frame = results.frame(f"{size}/{frames}", scene, name, point)
                if frame is None:
                    absent += 1
                    continue
                own = points.is_own(point)
                of_core = counted if own else gates_at(results, scene, name, one, point)
                found = rows.figures_of(frame, of_core)
                report["runs"].append(rows.row(scene, name, point, found))
                if point == points.own_point(one["keys"]):
                    report["table"].append(table_row(scene, name, one["keys"], found))
            if absent:
                count = len(one["points"])
                report["missing"].append(f"{scene}, {name}: {absent} of {count} walks")
    report["findings"] = findings.of(report)
    report["additions"] = additions.of(report)
    return report


def table_row(scene: str, configuration: str, keys: Json, found: Json) -> Json:
    """The figures of a configuration with all its packets and lines."""
    low_high = THESIS_RATES.get(scene)
    known = {
        **found,
        "packets": keys["packets"],
        "lines": keys["lines"],
        rows.PLACED: placed_clocks.rate_text(found["clocks"], configuration, ".1f"),
        "thesis's frames per second": low_high and f"{low_high[0]} to {low_high[1]}",
    }
    return {
        "scene": scene,
        "configuration": configuration,
        **{column: known.get(column) for column in rows.TABLE},
    }


def flat(report: Json) -> Iterator[Json]:
    """The runs with their flags as columns."""
    for run in report["runs"]:
        flags = run["flags"]
        yield {**{k: run[k] for k in ("scene", "configuration")}, **flags} | {
            k: v for k, v in run.items() if k != "flags"
        }


def write_csv(path: pathlib.Path, report: Json) -> None:
    lines = list(flat(report))
    columns = list(dict.fromkeys(key for line in lines for key in line))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def write_json(path: pathlib.Path, report: Json) -> None:
    write_rows(path, report, "table", "findings", "additions", "runs")
