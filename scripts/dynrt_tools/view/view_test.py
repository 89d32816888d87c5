# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""dynrt view in a headless Chromium: that one walks, that the page shows what the program computes
without it, needs no network and complains of nothing. And requests that are no page's.

Usage: view_test.py PROGRAM"""

import http.client
import json
import os
import pathlib
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.parse
from collections import Counter
from typing import Any, ClassVar

from dynrt_tools import project
from dynrt_tools.view import pictures
from dynrt_tools.view.window import Browser, Program

PROGRAM = pathlib.Path()
SCENE = "blocks"
SIZE = "64x48"
JSON_TYPE = "application/json"
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
}


def request(
    program: Program, method: str, path: str, body: str | None = None, **headers: str
) -> tuple[int, bytes, str]:
    """Status, content and the header Connection of the answer."""
    place = urllib.parse.urlsplit(program.address).netloc
    connection = http.client.HTTPConnection(place, timeout=60)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request(method, path, body, named)
    answer = connection.getresponse()
    content = answer.read(), answer.getheader("Connection") or ""
    connection.close()
    return answer.status, *content


class Requests(unittest.TestCase):
    program: ClassVar[Program]

    @classmethod
    def setUpClass(cls) -> None:
        cls.program = cls.enterClassContext(Program(PROGRAM, SCENE, "--size", SIZE))

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
        with Program(PROGRAM, SCENE, "--size", SIZE, "--port", str(port)) as second:
            other = urllib.parse.urlsplit(second.address).port
            self.assertNotEqual(port, other)
            self.assertIn(f"port        {port} is in use; took {other}", second.lines)


class Ends(unittest.TestCase):
    def test_ends_at_once_while_it_renders(self) -> None:
        for end in (signal.SIGINT, signal.SIGTERM):
            with Program(PROGRAM, "office", "--size", "512x384") as program:
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
                with self.assertRaises(http.client.RemoteDisconnected):
                    connection.getresponse()
                connection.close()

    def test_a_bad_scene_or_port_ends_the_program(self) -> None:
        for arguments, sentence in (
            (["no_such_scene"], "no_such_scene"),
            ([SCENE, "--port", "0"], "--port 0: a port is a number from 1 to 65535"),
            ([SCENE, "--size", "9999x1"], "size"),
        ):
            ended = subprocess.run(
                [PROGRAM, "view", *arguments, "--no-browser"],
                capture_output=True,
                text=True,
                timeout=60,
                check=False,
            )
            self.assertEqual(ended.returncode, 2, ended.stderr)
            self.assertIn(sentence, ended.stderr)


class NoBrowser(unittest.TestCase):
    def test_the_address_is_printed(self) -> None:
        with subprocess.Popen(
            [PROGRAM, "view", SCENE, "--size", SIZE],
            env={**os.environ, "PATH": "/nonexistent"},
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            assert process.stdout
            self.assertRegex(process.stdout.readline(), r"^window +http://127\.0\.0\.1:\d+/$")
            self.assertIn("open the address in one", process.stdout.readline())
            process.terminate()
            self.assertEqual(process.wait(10), 0)


class Page(unittest.TestCase):
    program: ClassVar[Program]
    browser: Browser

    @classmethod
    def setUpClass(cls) -> None:
        cls.program = cls.enterClassContext(Program(PROGRAM, SCENE, "--size", SIZE))

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

    def rendered(self) -> project.Json:
        """The report of the command that the page shows, run by itself."""
        with tempfile.TemporaryDirectory() as folder:
            words = shlex.split(self.text("command"))
            self.assertEqual(words[0], "dynrt")
            subprocess.run([PROGRAM, *words[1:]], cwd=folder, check=True, capture_output=True)
            return dict(project.read_json(pathlib.Path(folder) / "pixel.json"))

    def test_walks(self) -> None:
        before = self.picture()
        self.assertEqual(
            self.browser.run("return document.getElementById('stage').dataset.size"), SIZE
        )
        for keys in ("w", "arrow"):
            key = "w" if keys == "w" else "\ue014"  # the right arrow
            self.browser.actions().key_down(key).perform()
            self.browser.wait("document.getElementById('stage').dataset.state === 'moving'")
            self.browser.wait("document.getElementById('speed').textContent.includes('a second')")
            self.browser.actions().key_up(key).perform()
            self.still()
            walked = self.picture()
            self.assertNotEqual(before, walked, keys)
            before = walked
        stage = self.browser.driver.find_element("id", "stage")
        self.browser.actions().drag_and_drop_by_offset(stage, 60, 10).perform()
        self.browser.wait("document.getElementById('stage').dataset.state === 'moving'")
        self.still()
        self.assertNotEqual(before, self.picture())
        self.assertRegex(self.text("speed"), r"the core [\d.]+ at [\d.]+ MHz")

    def test_a_pixel_has_the_numbers_of_the_program(self) -> None:
        for x, y in ((30, 20), (0, 0), (63, 47)):
            self.click_pixel(x, y)
            record = self.rendered()["pixel"]
            self.assertEqual((record["x"], record["y"]), (x, y))
            cells = self.browser.run(
                "return [...document.querySelectorAll('#panel-pixel table')[0].rows].slice(1)"
                ".map((row) => [...row.cells].map((cell) => cell.textContent))"
            )
            self.assertEqual([row[0] for row in cells], ["t", "u", "v", "cosine"])
            for row in cells:
                expected = record[row[0]]["bits"] if record["hit"] else "–"
                self.assertEqual(row[2], expected, (x, y))
            self.assertIn(record["colour"], self.text("panel-pixel"))
        self.click_pixel(30, 20)
        answer, _ = self.ask("pixel", x=30, y=20)
        self.assertEqual(answer["truth"]["verdict"], 0)
        self.assertIn("right; the truth is", self.text("verdict"))
        self.assertLess(abs(answer["truth"]["off"]["t"]), 8)

    def test_a_packet_has_its_way(self) -> None:
        self.click_pixel(30, 20)
        answer, _ = self.ask("pixel", x=30, y=20)
        way, packet = answer["way"], answer["packet"]
        count = Counter(step["event"] for step in way)
        self.assertEqual(count["node"], packet["nodes"])
        self.assertEqual(count["triangle"], packet["triangles"])
        self.assertEqual(count["object"], packet["objects"])
        self.assertGreater(count["triangle"], 0)
        self.assertEqual(way[0]["event"], "rays")
        clocks = [step["clock"] for step in way]
        self.assertEqual(clocks, sorted(clocks))
        self.assertLess(clocks[-1], packet["end"] - packet["begin"])
        hit = answer["names"]["primitive"]
        self.assertIn(hit, [s.get("primitive") for s in way if s["event"] == "triangle"])
        self.browser.set("way-step", len(way) - 1)
        drawn = self.browser.run("return document.querySelectorAll('#overlay path').length")
        self.assertEqual(drawn, min(60, sum("box" in s or "corners" in s for s in way)))

    def test_shows_every_map(self) -> None:
        names = self.browser.run(
            "return [...document.getElementById('map-name').options].map((o) => o.value)"
        )
        self.assertGreater(len(names), 8)
        seen = set()
        for name in names[1:]:
            self.browser.set("map-name", name)
            self.browser.wait(f"document.getElementById('map').dataset.name === '{name}'")
            seen.add(self.picture("map"))
            self.assertFalse(self.browser.run("return document.getElementById('legend').hidden"))
            self.assertIn(f"map={name}", self.browser.run("return location.hash"))
        self.assertEqual(len(seen), len(names) - 1, "some maps look alike")
        for split, inset in ((100, "0%"), (25, "75%")):
            self.browser.set("split", split)
            clip = self.browser.run("return document.getElementById('map').style.clipPath")
            self.assertIn(inset, clip)
        self.browser.set("map-name", "")
        self.browser.wait("document.getElementById('map').hidden")

    def test_maps_and_machine_are_what_the_counters_say(self) -> None:
        machine, _ = self.ask("examine")
        self.assertGreater(machine["cycles"], 0)
        units = {unit["name"]: unit for unit in machine["units"]}
        for unit in machine["units"]:
            self.assertEqual(sum(unit["work"]), unit["transactions"], unit["name"])
        answer, _ = self.ask("pixel", x=0, y=0)
        pixels = answer["packet"]["columns"] * answer["packet"]["rows"]
        for name, unit in (("nodes", "node_lookup"), ("misses", None)):
            _, words = self.ask("map", name=name)
            total = sum(struct.unpack(f"<{len(words) // 4}f", words)) / pixels
            misses = sum(cache["misses"] for cache in machine["caches"])
            self.assertEqual(total, units[unit]["transactions"] if unit else misses, name)
        self.browser.click("#tab-machine")
        shown = self.browser.run(
            "return [...document.querySelectorAll('[data-unit]')].map((e) => e.dataset.unit)"
        )
        self.assertEqual(sorted(shown), sorted(units))
        self.assertIn(f"{machine['cycles']:,} clocks", self.text("core-speed"))

    def test_two_pages_of_one_window_do_not_mix(self) -> None:
        self.click_pixel(30, 20)
        with Browser() as other:
            other.open(self.program.address)
            other.wait("document.getElementById('stage').dataset.watched")
            number = other.run("return +document.getElementById('stage').dataset.number")
            first = self.browser.run("return +document.getElementById('stage').dataset.number")
            self.assertGreater(number, first)
            self.browser.set("pixel-x", 31)
            self.browser.wait("!document.getElementById('message').hidden")
            self.assertIn("another page of this window", self.text("message"))
            other.set("choice-packets", 4)
            other.wait("location.hash.includes('packets=4')")
            self.browser.actions().send_keys_to_element(
                self.browser.driver.find_element("id", "stage"), "w"
            ).perform()
            self.browser.wait("location.hash.includes('packets=4')")
            self.assertEqual(
                self.browser.run("return document.getElementById('choice-packets').value"), "4"
            )
            other.set("choice-packets", "")
            other.wait("!location.hash.includes('packets=')")
        self.browser.gather()
        refused = [line for line in self.browser.complaints if "status of 422" in line]
        self.assertEqual(refused, self.browser.complaints)
        self.browser.complaints.clear()

    def test_an_address_is_what_is_seen(self) -> None:
        self.browser.set("choice-packets", 8)
        self.still()
        self.browser.actions().key_down("d").perform()
        self.browser.wait("document.getElementById('stage').dataset.state === 'moving'")
        self.browser.actions().key_up("d").perform()
        self.still()
        self.browser.set("map-name", "normals")
        self.click_pixel(20, 20)
        view = self.browser.run("return location.hash")
        for part in ("packets=8", "map=normals", "pixel=20,20"):
            self.assertIn(part, view)
        picture, machine = self.picture(), self.ask("examine")[0]
        self.assertEqual(machine["packets"], 8)
        self.open()
        self.open(view)
        self.browser.wait("document.getElementById('panel-pixel').dataset.pixel === '20,20'")
        self.assertEqual(self.picture(), picture)
        self.browser.wait("document.getElementById('map').dataset.name === 'normals'")
        self.assertEqual(self.ask("examine")[0]["cycles"], machine["cycles"])

    def test_takes_another_configuration_and_refuses_a_wrong_light(self) -> None:
        before = self.ask("examine")[0]
        self.browser.set("choice-configuration", "thesis")
        self.browser.wait("location.hash.includes('configuration=thesis')")
        self.still()
        after = self.ask("examine")[0]
        self.assertEqual((before["configuration"], after["configuration"]), ("fast", "thesis"))
        self.assertNotEqual(before["cycles"], after["cycles"])
        good = self.picture()
        self.browser.set("choice-lights", "0,5,0")
        self.browser.wait("!document.getElementById('message').hidden")
        self.assertIn("thesis", self.text("message"))
        self.assertEqual(self.picture(), good, "the last good frame stays")
        self.assertEqual(self.ask("examine")[0]["configuration"], "thesis")
        self.browser.set("choice-configuration", "fast")
        self.browser.wait("location.hash.includes('configuration=fast')")
        self.still()
        self.assertTrue(self.browser.run("return document.getElementById('message').hidden"))
        self.browser.gather()
        refusals = [line for line in self.browser.complaints if "status of 422" in line]
        self.assertEqual(refusals, self.browser.complaints)
        self.browser.complaints.clear()

    def test_gives_the_hit_records_and_compares_with_the_rtl(self) -> None:
        text = self.ask("csv")[0]["csv"].splitlines()
        width, height = map(int, SIZE.split("x"))
        self.assertEqual(len(text), 1 + width * height)
        self.click_pixel(30, 20)
        record = self.rendered()["pixel"]
        row = dict(zip(text[0].split(","), text[1 + 20 * width + 30].split(",")))
        self.assertEqual(float(row["t"]), record["t"]["value"])
        self.assertEqual(int(row["triangle"]), record["triangle"])
        self.browser.click("#tab-share")
        self.browser.click("#compare")
        self.browser.wait("document.getElementById('comparison').dataset.state === 'done'")
        self.assertIn(f"identical: {width * height:,} pixels", self.text("comparison"))


class Animation(unittest.TestCase):
    def test_plays_stops_and_steps(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "swing.json"
            scene.write_text(json.dumps(SWING), encoding="utf-8")
            with Program(PROGRAM, str(scene), "--size", SIZE) as program, Browser() as browser:
                browser.open(program.address)
                still = "document.getElementById('stage').dataset.state === 'still'"
                picture = "return document.getElementById('picture').toDataURL()"
                seconds = "return +document.getElementById('time').value"
                browser.wait(still)
                first = browser.run(picture)
                browser.click("#play")
                browser.wait("document.getElementById('stage').dataset.state === 'moving'")
                browser.wait("+document.getElementById('time').value > 0.2")
                browser.click("#play")
                shown = "location.hash.includes('time=' + document.getElementById('time').value)"
                browser.wait(f"{still} && {shown}")
                stopped = browser.run(seconds)
                self.assertNotEqual(browser.run(picture), first)
                browser.click("#step")
                self.assertAlmostEqual(browser.run(seconds), stopped + 0.04, 4)
                browser.set("time", 0)
                browser.wait(f"{still} && location.hash.includes('time=0&')")
                self.assertEqual(browser.run(picture), first)
                browser.gather()
                self.assertEqual(browser.complaints, [])


class Exported(unittest.TestCase):
    def test_opens_from_disk_and_knows_everything(self) -> None:
        with tempfile.TemporaryDirectory() as folder, Browser() as browser:
            file = pathlib.Path(folder) / "blocks.html"
            subprocess.run(
                [PROGRAM, "view", SCENE, "--size", SIZE, "--export", file],
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
            subprocess.run([PROGRAM, *words[1:]], cwd=folder, check=True, capture_output=True)
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
            browser.gather()
            self.assertEqual(browser.complaints, [])
            asked = {address for address in browser.asked if not address.startswith("data:")}
            self.assertEqual(asked, {file.as_uri()})

    def test_refuses_a_picture_that_is_too_large(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "large.html"
            ended = subprocess.run(
                [PROGRAM, "view", SCENE, "--size", "1024x341", "--export", file],
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
            for file in pictures.take(PROGRAM, pathlib.Path(folder), SCENE, SIZE):
                self.assertTrue(file.read_bytes().startswith(b"\x89PNG"), file)


if __name__ == "__main__":
    PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
