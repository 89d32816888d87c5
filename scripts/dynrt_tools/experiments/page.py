# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of an experiment: one file that needs nothing else, with plots by D3, which it carries
whole. README.md describes the data that it is made of."""

import base64
import json
import pathlib
from collections.abc import Mapping, Sequence

from dynrt_tools.project import ROOT, Json

PARTS = pathlib.Path(__file__).resolve().parent / "page"
MEASURES = ROOT / "docs" / "reference" / "measures.md"
LIBRARY = pathlib.Path("/usr/share/nodejs/d3/dist/d3.min.js")  # Debian's node-d3
MEASURE = ("group", "name", "unit", "better", "meaning")
SCRIPTS = ("basics", "scatter", "curves", "page")
NO_AXES: Json = {"y": [], "x": [[], []]}


def read_measures(path: pathlib.Path = MEASURES) -> list[dict[str, str]]:
    """The table of docs/reference/measures.md, which measures_test holds against the program's."""
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = [
        [cell.strip(" `") for cell in line.strip("|").split(" | ")]
        for line in lines
        if line.startswith("| ")
    ]
    return [dict(zip(MEASURE, row)) for row in rows[1:]]


def column(key: str, group: str = "", name: str = "", **more: object) -> Json:
    """A column of the table; `better` says whether `less` or `more` of it is."""
    return {"key": key, "group": group, "name": name or key, "unit": "", "better": "", **more}


def named(differ: bool = True) -> list[Json]:
    """The columns that say which row it is."""
    keys = ("scene", "variant", *(("differs",) if differ else ()))
    names = {"differs": "what differs"}
    return [column(key, "variant", names.get(key, key), words=True) for key in keys]


def shown(title: str, about: str, scenes: Json, rows: Sequence[Json], **more: object) -> Json:
    """What the page has: `rows` with scene, variant, what differs, family, figures and pictures."""
    parts: Json = {
        "title": title,
        "about": about,
        "scenes": scenes,
        "rows": rows,
        "columns": [],
        "axes": NO_AXES,
        "reference": "",
        "missing": [],
        "figures": [],
        "tables": [],
        "pictures": {},
    }
    return {**parts, **more}


def described(differs: Mapping[str, object], reference: str) -> str:
    """What a variant differs by, in words."""
    words = (f"{key} {value}".replace("_", " ") for key, value in differs.items())
    return ", ".join(words) or reference


def data_uri(path: pathlib.Path) -> str:
    return "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode("ascii")


def in_script(text: str) -> str:
    """Nothing in it ends the element that it stands in."""
    return text.replace("</", "<\\/").replace("<!--", "<\\!--")


def page(data: Json) -> str:
    """The page's text."""
    parts = {
        "style": (PARTS / "page.css").read_text(encoding="utf-8"),
        "report": in_script(json.dumps(data)),
        "library": in_script(LIBRARY.read_text(encoding="utf-8")),
    }
    for name in SCRIPTS:
        parts[name] = (PARTS / f"{name}.js").read_text(encoding="utf-8")
    text = (PARTS / "page.html").read_text(encoding="utf-8")
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    return text
