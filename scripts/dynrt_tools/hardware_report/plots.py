# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures as SVG for the documents: a file for each figure, with a plot for each scene and, where
a figure has several curves, for each configuration."""

import itertools
import pathlib
from typing import Any

from matplotlib import pyplot

from dynrt_tools.hardware_report.figure import Figure
from dynrt_tools.hardware_report.figures import Curve, curves, drawn_in
from dynrt_tools.project import Json

WIDTH, HEIGHT = 4.2, 3.1  # of a plot, in inches
COLOURS = ("#4269d0", "#d9730d", "#3a9a56", "#b2528f", "#8a6d1d", "#2a9aa5")
MARK = "#7a7f87"


def panels(report: Json, figure: Figure) -> list[tuple[str, list[list[Curve]]]]:
    """The plots of each scene that has curves: of one curve a configuration all together, else of each
    configuration."""
    found = []
    for scene in report["scenes"]:
        drawn = list(curves(report, figure, scene))
        if len(figure.series) == 1:
            groups = [drawn]
        else:
            by_name = itertools.groupby(drawn, lambda curve: curve.configuration)
            groups = [list(group) for _, group in by_name]
        if drawn:
            found.append((scene, groups))
    return found


def draw_panel(axes: Any, figure: Figure, scene: str, group: list[Curve]) -> None:
    single = len(figure.series) == 1
    labels = [c.series.label.partition(",")[0] for c in group]
    colours = dict(zip(dict.fromkeys(labels), COLOURS))
    for number, curve in enumerate(group):
        colour = COLOURS[number] if single else colours[labels[number]]
        axes.plot(
            *zip(*curve.points),
            marker="o",
            markersize=3,
            color=colour,
            linestyle="--" if curve.series.dashed else "-",
            label=curve.configuration if single else curve.series.label,
        )
    if mark := figure.marks.get(scene):
        if mark.x is None:
            axes.axhspan(mark.low, mark.high, color=MARK, alpha=0.25, label="thesis")
        else:
            axes.plot([mark.x], [mark.low], "D", color=MARK, label="thesis")
    title = scene if single else f"{scene}, {group[0].configuration}"
    axes.set(title=title, xlabel=figure.over, ylabel=figure.unit, xlim=(0, None))
    axes.set_ylim(0, figure.limit)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7)


def draw(path: pathlib.Path, report: Json, figure: Figure) -> bool:
    """False if there is nothing to draw."""
    found = panels(report, figure)
    if not found:
        return False
    rows, columns = len(found), max(len(groups) for _, groups in found)
    if columns == 1:  # the scenes side by side, two in a row
        rows, columns = (rows + 1) // 2, min(rows, 2)
        cells = [(divmod(i, 2), scene, groups[0]) for i, (scene, groups) in enumerate(found)]
    else:
        cells = [
            ((i, j), scene, group)
            for i, (scene, groups) in enumerate(found)
            for j, group in enumerate(groups)
        ]
    size = (WIDTH * columns, HEIGHT * rows)
    sheet, grid = pyplot.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False)
    for axes in grid.flat:
        axes.set_visible(False)
    for (row, column), scene, group in cells:
        grid[row][column].set_visible(True)
        draw_panel(grid[row][column], figure, scene, group)
    sheet.suptitle(
        f"{figure.title} over {figure.over}, {report['size']} (thesis figure {figure.name})"
    )
    # Without its date and with names of its own the file is the same for the same figures.
    sheet.savefig(path, metadata={"Date": None})
    pyplot.close(sheet)
    return True


def write(folder: pathlib.Path, report: Json) -> list[pathlib.Path]:
    """The drawings of all figures that have a curve."""
    pyplot.switch_backend("svg")  # no window
    pyplot.rcParams["svg.hashsalt"] = "dynrt"
    pyplot.rcParams["svg.fonttype"] = "none"  # text stays text
    paths = [(folder / f"{figure.file}.svg", figure) for figure in drawn_in(report)]
    return [path for path, figure in paths if draw(path, report, figure)]
