# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A page as a headless Chromium has it, without a network."""

import pathlib
import subprocess
import tempfile


def load(path: pathlib.Path, view: str = "") -> tuple[str, list[str]]:
    """The document after its scripts have run, and the messages on the console. `view` is the part
    of the address behind "#"."""
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.run(
            [
                "chromium",
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--no-first-run",
                "--host-resolver-rules=MAP * ~NOTFOUND",
                "--enable-logging=stderr",
                f"--user-data-dir={profile}",
                "--dump-dom",
                path.absolute().as_uri() + (f"#{view}" if view else ""),
            ],
            capture_output=True,
            text=True,
            timeout=300,
            check=True,
        )
    return browser.stdout, [line for line in browser.stderr.splitlines() if "CONSOLE" in line]
