# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of pages share: a page in a headless Chromium, its elements, and that it needs no
network and complains of nothing."""

import html.parser
import json
import pathlib
import tempfile
import unittest
from typing import Any

from dynrt_tools.experiments import browser

# What a test has the page do once it is there; what it finds out goes to an element of its own.
PROBE = """
addEventListener("error", (event) => console.error(event.message));
const found = {};
const asked = () => performance.getEntriesByType("resource").map((entry) => entry.name)
    .filter((name) => !name.startsWith("data:"));
const click = (selector) => document.querySelector(selector)
    .dispatchEvent(new MouseEvent("click", {bubbles: true}));
try { %s } catch (error) { console.error(String(error)); }
const result = document.createElement("pre");
result.id = "found";
result.textContent = JSON.stringify({...found, asked: asked()});
document.body.append(result);
"""


class Elements(html.parser.HTMLParser):
    """Every start tag with its attributes, and the text in it before the next tag."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.all: list[Any] = []  # a list of tag, attributes and text
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.all.append([tag, dict(attrs), ""])

    def handle_data(self, data: str) -> None:
        if self.all:
            self.all[-1][2] = (self.all[-1][2] + data).strip()

    def of(self, tag: str, **attributes: str) -> list[Any]:
        wanted = {key.rstrip("_"): value for key, value in attributes.items()}
        return [
            e
            for e in self.all
            if e[0] == tag
            and all(value in (e[1].get(key) or "").split() for key, value in wanted.items())
        ]

    def by_id(self, name: str) -> Any:
        return next(e for e in self.all if e[1].get("id") == name)


class Opened(unittest.TestCase):
    """A test that opens pages."""

    def open_text(self, text: str, view: str = "", probe: str = "") -> tuple[Elements, Any]:
        """The elements of a page with this text after `probe` ran, and what the probe found."""
        with tempfile.TemporaryDirectory() as folder:
            shown = pathlib.Path(folder) / "shown.html"
            shown.write_text(
                text.replace("</body>", f"<script>{PROBE % probe}</script></body>"),
                encoding="utf-8",
            )
            document, complaints = browser.load(shown, view)
        self.assertEqual(complaints, [])
        elements = Elements(document)
        found = json.loads(elements.by_id("found")[2])
        self.assertEqual(found.pop("asked"), [], "the page asks for something beside itself")
        return elements, found
