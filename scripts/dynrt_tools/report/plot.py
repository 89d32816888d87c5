# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The plots of an error report for the documents, as SVG: one measure of one scene over run time
and over area, as the report's page draws them."""

import argparse
import pathlib
import re
import tempfile
import urllib.parse

from dynrt_tools import project
from dynrt_tools.project import read_json, searched
from dynrt_tools.report import browser, page
from dynrt_tools.report.collect import clock_ns

WIDTH, HEIGHT = 640, 430  # of a plot, as page.js has it
MARGIN, HEAD = 24, 34
PLOTS = ("time-plot", "area-plot")


def style() -> str:
    """The part of the page's style that concerns plots, and the colours."""
    css = (page.PARTS / "page.css").read_text(encoding="utf-8")
    rules = re.findall(
        r"^(?::root|@media \(prefers-color-scheme: dark\)) \{.*?^\}|"
        r"^svg (?:text|\.)[^{]*\{[^}]*\}",
        css,
        re.MULTILINE | re.DOTALL,
    )
    return "\n".join(rules)


def drawn(report: project.Json, scene: str) -> list[project.Json]:
    """The runs of a scene that have a point."""
    return [r for r in report["runs"] if r["scene"] == scene and "refused" not in r]


def periods(report: project.Json, scene: str) -> str:
    """Of the variants that are drawn, in words."""
    found = {clock_ns(report["variants"][run["variant"]]) for run in drawn(report, scene)}
    least, most = min(found), max(found)
    return f"clock of {least:g} ns" if least == most else f"clocks of {least:g} to {most:g} ns"


def svg(report_path: pathlib.Path, scene: str, measure: str, area: str) -> str:
    """Both plots, side by side."""
    report = read_json(report_path)
    view = urllib.parse.urlencode({"scene": scene, "measure": measure, "area": area})
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "error.html"
        path.write_text(page.page(report, report_path.parent), encoding="utf-8")
        document, complaints = browser.load(path, view)
    if complaints:
        raise SystemExit(f"plot.py: the page complains: {complaints[0]}")
    plots = [
        searched(rf'<svg id="{name}"[^>]*>(.*?)</svg>', document, re.DOTALL)[1] for name in PLOTS
    ]
    width = 2 * WIDTH + 3 * MARGIN
    height = HEIGHT + HEAD
    title = (
        f"{scene}, {report['size']}, {periods(report, scene)}, area on {report['device']}; "
        "dashed: the front, which no other variant beats in both"
    )
    panels = "\n".join(
        f'<g transform="translate({MARGIN + i * (WIDTH + MARGIN)},{HEAD})">{plot}</g>'
        for i, plot in enumerate(plots)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        f'width="{width}" height="{height}" font-family="system-ui, DejaVu Sans, sans-serif">\n'
        f"<style>\n{style()}\n</style>\n"
        f'<rect width="{width}" height="{height}" style="fill: var(--paper)"/>\n'
        f'<text x="{MARGIN}" y="20">{title}</text>\n{panels}\n</svg>\n'
    )


def figures(report: project.Json, scene: str, measure: str, area: str) -> project.Json:
    """The figures of the plots' points, as the data of docs/results/error.md."""
    group, name = measure.split(".")
    return {
        "scene": scene,
        "size": report["size"],
        "device": report["device"],
        "variants": [
            {
                "variant": run["variant"],
                "clock, ns": clock_ns(report["variants"][run["variant"]]),
                "frame, ms": run["frame_ms"],
                area: report["variants"][run["variant"]]["area"][area],
                measure: run["measures"][group][name],
            }
            for run in drawn(report, scene)
        ],
    }


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/plot_error", description=__doc__)
    parser.add_argument(
        "report",
        type=pathlib.Path,
        metavar="FILE",
        help="error.json of a report; its pictures lie in the same folder",
    )
    parser.add_argument(
        "--scene", default="office", metavar="NAME", help="a scene of the report (default: office)"
    )
    parser.add_argument(
        "--measure",
        default="primary.wrong_share",
        metavar="GROUP.NAME",
        help="a measure of docs/reference/measures.md (default: primary.wrong_share)",
    )
    parser.add_argument(
        "--area",
        default="LUT",
        metavar="NAME",
        help="the cells that the area counts (default: LUT)",
    )
    parser.add_argument(
        "--out", type=pathlib.Path, required=True, metavar="FILE.svg", help="the drawing"
    )
    parser.add_argument(
        "--data",
        type=pathlib.Path,
        metavar="FILE.json",
        help="the file that receives the figures of the points",
    )
    args = parser.parse_args()
    scenes = read_json(args.report)["scenes"]
    known = [f"{m['group']}.{m['name']}" for m in page.read_measures() if m["better"] != "-"]
    if args.scene not in scenes:
        parser.error(
            f"--scene {args.scene}: unknown; {args.report} has the scenes {', '.join(scenes)}"
        )
    if args.measure not in known:
        parser.error(f"--measure {args.measure}: unknown; the measures are {', '.join(known)}")
    args.out.write_text(svg(args.report, args.scene, args.measure, args.area), encoding="utf-8")
    if args.data:
        report = project.read_json(args.report)
        project.write_json(args.data, figures(report, args.scene, args.measure, args.area))
