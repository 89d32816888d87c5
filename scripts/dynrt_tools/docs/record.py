# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures the data of a page of results again: runs the commands that docs/results/data/runs.json
names for them, one after another, from the project's folder. Data without a command are a record of
what nobody can measure any more. The pictures of pages are drawn from the same data."""

import pathlib
import subprocess
from collections.abc import Callable, Mapping

from dynrt_tools import project
from dynrt_tools.docs import results
from dynrt_tools.experiments import drawing, error, hardware
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Json

# Pages that a command writes itself, without data and template.
WRITTEN = {
    "gates": "scripts/gates",
    "stress": "cmake --build build/release --target update-stress",
}
# By the data, the page of an experiment of which the pictures are drawn.
DRAWN: Mapping[str, Callable[[Json], Json]] = {
    "error": error.shown,
    "hardware": lambda data: hardware.shown(hardware.with_rates(data)),
}
PICTURES = project.ROOT / "docs" / "pictures"


def data_of(page: str) -> list[str]:
    """The data that a page's template shows, in its order."""
    return results.named(results.template_of(page))


def pages() -> list[str]:
    return sorted([*(path.stem for path in results.TEMPLATES.glob("*.md")), *WRITTEN])


def commands(page: str) -> list[tuple[str, list[int]]]:
    """The commands of a page, each with the exit codes that are no failure."""
    if page in WRITTEN:
        return [(WRITTEN[page], [0])]
    if page not in pages():
        raise project.Failed(f"--record {page}: unknown; the pages are {', '.join(pages())}")
    runs = project.read_json(results.RESULTS / "data" / "runs.json")
    measured = [runs[name] for name in data_of(page) if "command" in runs[name]]
    return [(run["command"], run.get("codes", [0])) for run in measured]


def record(page: str) -> None:
    """Runs the commands of a page; throws Failed for the first that fails."""
    for command, codes in commands(page):
        print(command, flush=True)
        code = subprocess.run(command, shell=True, cwd=project.ROOT, check=False).returncode
        if code not in codes:
            raise project.Failed(f"'{command}' ends with {code}; the data of {page} are not whole")
    for name in data_of(page) if page not in WRITTEN else []:
        drop_rates(results.RESULTS / "data" / f"{name}.json")
        draw(name)


def drop_rates(path: pathlib.Path) -> None:
    """Takes the figures out of kept data that a clock in MHz decides: frames per second follow from
    clocks and the placed clock, so when the clock changes no data are old."""
    data = project.read_json(path)
    kept = placed_clocks.without_rates(data)
    if kept != data:
        project.write_json(path, kept)


def draw(*names: str) -> None:
    """Draws the pictures of these data, or of all."""
    for name in names or DRAWN:
        if name in DRAWN:
            data = project.read_json(results.RESULTS / "data" / f"{name}.json")
            for file, text in drawing.drawings(DRAWN[name](data)).items():
                (PICTURES / file).write_text(text, encoding="utf-8")
