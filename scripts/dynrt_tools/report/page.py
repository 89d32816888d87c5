# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of an error report, made of error.json, the pictures that it names and the table of
measures. It is one file that needs nothing else: plots by D3, which it carries whole."""

import base64
import json
import pathlib

from dynrt_tools.project import ROOT, Json, read_json

PARTS = pathlib.Path(__file__).resolve().parent / "page"
MEASURES = ROOT / "docs" / "reference" / "measures.md"
LIBRARY = pathlib.Path("/usr/share/nodejs/d3/dist/d3.min.js")  # Debian's node-d3
COLUMNS = ("group", "name", "unit", "better", "meaning")


def read_measures(path: pathlib.Path = MEASURES) -> list[dict[str, str]]:
    """The table of docs/reference/measures.md, which measures_test holds against the program's."""
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = [
        [cell.strip(" `") for cell in line.strip("|").split(" | ")]
        for line in lines
        if line.startswith("| ")
    ]
    return [dict(zip(COLUMNS, row)) for row in rows[1:]]


def pictures_of(report: Json) -> list[str]:
    """Every picture that the report names."""
    named = [run.get(kind) for run in report["runs"] for kind in ("image", "difference")]
    named += [scene.get("truth") for scene in report["scenes"].values()]
    return [name for name in dict.fromkeys(named) if name]


def data_uri(path: pathlib.Path) -> str:
    return "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode("ascii")


def in_script(text: str) -> str:
    """Nothing in it ends the element that it stands in."""
    return text.replace("</", "<\\/").replace("<!--", "<\\!--")


def assembled(folder: pathlib.Path, shown: Json) -> str:
    """The page whose page.html and page.js are in the folder; style and what its scripts share are
    those of every report."""
    parts = {
        "style": (PARTS / "page.css").read_text(encoding="utf-8"),
        "report": in_script(json.dumps(shown)),
        "library": in_script(LIBRARY.read_text(encoding="utf-8")),
        "shared": (PARTS / "shared.js").read_text(encoding="utf-8"),
        "script": (folder / "page.js").read_text(encoding="utf-8"),
    }
    text = (folder / "page.html").read_text(encoding="utf-8")
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    return text


def page(report: Json, folder: pathlib.Path) -> str:
    """The page's text; `folder` is where the paths of pictures begin."""
    shown = dict(report)
    # The counters of a frame and the units of a variant are not shown.
    shown["runs"] = [{k: v for k, v in run.items() if k != "counters"} for run in report["runs"]]
    shown["variants"] = {
        name: {k: v for k, v in variant.items() if k != "units"}
        for name, variant in report["variants"].items()
    }
    shown["measures"] = read_measures()
    shown["pictures"] = {name: data_uri(folder / name) for name in pictures_of(report)}
    return assembled(PARTS, shown)


def write_page(source: pathlib.Path, goal: pathlib.Path) -> None:
    report = read_json(source)
    goal.write_text(page(report, source.parent), encoding="utf-8")
