# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""dynrt view with a headless Chromium before it, for its test and for the pictures of its page."""

import base64
import json
import os
import pathlib
import subprocess
import tempfile
import time
import types
from typing import Any, Self

from selenium import webdriver
from selenium.webdriver.common import action_chains
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.wait import WebDriverWait

from dynrt_tools.project import Failed

DRIVER = "/usr/bin/chromedriver"  # Debian's chromium-driver
PATIENCE = 120  # seconds, on a machine with much else to do


class Program:
    """dynrt view, until the end of a with statement. It keeps its trees in `cache`, or as long as it
    runs."""

    def __init__(
        self, program: pathlib.Path, *arguments: str, cache: pathlib.Path | None = None
    ) -> None:
        # pylint: disable-next=consider-using-with
        self.own = tempfile.TemporaryDirectory(prefix="dynrt-view-", ignore_cleanup_errors=True)
        self.process = subprocess.Popen(  # pylint: disable=consider-using-with
            [program, "view", *arguments, "--no-browser"],
            env={**os.environ, "DYNRT_CACHE": str(cache or self.own.name)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.lines: list[str] = []
        assert self.process.stdout and self.process.stderr
        for line in self.process.stdout:
            self.lines.append(line.rstrip())
            if line.startswith("window"):
                break
        else:
            raise Failed(f"dynrt view ends at once: {self.process.stderr.read()}")
        self.address = self.lines[-1].split()[1]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        for stream in (self.process.stdout, self.process.stderr):
            assert stream
            stream.close()
        self.own.cleanup()


class Browser:
    """A headless Chromium that finds no other computer, and remembers what its pages ask for."""

    def __init__(self, width: int = 1280, height: int = 800, dark: bool = False) -> None:
        options: Any = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for argument in (
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--no-first-run",
            "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
            f"--window-size={width},{height}",
        ):
            options.add_argument(argument)
        if dark:
            options.add_argument("--force-dark-mode")
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver: Any = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_script_timeout(PATIENCE)
        self.complaints: list[str] = []
        self.asked: list[str] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: types.TracebackType | None,
    ) -> None:
        self.driver.quit()

    def open(self, address: str) -> None:
        self.driver.get(address)

    def wait(self, script: str, patience: float = PATIENCE) -> Any:
        """Until the script gives something true; gives that."""
        waiting = WebDriverWait(self.driver, patience, 0.05)
        return waiting.until(
            lambda driver: driver.execute_script(f"return ({script})"), f"never true: {script}"
        )

    def run(self, script: str, *arguments: Any) -> Any:
        return self.driver.execute_script(script, *arguments)

    def set(self, name: str, value: object) -> None:
        """Gives an input or a list another value, as a reader would."""
        self.run(
            "const e = document.getElementById(arguments[0]); e.value = arguments[1];"
            "e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change'));",
            name,
            str(value),
        )

    def click(self, selector: str) -> None:
        self.driver.find_element("css selector", selector).click()

    def save_into(self, folder: pathlib.Path) -> None:
        """Files that a page saves come into this folder, without a question."""
        self.driver.execute_cdp_cmd(
            "Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder)}
        )

    def saved_by(self, selector: str, folder: pathlib.Path, ending: str) -> pathlib.Path:
        """Clicks a button that saves a file into that folder, and waits for the whole file."""
        before = set(folder.iterdir())
        self.click(selector)
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            for file in set(folder.iterdir()) - before:
                # Chromium holds the name with an empty file until it renames the whole one.
                if file.suffix == ending and file.stat().st_size > 0:
                    return file
            time.sleep(0.05)
        raise Failed(f"{selector} saves no file *{ending}")

    def pixels(self, image: bytes) -> list[int]:
        """The bytes of a PNG image's pixels: red, green, blue and opacity of each, row by row."""
        shown: list[int] = self.driver.execute_async_script(
            """
            const [text, done] = arguments;
            const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
            createImageBitmap(new Blob([bytes]), {colorSpaceConversion: "none"}).then((image) => {
              const canvas = new OffscreenCanvas(image.width, image.height);
              const context = canvas.getContext("2d");
              context.drawImage(image, 0, 0);
              done([...context.getImageData(0, 0, image.width, image.height).data]);
            });""",
            base64.b64encode(image).decode(),
        )
        return shown

    def actions(self) -> Any:
        chains: Any = action_chains.ActionChains
        return chains(self.driver, duration=50)

    def gather(self) -> None:
        """Notes the messages on the console and the addresses asked for since the last time."""
        self.complaints += [entry["message"] for entry in self.driver.get_log("browser")]
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                self.asked.append(message["params"]["request"]["url"])
