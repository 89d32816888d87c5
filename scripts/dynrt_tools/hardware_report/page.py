# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of a hardware report, made of hardware.json: one file that needs nothing else."""

import pathlib

from dynrt_tools.hardware_report import additions, findings, rows
from dynrt_tools.hardware_report.figure import Figure
from dynrt_tools.hardware_report.figures import curves, drawn_in
from dynrt_tools.project import Json, read_json
from dynrt_tools.report.page import assembled

PARTS = pathlib.Path(__file__).resolve().parent / "page"


def plot(report: Json, figure: Figure, scene: str) -> Json:
    """What the page draws of a figure for a scene."""
    mark = figure.marks.get(scene)
    return {
        "curves": [
            {
                "configuration": curve.configuration,
                "label": curve.series.label,
                "dashed": curve.series.dashed,
                "points": curve.points,
            }
            for curve in curves(report, figure, scene)
        ],
        "mark": mark and {"x": mark.x, "low": mark.low, "high": mark.high},
    }


def shown(report: Json) -> Json:
    """The report as the page has it: figures with their curves in place of the runs."""
    figures = []
    for figure in drawn_in(report):
        plots = {scene: plot(report, figure, scene) for scene in report["scenes"]}
        if any(one["curves"] for one in plots.values()):
            figures.append(
                {
                    "name": figure.name,
                    "title": figure.title,
                    "over": figure.over,
                    "unit": figure.unit,
                    "limit": figure.limit,
                    "said": figure.said,
                    "several": len(figure.series) > 1,
                    "plots": plots,
                }
            )
    kept = {key: value for key, value in report.items() if key != "runs"}
    return {
        **kept,
        "columns": list(rows.TABLE),
        "found": list(findings.COLUMNS),
        "added": list(additions.COLUMNS),
        "said": findings.THESIS,
        "figures": figures,
    }


def page(report: Json) -> str:
    return assembled(PARTS, shown(report))


def write_page(source: pathlib.Path, goal: pathlib.Path) -> None:
    goal.write_text(page(read_json(source)), encoding="utf-8")
