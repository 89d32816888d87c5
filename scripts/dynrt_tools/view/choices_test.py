# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Choices in the window of dynrt view that need a configuration which is not built in. With a new
number format the picture comes first, then the clocks, the same as the program counts without a
window. Lights, mirrors and bounces change the picture.

Usage: choices_test.py PROGRAM"""

import os
import pathlib
import subprocess
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.view import window_testing
from dynrt_tools.view.window import Browser, Program
from dynrt_tools.view.window_testing import SCENE, SIZE, dynrt

CONFIGURATION, BITS = "thesis", 11
BUILDS = 1200  # seconds that a build may take
WATCHED = "document.getElementById('stage').dataset.watched"
CHOOSING = "document.getElementById('stage').dataset.choosing"
PICTURE = "return document.getElementById('picture').toDataURL()"


def counted(folder: pathlib.Path) -> int:
    """The clocks of the scene's frame, by the schedules of a configuration of that format."""
    file = folder / f"{CONFIGURATION}_m{BITS}.json"
    cache = {**os.environ, "DYNRT_CACHE": str(folder)}  # that of the window
    project.write_json(file, {"like": CONFIGURATION, "mantissa_bits": BITS})
    made = subprocess.run(
        [project.ROOT / "scripts/configuration", file, "--verilog", "--build", dynrt().parent],
        check=True,
        capture_output=True,
        text=True,
        env=cache,
    )
    report = folder / "report.json"
    subprocess.run(
        [
            *(dynrt(), "render", SCENE, "--board", "model", "--size", SIZE, "--config", file),
            *("--schedule", made.stdout.strip(), "--json", report),
        ],
        cwd=folder,
        check=True,
        capture_output=True,
        env=cache,
    )
    return int(project.read_json(report)["frame"]["cycles"])


class Format(unittest.TestCase):
    def test_shows_its_bits_and_then_its_clocks(self) -> None:
        with (
            tempfile.TemporaryDirectory() as folder,
            Program(
                dynrt(),
                SCENE,
                "--size",
                SIZE,
                "--config",
                CONFIGURATION,
                cache=pathlib.Path(folder),
            ) as program,
            Browser() as browser,
        ):
            browser.open(program.address)
            browser.wait(WATCHED)
            before = browser.run(PICTURE)
            browser.set("choice-mantissa_bits", BITS)
            browser.wait(f"location.hash.includes('mantissa_bits={BITS}') && {WATCHED}", BUILDS)
            clocks = "document.getElementById('clocks').textContent"
            browser.wait(f"{clocks}.includes('its clocks come with the units of {CONFIGURATION}')")
            self.assertNotEqual(browser.run(PICTURE), before)
            self.assertNotIn(
                "the core", browser.run("return document.getElementById('speed').textContent")
            )
            speed = "document.getElementById('core-speed').textContent"
            browser.wait(f"{speed}.includes('frames/s')", BUILDS)
            self.assertIn(
                f"{counted(pathlib.Path(folder)):,} clocks", browser.run(f"return {speed}")
            )
            self.assertEqual(browser.run(f"return {clocks}"), "")
            browser.gather()
            self.assertEqual(browser.complaints, [])


class Light(unittest.TestCase):
    def test_lights_mirrors_and_bounces_change_the_picture(self) -> None:
        with (
            Program(dynrt(), "lamps", "--size", SIZE, "--config", "whitted") as program,
            Browser() as browser,
        ):
            browser.open(program.address)
            browser.wait(WATCHED, BUILDS)
            seen = {browser.run(PICTURE)}
            materials = browser.run("return document.querySelector('details p').textContent")
            for name, value, told in (
                ("lights", "0,3,2", "lights=0,3,2"),
                ("mirrors", f"{materials.split(',')[0]}=0.8", "mirrors="),
                ("reflections", 0, "reflections=0"),
                ("lines", 32, "lines=32"),
            ):
                browser.set(f"choice-{name}", value)
                browser.wait(f"location.hash.includes('{told}') && !{CHOOSING} && {WATCHED}")
                self.assertEqual(
                    browser.run("return document.getElementById('message').textContent"), ""
                )
                self.assertEqual(
                    browser.run(PICTURE) in seen, name == "lines", "only lines change no pixel"
                )
                seen.add(browser.run(PICTURE))
            browser.gather()
            self.assertEqual(browser.complaints, [])


if __name__ == "__main__":
    window_testing.main()
