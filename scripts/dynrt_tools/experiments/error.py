# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The error report: variants of the core, each frame held beside the truth, over time and area.
Each variant runs at the shortest period for which hlsc can schedule all its units."""

import argparse
import pathlib
from collections.abc import Mapping, Sequence

from dynrt_tools.experiments import page, table
from dynrt_tools.experiments.jobs import OUT, Core, File, Job, Maker, Word
from dynrt_tools.experiments.table import Variant
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.hardware.area import FAMILY
from dynrt_tools.hardware.devices import COLUMNS, FAMILIES
from dynrt_tools.project import ROOT, Json

PICTURES = ("image", "difference", "truth")
TOLD = ("primary.wrong_share", "primary.t_median", "image.differ_share", "image.psnr")


def variants_of(args: argparse.Namespace) -> dict[str, Variant]:
    base = table.base_configuration(args.config)
    path = args.variants.resolve()
    own = not any(path.is_relative_to(ROOT / folder) for folder in ("scripts", "hls/configs"))
    named = "" if args.config.endswith(".json") else args.config
    return table.chosen(table.with_reference(args.variants, base, named, own), args.variant)


class Experiment:
    """The jobs of these scenes and variants, and what they have found."""

    def __init__(
        self,
        maker: Maker,
        scenes: Mapping[str, Word],
        variants: Mapping[str, Variant],
        size: str,
        hardware: bool,
    ) -> None:
        self.variants, self.size = variants, size
        self.area: dict[str, Job] = {}
        self.frames: dict[tuple[str, str], Job] = {}
        for name, variant in variants.items():
            keys = variant.configuration
            verilog = maker.verilog(name, keys, "least") if hardware else None
            if verilog:
                self.area[name] = maker.counted("area", verilog)
            core = Core(variant.named, None if variant.named else maker.model(name, keys), verilog)
            for scene, word in scenes.items():
                words = (File(maker.program), "measure", word, "--size", size)
                out = ("--out", OUT.rstrip("/"))
                self.frames[scene, name] = maker.frame(f"{scene}, {name}", words, core, out)

    @property
    def goals(self) -> list[Job]:
        return [*self.area.values(), *self.frames.values()]

    def collected(self, flow: Workflow, scenes: Json) -> tuple[Json, dict[str, pathlib.Path]]:
        """The report, and the present place of each picture that it names."""
        report: Json = {
            "size": self.size,
            "device": FAMILIES[FAMILY]["name"],
            "reference": next(n for n, v in self.variants.items() if not v.differs),
            "scenes": {name: {"about": scene["about"]} for name, scene in scenes.items()},
            "variants": {},
            "runs": [],
        }
        for name, variant in self.variants.items():
            report["variants"][name] = {
                "differs": variant.differs,
                "configuration": variant.configuration,
                **(flow.result(self.area.get(name)) or {}),
            }
        pictures = {}
        for (scene, name), job in self.frames.items():
            run = flow.result(job)
            if run is None:
                continue
            for kind in PICTURES:
                path = flow.kept(job) / f"{kind}.png"
                if path.exists():
                    owner = report["scenes"][scene] if kind == "truth" else run
                    suffix = {"image": name, "difference": f"{name}.difference"}.get(kind, kind)
                    owner.setdefault(kind, f"pictures/{scene}/{suffix}.png")
                    pictures[owner[kind]] = path
            if "clocks" in run and "schedule" in report["variants"][name]:
                run["frame_ms"] = run["clocks"] * clock_ns(report["variants"][name]) / 1e6
            report["runs"].append({"scene": scene, "variant": name, **run})
        return report, pictures


def clock_ns(variant: Json) -> float:
    """The period for which its units are scheduled."""
    return float(variant["schedule"]["clock_ns"])


def measures_of(run: Json) -> Json:
    """Every figure of a run as KIND.NAME."""
    return {
        f"{kind}.{name}": value
        for kind, figures in run.get("measures", {}).items()
        for name, value in figures.items()
    }


def rows_of(report: Json) -> list[Json]:
    """A row for each run: what the variant differs by, its area, period, clocks and every
    measure."""
    measures = list(dict.fromkeys(m for run in report["runs"] for m in measures_of(run)))
    rows = []
    for run in report["runs"]:
        variant, found = report["variants"][run["variant"]], measures_of(run)
        rows.append(
            {
                **{key: run[key] for key in ("scene", "variant")},
                "differs": variant["differs"],
                **{name: variant.get("area", {}).get(name) for name in COLUMNS},
                "clock_ns": variant.get("schedule", {}).get("clock_ns"),
                "clocks": run.get("clocks"),
                "frame_ms": run.get("frame_ms"),
                **{name: found.get(name) for name in measures},
                "refused": run.get("refused"),
            }
        )
    return rows


def csv_rows(report: Json) -> list[Json]:
    """The rows with each key in which variants differ as a column."""
    keys = list(dict.fromkeys(k for v in report["variants"].values() for k in v["differs"]))
    lines = []
    for row in rows_of(report):
        configuration = report["variants"][row["variant"]]["configuration"]
        values = {key: row["differs"].get(key, configuration.get(key)) for key in keys}
        line = {key: row.pop(key) for key in ("scene", "variant")}
        lines.append({**line, **values, **{k: v for k, v in row.items() if k != "differs"}})
    return lines


def kept(report: Json) -> Json:
    """What the documents keep, and the page shows."""
    heads = ("size", "device", "reference", "scenes")
    return {**{key: report[key] for key in heads}, "rows": rows_of(report)}


def periods(rows: list[Json]) -> str:
    """Of the variants, in words."""
    found = {row["clock_ns"] for row in rows if row["clock_ns"]}
    if not found:
        return ""
    least, most = min(found), max(found)
    return f"clock of {least:g} ns; " if least == most else f"clocks of {least:g} to {most:g} ns; "


def columns_of(rows: list[Json]) -> list[Json]:
    """Of the page's table: only those that some row has."""
    found = page.named()
    found += [page.column(n, "time", better="less", told=True) for n in ("clocks", "clock_ns")]
    found[-1] |= {"name": "clock", "unit": "ns"}
    found.insert(
        -1, page.column("frame_ms", "time", "a frame", unit="ms", better="less", told=True)
    )
    found += [page.column(n, "area", better="less", told=True) for n in COLUMNS]
    for measure in page.read_measures():
        key = f"{measure['group']}.{measure['name']}"
        better = measure["better"].replace("-", "")
        found.append({**measure, "key": key, "better": better, "told": key in TOLD})
    known = [c for c in found if any(row.get(c["key"]) is not None for row in rows)]
    return [c for c in found if c in known or c["group"] == "variant"]


def shown(data: Json, missing: Sequence[str] = ()) -> Json:
    """The page of what is kept of a report, without pictures."""
    rows = data["rows"]
    columns = columns_of(rows)
    errors = [c["key"] for c in columns if c["better"] and c["group"] not in ("time", "area")]
    times = [k for k in ("frame_ms", "clocks") if any(c["key"] == k for c in columns)]
    areas = [c["key"] for c in columns if c["group"] == "area"]
    first = next((k for k in ("primary.wrong_share", "image.rms") if k in errors), None)
    found = []
    for row in rows:
        figures = {c["key"]: row.get(c["key"]) for c in columns if c["group"] != "variant"}
        if figures.get("image.differ") == 0 and "image.psnr" in figures:
            figures["image.psnr"] = "identical"
        one = {key: row[key] for key in ("scene", "variant", "refused") if row.get(key)}
        one["differs"] = page.described(row["differs"], "the reference")
        found.append(
            {**one, "family": " + ".join(row["differs"]) or "reference", "figures": figures}
        )
    about = f"{data['size']} pixels; {periods(rows)}area on {data['device']}; "
    return page.shown(
        "How wrong and how fast",
        f"{about}reference {data['reference']}",
        data["scenes"],
        found,
        name="error",
        columns=columns,
        axes={"y": errors, "x": [times, areas], "first": first, "wanted": True},
        reference=data["reference"],
        missing=list(missing),
    )


def with_pictures(data: Json, report: Json, folder: pathlib.Path) -> Json:
    """A page with the pictures that the report names; `folder` is where their paths begin."""
    named = [scene["truth"] for scene in report["scenes"].values() if "truth" in scene]
    for row, run in zip(data["rows"], report["runs"]):
        row |= {kind: run[kind] for kind in ("image", "difference") if kind in run}
        named += [run[kind] for kind in ("image", "difference") if kind in run]
    return {**data, "pictures": {name: page.data_uri(folder / name) for name in named}}
