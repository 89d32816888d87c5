# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Takes the pictures of docs/how-to/view.md: the window of dynrt view in a headless Chromium, with a
pixel's packet and a map, with the machine, and with the timeline of the frame."""

import argparse
import pathlib

from selenium.webdriver.common.keys import Keys

from dynrt_tools.project import ROOT
from dynrt_tools.view.window import Browser, Program

SIZE = (1280, 860)


def take(program: pathlib.Path, folder: pathlib.Path, scene: str, size: str) -> list[pathlib.Path]:
    """The files view.png, view_machine.png and view_timeline.png, in this folder."""
    with Program(program, scene, "--size", size) as window, Browser(*SIZE) as browser:
        browser.open(window.address)
        browser.wait("document.getElementById('stage').dataset.watched")
        stage = browser.driver.find_element("id", "stage")
        browser.actions().move_to_element_with_offset(stage, 40, 40).click().perform()
        browser.wait("document.getElementById('way')")
        middle = browser.run("return Math.floor(document.getElementById('way-step').max / 2)")
        browser.set("way-step", middle)
        browser.set("map-name", "nodes")
        browser.set("split", 40)
        browser.wait("document.getElementById('map').dataset.name === 'nodes'")
        files = [folder / f"view{part}.png" for part in ("", "_machine", "_timeline")]
        browser.driver.save_screenshot(str(files[0]))
        browser.set("map-name", "clocks")
        browser.wait("document.getElementById('map').dataset.name === 'clocks'")
        browser.click("#tab-machine")
        browser.click('[data-unit="matrix_fetch"]')
        browser.driver.save_screenshot(str(files[1]))
        timeline = browser.driver.find_element("id", "timeline")
        place = browser.driver.find_element("id", "timeline-place")
        while place.get_attribute("data-unit") != "matrix_fetch":
            timeline.send_keys(Keys.DOWN)
        timeline.send_keys(Keys.RIGHT * 189)  # where an output FIFO of it is full, in office
        browser.run("document.getElementById('unit-fifos').scrollIntoView()")
        browser.driver.save_screenshot(str(files[2]))
    return files


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/view_pictures", description=__doc__)
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        default=ROOT / "build" / "release",
        metavar="FOLDER",
        help="the build whose program is shown (default: build/release)",
    )
    build = parser.parse_args().build
    for file in take(build / "dynrt", ROOT / "docs" / "pictures", "office", "512x384"):
        print(file)
    return 0
