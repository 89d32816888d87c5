# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds the site: copies of the pages, and of the sources that they name, through MkDocs."""

import json
import pathlib
import re
import shutil
import subprocess

from dynrt_tools import project
from dynrt_tools.docs import links

CONFIG = project.ROOT / "docs" / "site" / "mkdocs.yml"
BUILD = project.ROOT / "build" / "docs"
PAGES = BUILD / "pages"
SITE = BUILD / "site"
LANGUAGES = {".h": "cpp", ".cpp": "cpp", ".v": "verilog", ".vh": "verilog", ".py": "python"}
PICTURES = (".svg", ".png")


def source_page(path: pathlib.Path) -> str:
    """A page that shows a source."""
    name = path.relative_to(project.ROOT)
    language = LANGUAGES.get(path.suffix, "text")
    text = path.read_text(encoding="utf-8").rstrip()
    return f"# {name}\n\n````{language}\n{text}\n````\n"


class Stage:
    """The folder of copies, laid out as the project is, so that links keep their paths."""

    def __init__(self, root: pathlib.Path, folder: pathlib.Path):
        self.root = root
        self.folder = folder

    def put(self, page: pathlib.Path, place: pathlib.Path | None = None) -> None:
        """Copies a page; a link to a source leads to a page that shows it."""
        text = links.LINK.sub(lambda found: self.aimed(found, page), page.read_text("utf-8"))
        if place:
            text = links.LINK.sub(lambda found: self.moved(found, page), text)
        target = self.folder / (place or page.relative_to(self.root))
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def aimed(self, found: re.Match[str], page: pathlib.Path) -> str:
        """The link, to the page of a source where it names one; that page is made."""
        path, _, _ = found[1].partition("#")
        aim = (page.parent / path).resolve()
        if not path or re.match(r"\w+:", path) or aim.suffix == ".md" or not aim.is_file():
            return found[0]
        copy = self.folder / aim.relative_to(self.root)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if aim.suffix in PICTURES:
            shutil.copyfile(aim, copy)
            return found[0]
        copy.with_name(copy.name + ".md").write_text(source_page(aim), encoding="utf-8")
        return found[0].replace(found[1], path + ".md")

    def moved(self, found: re.Match[str], page: pathlib.Path) -> str:
        """The link of a page that is put into the uppermost folder."""
        path, sharp, anchor = found[1].partition("#")
        aim = (page.parent / path).resolve().relative_to(self.root)
        return found[0].replace(found[1], f"{aim}{sharp}{anchor}")


def stage(root: pathlib.Path = project.ROOT, folder: pathlib.Path = PAGES) -> None:
    """Copies every page into the folder."""
    shutil.rmtree(folder, ignore_errors=True)
    copies = Stage(root, folder)
    home = root / "docs" / "index.md"
    for page in links.pages(root):
        if page != root / "README.md":
            copies.put(page)
    copies.put(home, pathlib.Path("index.md"))
    (folder / "docs" / "index.md").unlink()
    shutil.copyfile(root / "docs" / "site" / "site.css", folder / "docs" / "site.css")


def build() -> pathlib.Path:
    """Builds the site and gives its first page."""
    project.require_tool("mkdocs", "mkdocs-material")
    stage()
    done = subprocess.run(
        ["mkdocs", "build", "--quiet", "--strict", "--config-file", str(CONFIG)],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if done.returncode:
        raise project.Failed(f"MkDocs refuses the pages:\n{done.stdout.rstrip()}")
    index = (SITE / "search" / "search_index.json").read_text(encoding="utf-8")
    # As a script too: a page that is opened as a file may not request the data.
    text = f"var searchIndex = {json.dumps(json.loads(index), separators=(',', ':'))};\n"
    (SITE / "search" / "search_index.js").write_text(text, encoding="utf-8")
    return SITE / "index.html"
