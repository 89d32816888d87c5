# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Finds links of Markdown pages that lead nowhere."""

import pathlib
import re
from collections.abc import Iterator

LINK = re.compile(r"!?\[[^\]]*\]\(([^()\s]+)\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`|<!--.*?-->", re.DOTALL)
NAMED = re.compile(
    r"`((?:cmake|constraints|docs|hls|host|rtl|scenes|scripts|verif)/[\w./-]+)[^`\n]*`"
)
PLACEHOLDER = re.compile(r"(?<![A-Za-z])[A-Z]{4,}(?![A-Za-z])")
HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.MULTILINE)
ANCHOR = re.compile(r'\b(?:id|name)="([^"]+)"')


def pages(root: pathlib.Path) -> list[pathlib.Path]:
    """The pages of a project that people read, README first."""
    tops = [root / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md")]
    tops.append(root / "CHANGELOG.md")
    readmes = [root / "hls/compiler/README.md", *sorted(root.glob("scenes/*.md"))]
    readmes += sorted(root.glob("scripts/dynrt_tools/*/README.md"))
    ours = [path for path in root.glob("docs/**/*.md") if path.parent.name != "templates"]
    return tops + readmes + sorted(ours)


def without_code(text: str) -> str:
    """The text with code blanked out; lines keep their numbers."""
    return CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def slug(heading: str) -> str:
    """The anchor that a heading gets."""
    words = re.sub(r"[^\w\s-]", "", heading.replace("`", "").lower())
    return re.sub(r"[\s-]+", "-", words).strip("-")


def anchors(page: pathlib.Path) -> set[str]:
    """The places of a page to which a link may lead."""
    text = page.read_text(encoding="utf-8")
    return {slug(found) for found in HEADING.findall(text)} | set(ANCHOR.findall(text))


def links(page: pathlib.Path) -> Iterator[tuple[int, str]]:
    """Line and target of each link."""
    text = without_code(page.read_text(encoding="utf-8"))
    for found in LINK.finditer(text):
        yield text.count("\n", 0, found.start()) + 1, found[1]


def names(page: pathlib.Path) -> Iterator[tuple[int, str]]:
    """Line and path of each file and folder of the project that the page names as code."""
    text = page.read_text(encoding="utf-8")
    for found in NAMED.finditer(text):
        if not PLACEHOLDER.search(found[0]):
            yield text.count("\n", 0, found.start()) + 1, found[1]


def exists(root: pathlib.Path, name: str) -> bool:
    """Whether the project has it: a file or folder, a C++ file without its ending, or a header of
    the language by the name with which a unit includes it."""
    folders = (root, root / "hls" / "include", root / "hls" / "lowered")
    paths = [folder / name.rstrip(".") for folder in folders]
    return any(path.exists() or any(path.parent.glob(f"{path.name}.*")) for path in paths)


def broken(root: pathlib.Path) -> list[str]:
    """A sentence for each link of the project's pages that leads nowhere, and for each file that
    a page names and that is not there."""
    problems = []
    for page in pages(root):
        for line, name in names(page):
            if not exists(root, name):
                where = f"{page.relative_to(root)}:{line}"
                problems.append(f"{where}: '{name}' is no file or folder of the project")
        for line, target in links(page):
            if re.match(r"\w+:", target):
                continue
            where = f"{page.relative_to(root)}:{line}"
            path, _, anchor = target.partition("#")
            aim = (page.parent / path).resolve() if path else page
            if not aim.exists():
                problems.append(f"{where}: the link '{target}' leads to no file of the project")
            elif anchor and aim.suffix == ".md" and anchor not in anchors(aim):
                problems.append(f"{where}: {aim.relative_to(root)} has no heading '{anchor}'")
    return problems
