# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""dynrt view of a scene that moves, in a file that opens from disk, and in the pictures of its page.

Usage: scenes_test.py PROGRAM"""

import json
import pathlib
import shlex
import subprocess
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.view import pictures, window_testing
from dynrt_tools.view.window import Browser, Program
from dynrt_tools.view.window_testing import SCENE, SIZE, dynrt

# A box that moves aside.
SWING: project.Json = {
    "about": "one that moves",
    "colours": {"red": [0.9, 0.2, 0.1]},
    "objects": [
        {
            "name": "box",
            "parts": [{"generate": "box", "colour": "red", "from": [-1, -1, -1], "to": [1, 1, 1]}],
        }
    ],
    "instances": [
        {
            "object": "box",
            "name": "box",
            "motion": {
                "keys": [
                    {"time": 0, "position": [0, 0, 0]},
                    {"time": 60, "position": [200, 0, 0]},
                ]
            },
        }
    ],
    "camera": {"position": [0, 2, 8], "look_at": [0, 0, 0], "field_of_view": 40},
    "path": [
        {"time": 0, "position": [0, 2, 8], "look_at": [0, 0, 0]},
        {"time": 60, "position": [200, 2, 8], "look_at": [200, 0, 0]},
    ],
}


class Animation(unittest.TestCase):
    def test_plays_stops_and_steps(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "swing.json"
            scene.write_text(json.dumps(SWING), encoding="utf-8")
            with Program(dynrt(), str(scene), "--size", SIZE) as program, Browser() as browser:
                browser.open(program.address)
                still = "document.getElementById('stage').dataset.state === 'still'"
                picture = "return document.getElementById('picture').toDataURL()"
                seconds = "return +document.getElementById('time').dataset.seconds"
                browser.wait(still)
                first = browser.run(picture)
                browser.click("#play")
                browser.wait("document.getElementById('stage').dataset.state === 'moving'")
                browser.wait("+document.getElementById('time').value > 0.2")
                browser.click("#play")
                time = "document.getElementById('time').dataset.seconds"
                browser.wait(f"{still} && location.hash.includes('time=' + {time} + '&')")
                stopped = browser.run(seconds)
                self.assertNotEqual(browser.run(picture), first)
                browser.click("#step")
                self.assertAlmostEqual(browser.run(seconds), stopped + 0.04, 4)
                browser.set("time", 0)
                browser.wait(f"{still} && location.hash.includes('time=0&')")
                self.assertEqual(browser.run(picture), first)
                browser.click("#follow")
                browser.set("time", 30)
                browser.wait(f"{still} && location.hash.includes('time=30&')")
                self.assertIn("#position=100,2,8&", browser.run("return location.hash"))
                browser.gather()
                self.assertEqual(browser.complaints, [])


class Exported(unittest.TestCase):
    def test_opens_from_disk_and_knows_everything(self) -> None:
        with tempfile.TemporaryDirectory() as folder, Browser() as browser:
            file = pathlib.Path(folder) / "blocks.html"
            subprocess.run(
                [dynrt(), "view", SCENE, "--size", SIZE, "--export", file],
                check=True,
                capture_output=True,
            )
            browser.open(file.as_uri())
            browser.wait("document.getElementById('stage').dataset.watched")
            browser.set("map-name", "clocks")
            browser.wait("document.getElementById('map').dataset.name === 'clocks'")
            stage = browser.driver.find_element("id", "stage")
            browser.actions().move_to_element_with_offset(stage, 3, 3).click().perform()
            browser.wait("document.getElementById('way')")
            words = shlex.split(
                browser.run("return document.getElementById('command').textContent")
            )
            subprocess.run([dynrt(), *words[1:]], cwd=folder, check=True, capture_output=True)
            record = project.read_json(pathlib.Path(folder) / "pixel.json")["pixel"]
            self.assertTrue(record["hit"])
            shown = browser.run("return document.getElementById('panel-pixel').textContent")
            for name in ("t", "u", "v", "cosine"):
                self.assertIn(record[name]["bits"], shown)
            browser.set("way-step", 5)
            self.assertGreater(
                browser.run("return document.querySelectorAll('#overlay path').length"), 0
            )
            browser.click("#tab-machine")
            self.assertIn(
                "clocks", browser.run("return document.getElementById('core-speed').textContent")
            )
            browser.click('[data-unit="mailbox"]')
            self.assertIn(
                "waits for a token in",
                browser.run("return document.getElementById('unit-detail').textContent"),
            )
            self.assertGreater(
                browser.run("return document.getElementById('fifos').rows.length"), 40
            )
            self.assertTrue(
                browser.run("return document.querySelector('#timeline image') !== null")
            )
            browser.save_into(pathlib.Path(folder))
            browser.click("#tab-share")
            table = browser.saved_by("#save-csv", pathlib.Path(folder), ".csv")
            rows = [line.split(",") for line in table.read_text(encoding="utf-8").splitlines()]
            width, height = map(int, SIZE.split("x"))
            self.assertEqual(len(rows), 1 + width * height)
            row = dict(zip(rows[0], rows[1 + record["y"] * width + record["x"]]))
            for name in ("t", "u", "v", "cosine"):
                self.assertEqual(float(row[name]), record[name]["value"])
            self.assertEqual(row["colour"], record["colour"])
            browser.gather()
            self.assertEqual(browser.complaints, [])
            asked = {address for address in browser.asked if not address.startswith("data:")}
            self.assertEqual(asked, {file.as_uri()})

    def test_refuses_a_picture_that_is_too_large(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "large.html"
            ended = subprocess.run(
                [dynrt(), "view", SCENE, "--size", "1024x341", "--export", file],
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(ended.returncode, 2)
            self.assertIn("record a smaller picture", ended.stderr)
            self.assertFalse(file.exists())


class Pictures(unittest.TestCase):
    def test_can_be_taken(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for file in pictures.take(dynrt(), pathlib.Path(folder), SCENE, SIZE):
                self.assertTrue(file.read_bytes().startswith(b"\x89PNG"), file)


if __name__ == "__main__":
    window_testing.main()
