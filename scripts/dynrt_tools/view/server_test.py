# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The server of dynrt view: requests that are no page's, and how the program ends.

Usage: server_test.py PROGRAM"""

import http.client
import json
import os
import signal
import subprocess
import time
import unittest
import urllib.parse
from typing import Any, ClassVar

from dynrt_tools import project, testing
from dynrt_tools.view import window_testing
from dynrt_tools.view.window import Program
from dynrt_tools.view.window_testing import JSON_TYPE, SCENE, SIZE, dynrt, request


class Requests(unittest.TestCase):
    program: ClassVar[Program]

    @classmethod
    def setUpClass(cls) -> None:
        cls.program = cls.enterClassContext(Program(dynrt(), SCENE, "--size", SIZE))

    def ask(self, body: str, **headers: str) -> tuple[int, bytes, str]:
        return request(self.program, "POST", "/ask", body, **{"Content_Type": JSON_TYPE, **headers})

    def test_gives_the_page_and_no_other_file(self) -> None:
        status, page, _ = request(self.program, "GET", "/")
        self.assertEqual(status, 200)
        self.assertIn(b"<!doctype html>", page)
        for path in (
            "/../view.cpp",
            "/%2e%2e/view.cpp",
            "/etc/passwd",
            "//etc/passwd",
            "/main.js/",
        ):
            self.assertEqual(request(self.program, "GET", path)[0], 404, path)

    def test_refuses_other_pages(self) -> None:
        own = self.program.address.rstrip("/")
        start = json.dumps({"type": "start"})
        self.assertEqual(self.ask(start, Origin=own)[0], 200)
        for headers in (
            {"Origin": "http://dynrt.example"},
            {"Origin": "null"},
            {"Host": "dynrt.example"},
            {"Sec_Fetch_Site": "cross-site"},
        ):
            self.assertEqual(self.ask(start, **headers)[0], 403, headers)
            self.assertEqual(request(self.program, "GET", "/", **headers)[0], 403, headers)
        self.assertEqual(self.ask(start, Content_Type="text/plain")[0], 400)

    def test_refuses_what_is_no_message_and_goes_on(self) -> None:
        frame: project.Json = {
            "type": "frame",
            "position": [0, 0, 5],
            "look_at": [0, 0, 0],
            "up": [0, 1, 0],
            "field_of_view": 40,
            "time": 0,
            "width": 8,
            "height": 8,
            "moving": False,
        }
        broken: list[Any] = [
            "",
            "{",
            "[]",
            "3",
            "{}",
            '{"type": 3}',
            '{"type": "format the disk"}',
            '{"type": "frame"}',
            "{" * 100000,
        ]
        wrong: list[Any] = [None, "x", []]
        broken += [json.dumps({**frame, name: value}) for name in frame for value in wrong]
        broken += [json.dumps({**frame, "position": [1, 2]}), json.dumps({**frame, "width": -8})]
        for body in broken:
            status, content, connection = self.ask(body)
            self.assertEqual((status, connection), (400, "close"), body[:80])
            self.assertIn("no message of the window", json.loads(content)["error"])
        mistaken: list[project.Json] = [
            {"width": 0},
            {"width": 5000},
            {"look_at": [0, 0, 5]},
            {"field_of_view": 0},
        ]
        for change in mistaken:
            status, content, _ = self.ask(json.dumps({**frame, **change}))
            self.assertEqual(status, 422, change)
            self.assertTrue(json.loads(content)["error"])
        self.assertEqual(self.ask(json.dumps(frame))[0], 200)

    def test_takes_the_next_port_if_one_is_in_use(self) -> None:
        port = urllib.parse.urlsplit(self.program.address).port
        with Program(dynrt(), SCENE, "--size", SIZE, "--port", str(port)) as second:
            other = urllib.parse.urlsplit(second.address).port
            self.assertNotEqual(port, other)
            self.assertIn(f"port        {port} is in use; took {other}", second.lines)


class Ends(unittest.TestCase):
    def test_ends_at_once_while_it_renders(self) -> None:
        for end in (signal.SIGINT, signal.SIGTERM):
            with Program(dynrt(), "office", "--size", "512x384") as program:
                start = json.loads(
                    request(
                        program,
                        "POST",
                        "/ask",
                        '{"type": "start"}',
                        Content_Type=JSON_TYPE,
                    )[
                        1
                    ][4:]
                )
                body = {
                    "type": "frame",
                    **start["first"],
                    "width": 680,
                    "height": 512,
                    "moving": False,
                }
                place = urllib.parse.urlsplit(program.address).netloc
                connection = http.client.HTTPConnection(place, timeout=60)
                connection.request("POST", "/ask", json.dumps(body), {"Content-Type": JSON_TYPE})
                time.sleep(0.1)
                program.process.send_signal(end)
                self.assertEqual(program.process.wait(10), 0)
                # It has not waited for the frame.
                with self.assertRaises(ConnectionResetError):
                    connection.getresponse()
                connection.close()

    def test_a_bad_scene_or_port_ends_the_program(self) -> None:
        for arguments, sentence in (
            (["no_such_scene"], "no_such_scene"),
            ([SCENE, "--port", "0"], "--port 0: a port is a number from 1 to 65535"),
            ([SCENE, "--size", "9999x1"], "size"),
        ):
            ended = subprocess.run(
                [dynrt(), "view", *arguments, "--no-browser"],
                capture_output=True,
                text=True,
                timeout=60,
                check=False,
            )
            self.assertEqual(ended.returncode, 2, ended.stderr)
            self.assertIn(sentence, ended.stderr)


class Trees(testing.InFolder):
    def kept(self) -> dict[str, int]:
        """The kept trees, with the time when each was written."""
        return {p.name: p.stat().st_mtime_ns for p in self.folder.glob("trees/*")}

    def look(self) -> None:
        with Program(dynrt(), SCENE, "--size", SIZE, cache=self.folder) as program:
            headers = {"Content_Type": JSON_TYPE}
            start = request(program, "POST", "/ask", '{"type": "start"}', **headers)
            self.assertEqual(start[0], 200)

    def test_are_kept_for_the_next_run(self) -> None:
        self.look()
        first = self.kept()
        self.assertGreater(len(first), 0)
        self.look()
        self.assertEqual(self.kept(), first)


class NoBrowser(unittest.TestCase):
    def test_the_address_is_printed(self) -> None:
        with subprocess.Popen(
            [dynrt(), "view", SCENE, "--size", SIZE],
            env={**os.environ, "PATH": "/nonexistent", "DYNRT_CACHE": "/nonexistent"},
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            assert process.stdout
            line = process.stdout.readline()
            if line.startswith("port "):  # the window of another test has the first
                line = process.stdout.readline()
            self.assertRegex(line, r"^window +http://127\.0\.0\.1:\d+/$")
            self.assertIn("open the address in one", process.stdout.readline())
            process.terminate()
            self.assertEqual(process.wait(10), 0)


if __name__ == "__main__":
    window_testing.main()
