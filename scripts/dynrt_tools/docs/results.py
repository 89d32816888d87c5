# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The pages of results: templates whose figures come from the kept data of runs.

docs/results/templates/NAME.md is Markdown in which {{DATA:PATH|FORMAT}} stands for a figure of
docs/results/data/DATA.json. PATH leads through the data by /; in a list, words joined by + select
the entry that has all of them as values; A&B is the sum of two figures and A%B their ratio. FORMAT
is Python's, such as "," or ".1f"; it may begin with *FACTOR, or with @CONFIGURATION or @MHZ, which
makes frames per second of the clocks of a frame: at the placed clock, in brackets where it is that of
another configuration, or at a stated one. {{placed:CONFIGURATION/FIELD}} is a field of the placed
clock itself (hardware/placed_clocks.py). Where the data have null the page says
"not measured". {{DATA:command}} is the command that measures the data again, and a date with the
FORMAT day is one in words. Rows that differ in a name are written once, in a loop (docs/loops.py).
"""

import dataclasses
import pathlib
import re
from typing import Any

from dynrt_tools import project
from dynrt_tools.docs import loops
from dynrt_tools.hardware import placed_clocks

RESULTS = project.ROOT / "docs" / "results"
TEMPLATES = RESULTS / "templates"
FIGURE = re.compile(r"\{\{(\w+):([^|}]+)(?:\|([^}]*))?\}\}")
PLACED = "placed"  # a name that is none of a file


def template(path: pathlib.Path) -> loops.Lines:
    """The lines of a template without its loops."""
    where = f"docs/results/templates/{path.name}"
    return loops.unrolled(path.read_text(encoding="utf-8"), where)


def template_of(page: str) -> loops.Lines:
    """That of a page of this project."""
    return template(TEMPLATES / f"{page}.md")


def template_text(page: str) -> str:
    return "\n".join(line for _, line in template_of(page))


def named(lines: loops.Lines) -> list[str]:
    """The data that a template without loops shows, in its order."""
    figures = (figure for _, line in lines for figure in FIGURE.finditer(line))
    return list(dict.fromkeys(f[1] for f in figures if f[1] != PLACED))


class Data:
    """The data of a folder, each file read once; runs.json says where each is from."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder
        self.read: dict[str, Any] = {}

    def load(self, name: str) -> Any:
        """The data of a name."""
        if name not in self.read:
            path = self.folder / f"{name}.json"
            if not path.exists():
                raise project.Failed(f"there is no {path.name}; {self.renewal(name)}")
            self.read[name] = project.read_json(path)
        return self.read[name]

    def renewal(self, name: str) -> str:
        """How to measure the data, in a few words."""
        run = project.read_json(self.folder / "runs.json").get(name)
        command = run and run.get("command")
        return f"'{command}' measures it" if command else "runs.json names no command for it"

    def sources(self, names: list[str]) -> list[str]:
        """The lines of a page that say where its figures come from."""
        runs = project.read_json(self.folder / "runs.json")
        lines = [
            "",
            "## Where the figures come from",
            "",
            "| data | measured | with |",
            "|---|---|---|",
        ]
        for name in names:
            run = runs[name]
            link = f"[{name}.json](data/{name}.json)"
            command = f"`{run['command']}`" if "command" in run else "a record"
            lines.append(f"| {link} | {run['measured']} | {command} |")
        return lines

    def figure(self, name: str, path: str) -> Any:
        """The figure at a path."""
        if path == "command":
            return project.read_json(self.folder / "runs.json")[name][path]
        if name == PLACED:
            configuration, _, field = path.partition("/")
            clock = placed_clocks.of(configuration)
            fields = dataclasses.asdict(clock) | {"where": clock.where}
            if field not in fields:
                raise project.Failed(f"a placed clock has no '{field}'; it has {', '.join(fields)}")
            return fields[field]
        value = self.load(name)
        for step in path.split("/"):
            if value is None:
                break
            try:
                value = selected(value, step) if isinstance(value, list) else stepped(value, step)
            except (KeyError, TypeError, StopIteration) as error:
                raise project.Failed(f"{name}.json has no '{step}' of '{path}'") from error
        return value


def stepped(values: dict[str, Any], step: str) -> Any:
    """A value, the sum A&B, or the ratio A%B of two, each of which may be a sum."""
    if step in values:
        return values[step]
    above, ratio, below = step.partition("%")
    total = sum(values[part] for part in above.split("&"))
    return total / sum(values[part] for part in below.split("&")) if ratio else total


def selected(entries: list[Any], words: str) -> Any:
    """The entry that has all words as values."""
    wanted = set(words.split("+"))
    return next(e for e in entries if wanted <= {str(value) for value in e.values()})


def shown(value: Any, form: str) -> str:
    """A figure as the page shows it; the data have null for one that is not measured."""
    if value is None:
        return "not measured"
    if rate := re.match(r"@([\w.]+) ?", form):
        return rate_of(value, rate[1], form[rate.end() :])
    if form == "day":
        return project.day(value)
    factor = re.match(r"\*([\d.e+-]+) ?", form)
    if factor:
        value, form = value * float(factor[1]), form[factor.end() :]
    return format(value, form)


def rate_of(cycles: float, clock: str, form: str) -> str:
    """Frames per second at the placed clock of a configuration, or at one in MHz."""
    if re.fullmatch(r"[\d.]+", clock):
        return format(placed_clocks.frames_per_second(cycles, float(clock)), form)
    return placed_clocks.rate_text(cycles, clock, form)


def filled(path: pathlib.Path, data: Data) -> str:
    """The page of a template; a figure without data is named with its line."""
    lines = []
    unrolled = template(path)
    for number, line in unrolled:
        try:
            lines.append(FIGURE.sub(lambda f: shown(data.figure(f[1], f[2]), f[3] or ""), line))
            if "{{" in lines[-1]:
                raise ValueError("'{{' begins no figure; write {{DATA:PATH|FORMAT}} in one line")
        except (project.Failed, ValueError, TypeError) as error:
            where = f"docs/results/templates/{path.name}:{number}"
            raise project.Failed(f"{where}: {error}") from error
    return "\n".join(lines + data.sources(named(unrolled))) + "\n"


def pages(results: pathlib.Path = RESULTS) -> dict[str, str]:
    """Every page of results that has a template, by its file below docs."""
    data = Data(results / "data")
    templates = sorted((results / "templates").glob("*.md"))
    return {f"results/{path.name}": filled(path, data) for path in templates}
