# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The pages that are made from the sources, and whether the checked-in ones are current."""

import pathlib
from collections.abc import Callable, Mapping

from dynrt_tools import project
from dynrt_tools.docs import (
    bus_waves,
    commands,
    keys,
    limits,
    link_format,
    messages,
    register_map,
    registers,
    results,
    waves,
)

MARK = "<!-- Made by scripts/docs --renew; do not edit. -->\n"
DOCS = project.ROOT / "docs"
WAVES = DOCS / "reference" / "waves"
TOOLS = project.ROOT / "build" / "docs" / "npm"

# By the page's file below docs.
FROM_SOURCES: Mapping[str, Callable[[], str]] = {
    "reference/keys.md": keys.keys_page,
    "reference/configurations.md": keys.configurations_page,
    "reference/registers.md": registers.page,
    "reference/limits.md": limits.page,
    "reference/link.md": link_format.page,
    "reference/timing.md": waves.page,
    "reference/scripts.md": commands.scripts_page,
    "reference/messages.md": messages.page,
}


def renew(pages: Mapping[str, str], docs: pathlib.Path = DOCS) -> list[pathlib.Path]:
    """Writes the pages that are not current and gives them."""
    written = []
    for name, text in pages.items():
        path = docs / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            written.append(path)
    return written


def stale(pages: Mapping[str, str], docs: pathlib.Path = DOCS) -> list[str]:
    """A sentence for each page that is not current: its file and the first line that differs."""
    problems = []
    for name, text in pages.items():
        path = docs / name
        where = f"docs/{name}"
        if not path.exists():
            problems.append(f"{where}:1: the page is missing; scripts/docs --renew writes it")
            continue
        has = path.read_text(encoding="utf-8").splitlines()
        wants = text.splitlines()
        if has != wants:
            line = next(
                (i for i, (a, b) in enumerate(zip(has, wants), 1) if a != b),
                min(len(has), len(wants)) + 1,
            )
            problems.append(
                f"{where}:{line}: differs from its sources; scripts/docs --renew writes it"
            )
    return problems


def _diagrams() -> dict[str, waves.Diagram]:
    return waves.diagrams() | bus_waves.diagrams()


def stale_waves() -> list[str]:
    """A sentence for each timing diagram that is not current."""
    return [
        f"docs/reference/waves/{name}.svg: differs from the unit's schedule; "
        "scripts/docs --renew draws it"
        for name in waves.stale(_diagrams(), WAVES)
    ]


def renew_waves() -> list[pathlib.Path]:
    """Draws the timing diagrams that are not current and gives their files."""
    return waves.renew(_diagrams(), WAVES, TOOLS)


def from_build(build: pathlib.Path) -> dict[str, str]:
    """The pages that need the programs of a build."""
    dynrt, hlsc = build / "dynrt", build / "hls" / "compiler" / "hlsc"
    for program in (dynrt, hlsc):
        if not program.exists():
            raise project.Failed(
                f"docs/reference/commands.md:1: the page needs {program}, which is not built; "
                "scripts/test builds it, and --build names another folder"
            )
    return {"reference/commands.md": MARK + commands.programs_page(dynrt, hlsc)}


def from_sources() -> dict[str, str]:
    """Every page that needs no build."""
    pages = {name: make() for name, make in FROM_SOURCES.items()} | results.pages()
    return {name: MARK + text for name, text in pages.items()} | register_map.files()
