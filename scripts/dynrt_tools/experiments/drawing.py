# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The plots of a page as SVG for the documents, as Chromium has them."""

import json
import pathlib
import re
import tempfile
import urllib.parse
from collections.abc import Sequence

from dynrt_tools.experiments import browser, page
from dynrt_tools.project import Failed, Json, require_tool

MARGIN, HEAD = 24, 34
# Has the page give every plot of a figure in every scene, in an element of its own.
PROBE = """
const found = [];
const plot = (svg, title) => ({title, box: svg.getAttribute("viewBox"), content: svg.innerHTML});
for (const scene of Object.keys(report.scenes)) {
  choose({scene});
  for (const svg of document.querySelectorAll("#scatter svg[id]")) {
    if (svg.querySelector("circle")) found.push({figure: "", ...plot(svg, scene)});
  }
  for (const section of document.querySelectorAll("[data-figure]")) {
    for (const svg of section.querySelectorAll("figure > svg")) {
      const several = report.figures.find((f) => f.name === section.dataset.figure).several;
      const title = several ? `${scene}, ${svg.dataset.names}` : scene;
      found.push({figure: section.dataset.figure, ...plot(svg, title)});
    }
  }
}
const drawn = document.createElement("pre");
drawn.id = "drawn";
drawn.textContent = JSON.stringify(found);
document.body.append(drawn);
"""


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


def plots(data: Json, view: Json) -> list[Json]:
    """Every plot of the page of these data: of which `figure`, its title, view box and content."""
    require_tool("chromium", "chromium")
    text = page.page(data).replace("</body>", f"<script>{PROBE}</script></body>")
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "page.html"
        path.write_text(text, encoding="utf-8")
        document, complaints = browser.load(path, urllib.parse.urlencode(view))
    if complaints:
        raise Failed(f"the page complains: {complaints[0]}")
    element = re.search(r'<pre id="drawn">(.*?)</pre>', document, re.DOTALL)
    assert element
    unquoted = element[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
    found: list[Json] = json.loads(unquoted.replace("\xa0", " ").replace("&nbsp;", " "))
    return found


def sheet(title: str, shown: Sequence[Json], columns: int) -> str:
    """Plots side by side, as a file."""
    boxes = [tuple(map(float, one["box"].split()[2:])) for one in shown]
    width, height = (max(box[i] for box in boxes) for i in (0, 1))
    rows = -(-len(shown) // columns)
    whole = (columns * (width + MARGIN) + MARGIN, HEAD + rows * (height + HEAD))
    panels = []
    for number, one in enumerate(shown):
        row, column = divmod(number, columns)
        at = (MARGIN + column * (width + MARGIN), HEAD + row * (height + HEAD))
        name = f'<text x="{width / 2:g}" y="-4" text-anchor="middle">{one["title"]}</text>'
        panels.append(
            f'<g transform="translate({at[0]:g},{at[1] + 12:g})">{name}{one["content"]}</g>'
        )
    text = "\n".join(panels)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {whole[0]:g} {whole[1]:g}" '
        f'width="{whole[0]:g}" height="{whole[1]:g}" '
        f'font-family="system-ui, DejaVu Sans, sans-serif">\n'
        f"<style>\n{style()}\n</style>\n"
        f'<rect width="{whole[0]:g}" height="{whole[1]:g}" style="fill: var(--paper)"/>\n'
        f'<text x="{MARGIN}" y="20">{title}</text>\n{text}\n</svg>\n'
    )


def drawings(data: Json, view: Json | None = None) -> dict[str, str]:
    """The drawings of a page by the names of their files: one of its plots over time and area, and
    one for each figure."""
    found = plots(data, view or {})
    files = {}
    if both := [one for one in found if not one["figure"]]:
        files[f"{data['name']}.svg"] = sheet(f"{data['title']}: {data['about']}", both, 2)
    for figure in data["figures"]:
        mine = [one for one in found if one["figure"] == figure["name"]]
        if mine:
            title = f"{figure['title']} over {figure['over']} (thesis figure {figure['name']})"
            columns = len(mine) // len(data["scenes"]) if figure["several"] else 2
            files[f"{file_of(figure['name'])}.svg"] = sheet(title, mine, max(columns, 1))
    return files


def file_of(figure: str) -> str:
    return "figure_" + figure.replace(".", "_").replace(" and ", "_and_")
