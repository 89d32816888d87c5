# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds the site: each page is in the menu, no link is broken, no page needs a network."""

import html.parser
import pathlib
import re
import socket
import threading
import time
import unittest
import unittest.mock
import urllib.error
import urllib.parse
import urllib.request

from dynrt_tools import project
from dynrt_tools.docs import links, main, site

LOADED = {"script": "src", "img": "src", "iframe": "src"}
NOT_LOADED = {"canonical", "next", "prev", "alternate"}


class Page(html.parser.HTMLParser):
    """The links of a page, what it loads, and the places in it."""

    def __init__(self, path: pathlib.Path):
        super().__init__()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attrs}
        self.places |= {values[name] for name in ("id", "name") if name in values}
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        elif tag == "link" and values.get("rel") not in NOT_LOADED:
            self.loads.append(values["href"])
        elif tag in LOADED and LOADED[tag] in values:
            self.loads.append(values[LOADED[tag]])


class Site(unittest.TestCase):
    """The site as a reader gets it."""

    pages: dict[pathlib.Path, Page]

    @classmethod
    def setUpClass(cls) -> None:
        site.build()
        cls.pages = {path: Page(path) for path in site.SITE.rglob("*.html")}

    def target(self, page: pathlib.Path, link: str) -> pathlib.Path:
        return (page.parent / urllib.parse.unquote(link.partition("#")[0] or page.name)).resolve()

    def test_there_are_pages(self) -> None:
        self.assertGreater(len(self.pages), 40)

    def test_nothing_is_loaded_from_a_network(self) -> None:
        for page, found in self.pages.items():
            for load in found.loads:
                self.assertNotRegex(load, "^(https?:)?//", page)

    def test_no_link_is_broken(self) -> None:
        for page, found in self.pages.items():
            if page.name == "404.html":  # its links are absolute: it is for servers
                continue
            for link in found.links + found.loads:
                if re.match(r"(\w+:|//)", link):
                    continue
                aim = self.target(page, link)
                self.assertTrue(aim.exists(), f"{page}: {link}")
                anchor = urllib.parse.unquote(link.partition("#")[2])
                if anchor and aim in self.pages:
                    self.assertIn(anchor, self.pages[aim].places, f"{page}: {link}")

    def test_every_page_is_in_the_menu(self) -> None:
        menu = site.CONFIG.read_text(encoding="utf-8")
        outside = {"README.md", "docs/index.md"}  # the home page stands for both
        for page in links.pages(project.ROOT):
            name = str(page.relative_to(project.ROOT))
            if name not in outside:
                self.assertIn(f": {name}\n", menu)

    def test_the_search_has_every_unit(self) -> None:
        index = (site.SITE / "search" / "search_index.js").read_text(encoding="utf-8")
        self.assertTrue(index.startswith("var searchIndex = {"))
        self.assertIn("packet_decision", index)

    def test_it_is_served(self) -> None:
        with socket.socket() as found:
            found.bind(("localhost", 0))
            port = found.getsockname()[1]
        with unittest.mock.patch.object(main, "PORT", port):
            threading.Thread(target=main.serve, args=(site.SITE,), daemon=True).start()
            for _ in range(100):
                try:
                    with urllib.request.urlopen(f"http://localhost:{port}/") as answer:
                        self.assertEqual(answer.read(), (site.SITE / "index.html").read_bytes())
                    return
                except urllib.error.URLError:
                    time.sleep(0.1)
        self.fail("the site is not served")


if __name__ == "__main__":
    unittest.main()
