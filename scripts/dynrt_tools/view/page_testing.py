# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the page of dynrt view share: a window with a browser before it, and what a
reader does there."""

import json
import pathlib
import shlex
import subprocess
import tempfile
import unittest
from typing import Any, ClassVar

from dynrt_tools import project
from dynrt_tools.view.window import Browser, Program
from dynrt_tools.view.window_testing import JSON_TYPE, SCENE, SIZE, dynrt, request


class PageTest(unittest.TestCase):
    """One window for all tests of a class, a browser for each. Every test ends with a look at the
    console, which must be empty, and at what the page has asked for."""

    program: ClassVar[Program]
    browser: Browser

    @classmethod
    def setUpClass(cls) -> None:
        cls.program = cls.enterClassContext(Program(dynrt(), SCENE, "--size", SIZE))

    def setUp(self) -> None:
        self.browser = self.enterContext(Browser())
        self.open()

    def open(self, view: str = "") -> None:
        self.browser.open("about:blank")
        self.browser.open(self.program.address + view)
        self.still()

    def tearDown(self) -> None:
        self.browser.gather()
        self.assertEqual(self.browser.complaints, [])
        self.assertTrue(self.browser.asked)
        for address in self.browser.asked:
            own = (self.program.address, "data:", "blob:", "about:blank")
            self.assertTrue(address.startswith(own), address)

    def still(self) -> None:
        """Waits for a whole frame that was watched."""
        self.browser.wait(
            "document.getElementById('stage').dataset.state === 'still' && "
            "!document.getElementById('stage').dataset.choosing && "
            "document.getElementById('stage').dataset.watched"
        )

    def move(self, act: Any) -> None:
        """Performs actions that move the view, and waits for the whole frame after them. A busy
        browser may draw no coarse frame between the two."""
        number = self.browser.run("return document.getElementById('stage').dataset.number")
        act.perform()
        self.browser.wait(f"document.getElementById('stage').dataset.number > {number}")
        self.still()

    def picture(self, name: str = "picture") -> str:
        shown: str = self.browser.run(f"return document.getElementById('{name}').toDataURL()")
        return shown

    def text(self, name: str) -> str:
        shown: str = self.browser.run(f"return document.getElementById('{name}').textContent")
        return shown

    def click_pixel(self, x: int, y: int) -> None:
        """A click in the middle of a pixel."""
        stage = self.browser.driver.find_element("id", "stage")
        width, height = map(int, SIZE.split("x"))
        box = stage.rect
        place = (
            round((x + 0.5) / width * box["width"] - box["width"] / 2),
            round((y + 0.5) / height * box["height"] - box["height"] / 2),
        )
        self.browser.actions().move_to_element_with_offset(stage, *place).click().perform()
        self.browser.wait(f"document.getElementById('panel-pixel').dataset.pixel === '{x},{y}'")
        self.browser.wait("document.getElementById('way')")

    def ask(self, kind: str, **fields: object) -> tuple[project.Json, bytes]:
        """The program's answer to a question of the page about the frame that stands: JSON, and
        what lies behind it."""
        fields["number"] = int(
            self.browser.run("return document.getElementById('stage').dataset.number")
        )
        status, content, _ = request(
            self.program,
            "POST",
            "/ask",
            json.dumps({"type": kind, **fields}),
            Content_Type=JSON_TYPE,
        )
        self.assertEqual(status, 200, content)
        length = int.from_bytes(content[:4], "little")
        return json.loads(content[4 : 4 + length]), content[4 + length :]

    def run_command(self, folder: pathlib.Path) -> None:
        """Runs the command that the page shows, by itself."""
        words = shlex.split(self.text("command"))
        self.assertEqual(words[0], "dynrt")
        subprocess.run([dynrt(), *words[1:]], cwd=folder, check=True, capture_output=True)

    def rendered(self) -> project.Json:
        """The report of that command."""
        with tempfile.TemporaryDirectory() as folder:
            self.run_command(pathlib.Path(folder))
            return dict(project.read_json(pathlib.Path(folder) / "pixel.json"))
