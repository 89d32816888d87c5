# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The hardware report: walks through scenes on configurations, and on cores that differ from them
in a key, and the gates of each core; the figures of the thesis's chapter 7.2 follow from both."""

import argparse
import pathlib
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from dynrt_tools.experiments import figures, frame, indices, page
from dynrt_tools.experiments.figures import MADE, TABLE, Point
from dynrt_tools.experiments.jobs import Core, File, Job, Maker, Word
from dynrt_tools.experiments.rows import PLACED, RATES, beside_the_thesis
from dynrt_tools.experiments.table import base_configuration
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Failed, Json

MOST_FRAMES = 100  # so that a job ends within the hour
COLUMNS = (
    "packets",
    "lines",
    "clocks",
    PLACED,
    frame.RATE,
    frame.SLOWEST,
    RATES,
    "rays per clock",
    "U_AU",
    "QHW",
    "QGHW",
    "bytes read per ray",
    "bytes written per ray",
    *(f"{cache} cache hits" for cache in indices.CACHES),
    "C_AU + C_IM",
    "thesis's C_RTC",
)


@dataclass(frozen=True)
class Measured:
    """A configuration of a report: with curves, or with its own walk alone."""

    keys: Json
    named: str  # as the program knows it; empty if it does not
    given: str  # as a command takes it
    curves: bool
    points: Sequence[Point]


def figures_of(named: Sequence[str]) -> list[Json]:
    """The figures with these numbers, or all."""
    known = figures.numbers()
    for number in named:
        if number not in known:
            raise Failed(f"--figure {number}: unknown; the figures are {', '.join(known)}")
    return [f for f in figures.FIGURES if not named or set(f["name"].split(" and ")) & set(named)]


def configurations_of(args: argparse.Namespace, drawn: Sequence[Json]) -> dict[str, Measured]:
    """The configurations by name, in the order of the table, with the points of the figures and, if
    they are compared, of the additions."""
    curves, rest = args.config or TABLE["curves"], args.table or TABLE["table"]
    compared = not args.figure or figures.ADDED in args.figure
    found: dict[str, Measured] = {}
    for given in dict.fromkeys([*rest, *curves]):
        path = pathlib.Path(given)
        is_file = path.suffix == ".json"
        name = re.sub(r"[^A-Za-z0-9_]", "_", path.stem) if is_file else given
        if name in found:
            raise Failed(
                f"--config {given}: another configuration of this report is named '{name}'"
            )
        keys = base_configuration(given)
        if not keys["counters"]:
            raise Failed(
                f"--config {given}: it counts nothing, so nobody can tell the use of its units; set "
                "counters to true"
            )
        others = figures.wanted(name, keys) if compared else []
        points = figures.points(keys, drawn, others) if given in curves else []
        whole = points or [figures.own_point(keys)]
        named = "" if is_file else given
        path_ = str(path.absolute()) if is_file else given
        found[name] = Measured(keys, named, path_, given in curves, whole)
    return found


class Experiment:
    """The jobs of a report, and what they have found."""

    def __init__(
        self,
        maker: Maker,
        scenes: Mapping[str, Word],
        configurations: Mapping[str, Measured],
        drawn: Sequence[str],
        size: str,
        frames: int,
    ) -> None:
        self.maker, self.configurations, self.drawn = maker, configurations, drawn
        self.size, self.frames = size, frames
        # By configuration those of the whole core and of smaller ones; of others by scene and point.
        self.own: dict[str, list[tuple[Json, Job]]] = {}
        self.others: dict[tuple[str, str, str], Job] = {}
        self.made: dict[tuple[str, str], Job] = {}
        self.walks: dict[tuple[str, str, str], Job] = {}
        for name, one in configurations.items():
            cores = [one.keys, *(indices.smaller(one.keys) if one.curves else ())]
            self.own[name] = [
                (core, maker.counted("gates", maker.verilog(name, core))) for core in cores
            ]
            for scene, word in scenes.items():
                for point in one.points:
                    self._add(scene, word, name, one, point)

    def _add(self, scene: str, word: Word, name: str, one: Measured, point: Point) -> None:
        place = (scene, name, figures.name_of(point))
        differs = figures.keys_of(point)
        maker, called = self.maker, f"{name}, {figures.name_of(point)}"
        core: Json | Job = figures.core_at(one.keys, point)
        seen = ("--size", self.size, "--frames", str(self.frames))
        if MADE in point:
            core = self.made[scene, name] = maker.made(word, f"{scene}, {name}", one.given, seen)
        own = not differs and MADE not in point
        verilog = maker.verilog(name if own else called, core)
        if not own and indices.is_counted(differs):
            self.others[place] = maker.counted("gates", verilog)
        model = None if own and one.named else maker.model(name if own else called, core)
        words: tuple[Word, ...] = (File(maker.program), "walk", word, "--board", "model", *seen)
        words += ("--again", "--out", "{scratch}/frames")
        of = Core(one.named, model, verilog)
        self.walks[place] = maker.frame(f"{scene}, {called}", words, of, figures.flags_of(point))

    @property
    def goals(self) -> list[Job]:
        own = [job for cores in self.own.values() for _, job in cores]
        return [*own, *self.others.values(), *self.walks.values()]

    def _gates(self, flow: Workflow, place: tuple[str, str, str], point: Point) -> Json | None:
        """The gates of the core that a point has in place of the configuration."""
        counted = flow.result(self.others.get(place))
        keys = figures.core_at(self.configurations[place[1]].keys, point)
        if MADE in point and counted:
            path = flow.kept(self.made[place[:2]]) / "configuration.json"
            keys = base_configuration(str(path))
        return indices.of_core(keys, counted)

    def _configuration(self, flow: Workflow, name: str) -> Json:
        one = self.configurations[name]
        counted = [(core, found) for core, job in self.own[name] if (found := flow.result(job))]
        own = flow.result(self.own[name][0][1])
        return {
            "about": one.keys["about"],
            **{key: one.keys[key] for key in ("packets", "lines", "memory", "ways")},
            **{key: figures.own_value(one.keys, key) for key in figures.KEYS},
            "curves": one.curves,
            "clock": placed_clocks.of(name).of_core(name),
            "gates": indices.of_core(one.keys, own, indices.split(counted)),
        }

    def _runs(self, flow: Workflow, scene: str, name: str, gates: Json | None) -> Iterator[Json]:
        """The walks that there are."""
        for point in self.configurations[name].points:
            place = (scene, name, figures.name_of(point))
            walk = flow.result(self.walks[place])
            if walk is None:
                continue
            mean = frame.mean([one["figures"] for one in walk["walk"]["frames"]])
            own = not figures.keys_of(point) and MADE not in point
            counted = gates if own else self._gates(flow, place, point)
            found = frame.figures_of(mean) | (indices.indices(counted, mean) if counted else {})
            stated = {"scene": scene, "configuration": name, "flags": dict(point)}
            yield {**stated, **{k: v for k, v in found.items() if v is not None}}

    def collected(self, flow: Workflow, scenes: Json) -> Json:
        """The report. `missing` says where walks are missing; why, the caller knows."""
        report: Json = {
            "size": self.size,
            "frames": self.frames,
            "figures": list(self.drawn),
            "reading": TABLE["reading"],
            "scenes": {name: {"about": scene["about"]} for name, scene in scenes.items()},
            "configurations": {n: self._configuration(flow, n) for n in self.configurations},
            "table": [],
            "runs": [],
            "missing": [],
        }
        for scene in scenes:
            for name, one in self.configurations.items():
                runs = list(self._runs(flow, scene, name, report["configurations"][name]["gates"]))
                report["runs"] += runs
                own = figures.own_point(one.keys)
                report["table"] += [table_row(r, one.keys) for r in runs if r["flags"] == own]
                if absent := len(one.points) - len(runs):
                    counted = f"{absent} of {len(one.points)} walks"
                    report["missing"].append(f"{scene}, {name}: {counted}")
        report |= {"findings": indices.findings(report), "additions": indices.additions(report)}
        return report


def table_row(run: Json, keys: Json) -> Json:
    """The figures of a configuration with all its packets and lines."""
    name = run["configuration"]
    known = {**run, **{key: keys[key] for key in ("packets", "lines")}}
    known |= beside_the_thesis(run, name, "")
    place = {"scene": run["scene"], "configuration": name}
    return {**place, **{column: known.get(column) for column in COLUMNS}}


def with_rates(kept: Json) -> Json:
    """A report with the frame rates that kept data leave out, as they follow from the clocks."""
    runs = [
        {
            **run,
            frame.RATE: placed_clocks.frames_per_second(run["clocks"], placed_clocks.THESIS_MHZ),
        }
        for run in kept["runs"]
    ]
    return {**kept, "runs": runs}


def csv_rows(report: Json) -> list[Json]:
    """The runs with their flags as columns."""
    return [
        {**{k: run[k] for k in ("scene", "configuration")}, **run["flags"]}
        | {k: v for k, v in run.items() if k != "flags"}
        for run in report["runs"]
    ]


def formula(gates: Json | None) -> str | None:
    if not gates or not gates["split"]:
        return None
    parts = (sum(gates["split"][part].values()) for part in ("fixed", "packet", "line"))
    fixed, packet, line = (f"{part:,.0f}" for part in parts)
    return f"{fixed} + {packet} P + {line} CL"


def gates_rows(report: Json) -> list[list[object]]:
    rows = []
    for name, one in report["configurations"].items():
        gates = one["gates"] or {"logic": None, "memory": None, "split": None}
        both = one["gates"] and gates["logic"] + gates["memory"]
        clock = one.get("clock") or placed_clocks.of(name).of_core(name)
        rows.append([name, gates["logic"], gates["memory"], both, formula(one["gates"]), clock])
    return [*rows, ["the thesis's", "", "", "", "487,020 + 56,028 P + 996 CL", "at 85 MHz"]]


def tables(report: Json) -> list[Json]:
    """Those of the page below the walks."""

    def listed(rows: Sequence[Json], *columns: str) -> list[list[object]]:
        return [[row.get(column) for column in columns] for row in rows]

    said = [TABLE["said"].get(column, "") for column in indices.FINDINGS]
    found = [
        {"title": "How the indices are read", "items": report["reading"]},
        {
            "title": "Gates of each configuration",
            "columns": ["", "C_AU", "C_IM", "C_AU + C_IM", "as packets P and lines CL", "clock"],
            "rows": gates_rows(report),
        },
        {
            "title": "What the curves say",
            "about": "Of the last row the thesis's text, of its scenes Gael and conference. The gains "
            "of the Morton curve are in percent of all lookups, with all lines.",
            "columns": ["scene", "configuration", *indices.FINDINGS],
            "rows": [
                *listed(report["findings"], "scene", "configuration", *indices.FINDINGS),
                ["the thesis's", "", *said],
            ],
        },
    ]
    if report["additions"]:
        heads = ("scene", "configuration", "addition", *indices.GAINS)
        found.append(
            {
                "title": "What this project added",
                "about": "How many percent more frames a second and gates a core has with each "
                "addition, and the thesis's indices without and with it. No core writes hit records.",
                "columns": list(heads),
                "rows": listed(report["additions"], *heads),
            }
        )
    return found


def shown(report: Json) -> Json:
    """The page of a report."""
    rows = []
    for row in report["table"]:
        rate = placed_clocks.rate_text(row["clocks"], row["configuration"], ".1f")
        known = {
            **row,
            PLACED: rate,
            frame.RATE: placed_clocks.frames_per_second(row["clocks"], placed_clocks.THESIS_MHZ),
        }
        rows.append(
            {
                "scene": row["scene"],
                "variant": row["configuration"],
                "differs": "",
                "family": row["configuration"],
                "figures": {column: known.get(column) for column in COLUMNS},
            }
        )
    frames = "the first frame" if report["frames"] == 1 else f"{report['frames']} frames"
    return page.shown(
        "The hardware by the thesis's measures",
        f"Figures 7.5 to 7.12 of the thesis (Sven Woop, 2004, chapter 7.2) for our cores, of "
        f"{report['size']} pixels. Each is the mean over {frames} of a walk through the scene. The "
        "native model counts the clocks by the schedules of the Verilog.",
        report["scenes"],
        rows,
        name="hardware",
        columns=page.named(differ=False)
        + [page.column(c, words=c in (PLACED, RATES)) for c in COLUMNS],
        figures=figures.shown(report),
        tables=tables(report),
        missing=report["missing"],
    )
