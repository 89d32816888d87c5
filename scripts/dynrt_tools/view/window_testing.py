# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of dynrt view share: its program, a small scene, and requests."""

import http.client
import pathlib
import sys
import unittest
import urllib.parse

from dynrt_tools.view.window import Program

SCENE = "blocks"
SIZE = "64x48"
JSON_TYPE = "application/json"


def dynrt() -> pathlib.Path:
    """The first argument of the test's command."""
    return pathlib.Path(sys.argv[1]).resolve()


def main() -> None:
    """Runs the tests of the module that is the command; further arguments are unittest's."""
    unittest.main("__main__", argv=[sys.argv[0], *sys.argv[2:]])


def request(
    window: Program, method: str, path: str, body: str | None = None, **headers: str
) -> tuple[int, bytes, str]:
    """Status, content and the header Connection of the answer."""
    place = urllib.parse.urlsplit(window.address).netloc
    connection = http.client.HTTPConnection(place, timeout=60)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request(method, path, body, named)
    answer = connection.getresponse()
    content = answer.read(), answer.getheader("Connection") or ""
    connection.close()
    return answer.status, *content
