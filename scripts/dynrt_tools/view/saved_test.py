# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The files that the page of dynrt view saves, and the command that it shows: each holds what is
seen.

Usage: saved_test.py PROGRAM"""

import base64
import csv
import pathlib
import tempfile

from dynrt_tools.view import window_testing
from dynrt_tools.view.page_testing import PageTest
from dynrt_tools.view.window_testing import SCENE, SIZE

WIDTH, HEIGHT = map(int, SIZE.split("x"))


class Saved(PageTest):
    def setUp(self) -> None:
        super().setUp()
        folder = self.enterContext(tempfile.TemporaryDirectory(prefix="dynrt-saved-"))
        self.folder = pathlib.Path(folder)
        self.browser.save_into(self.folder)

    def save(self, what: str, ending: str) -> pathlib.Path:
        """Presses a button of the panel; the whole file that comes of it."""
        self.browser.click("#tab-share")
        file = self.browser.saved_by(f"#save-{what}", self.folder, ending)
        self.assertTrue(file.name.startswith(f"{SCENE}-"), file)
        return file

    def served(self) -> list[int]:
        """The pixels of the frame that stands, as the program gives them to the page."""
        view = self.browser.run(
            "return Object.fromEntries(new URLSearchParams(location.hash.slice(1)))"
        )
        vectors = {
            name: [float(part) for part in view[name].split(",")]
            for name in ("position", "look_at", "up")
        }
        numbers = {name: float(view[name]) for name in ("field_of_view", "time")}
        _, words = self.ask("frame", **vectors, **numbers, width=WIDTH, height=HEIGHT, moving=False)
        return opaque(words)

    def seen(self, name: str) -> list[int]:
        """The pixels of the picture or the map as it is seen."""
        _, image = self.picture(name).split(",")
        return self.browser.pixels(base64.b64decode(image))

    def test_the_picture_has_the_pixels_that_the_program_served(self) -> None:
        stage = self.browser.driver.find_element("id", "stage")
        self.move(self.browser.actions().send_keys_to_element(stage, "d"))
        pixels = self.browser.pixels(self.save("picture", ".png").read_bytes())
        self.assertEqual(len(pixels), 4 * WIDTH * HEIGHT)
        self.assertEqual(pixels, self.served())
        self.run_command(self.folder)
        self.assertEqual(self.browser.pixels((self.folder / f"{SCENE}.png").read_bytes()), pixels)

    def test_the_map_is_the_one_that_is_seen(self) -> None:
        self.assertFalse(self.browser.driver.find_element("id", "save-map").is_enabled())
        files = []
        for name in ("normals", "clocks"):
            self.browser.set("map-name", name)
            self.browser.wait(f"document.getElementById('map').dataset.name === '{name}'")
            files.append(self.save("map", ".png"))
            self.assertIn(name, files[-1].name)
            pixels = self.browser.pixels(files[-1].read_bytes())
            self.assertEqual(pixels, self.seen("map"))
            self.assertNotEqual(pixels, self.seen("picture"))
        _, words = self.ask("map", name="normals")
        self.assertEqual(self.browser.pixels(files[0].read_bytes()), opaque(words))

    def test_the_table_has_the_numbers_of_the_report(self) -> None:
        with self.save("csv", ".csv").open(encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        places = [(int(row["x"]), int(row["y"])) for row in rows]
        self.assertEqual(places, [(x, y) for y in range(HEIGHT) for x in range(WIDTH)])
        hits = 0
        for x, y in ((30, 20), (0, 0), (17, 33), (63, 47)):
            self.browser.set("pixel-x", x)
            self.browser.set("pixel-y", y)
            self.browser.wait(f"document.getElementById('command').textContent.includes('{x},{y}')")
            record, row = self.rendered()["pixel"], rows[y * WIDTH + x]
            self.assertEqual((record["x"], record["y"]), (x, y))
            self.assertEqual(row["hit"] == "1", record["hit"])
            self.assertEqual(row["colour"], record["colour"])
            hits += record["hit"]
            if not record["hit"]:
                continue
            for name in ("object", "triangle"):
                self.assertEqual(int(row[name]), record[name], name)
            for name in ("t", "u", "v", "cosine"):
                self.assertEqual(float(row[name]), record[name]["value"], name)
        self.assertGreater(hits, 1)
        shown = self.browser.pixels(self.save("picture", ".png").read_bytes())
        colours = [int(row["colour"][1:], 16) for row in rows]
        self.assertEqual(
            [(c >> 16, c >> 8 & 255, c & 255) for c in colours],
            [(shown[i], shown[i + 1], shown[i + 2]) for i in range(0, len(shown), 4)],
        )


def opaque(words: bytes) -> list[int]:
    """Pixels as the program gives them, with full opacity."""
    return [255 if i % 4 == 3 else byte for i, byte in enumerate(words)]


if __name__ == "__main__":
    window_testing.main()
