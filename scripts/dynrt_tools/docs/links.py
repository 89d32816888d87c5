# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Finds links of Markdown pages that lead nowhere."""

import pathlib
import re
from collections.abc import Iterator

LINK = re.compile(r"!?\[[^\]]*\]\(([^()\s]+)\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`|<!--.*?-->", re.DOTALL)
HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.MULTILINE)
ANCHOR = re.compile(r'\b(?:id|name)="([^"]+)"')


def pages(root: pathlib.Path) -> list[pathlib.Path]:
    """The pages of a project that people read, README first."""
    tops = [root / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md")]
    tops.append(root / "CHANGELOG.md")
    rooms = [root / "hls/compiler/README.md", *sorted(root.glob("scenes/*.md"))]
    rooms += sorted(root.glob("scripts/dynrt_tools/*/README.md"))
    ours = [path for path in root.glob("docs/**/*.md") if path.parent.name != "templates"]
    return tops + rooms + sorted(ours)


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


def broken(root: pathlib.Path) -> list[str]:
    """A sentence for each link of the project's pages that leads nowhere."""
    problems = []
    for page in pages(root):
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
