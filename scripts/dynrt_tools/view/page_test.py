# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of dynrt view in a headless Chromium: that one walks, that it shows what the program
computes without it, needs no network and complains of nothing.

Usage: page_test.py PROGRAM"""

import struct
from collections import Counter

from dynrt_tools.view import window_testing
from dynrt_tools.view.page_testing import PageTest
from dynrt_tools.view.window import Browser
from dynrt_tools.view.window_testing import SIZE


class Page(PageTest):
    def test_walks(self) -> None:
        before = self.picture()
        self.assertEqual(
            self.browser.run("return document.getElementById('stage').dataset.size"), SIZE
        )
        for keys in ("w", "arrow"):
            key = "w" if keys == "w" else "\ue014"  # the right arrow
            self.browser.actions().key_down(key).perform()
            self.browser.wait("document.getElementById('stage').dataset.state === 'moving'")
            self.browser.wait("document.getElementById('speed').textContent.includes('frames/s')")
            self.browser.actions().key_up(key).perform()
            self.still()
            walked = self.picture()
            self.assertNotEqual(before, walked, keys)
            before = walked
        stage = self.browser.driver.find_element("id", "stage")
        self.move(self.browser.actions().drag_and_drop_by_offset(stage, 60, 10))
        self.assertNotEqual(before, self.picture())
        self.assertRegex(self.text("speed"), r"the core: [\d.]+ frames/s at [\d.]+ MHz")

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
        self.assertIn("right; the true hit is", self.text("verdict"))
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

    def test_tells_what_units_wait_for_and_how_full_fifos_are(self) -> None:
        machine, _ = self.ask("examine")
        clocks = [
            sum(unit["work"]) + sum(sum(wait["clocks"]) for wait in unit["waits"])
            for unit in machine["units"]
        ]
        self.assertEqual(set(clocks), {clocks[0]}, "some unit has more clocks than others")
        self.assertLess(abs(clocks[0] - machine["cycles"]), 100)
        units = {unit["name"]: unit for unit in machine["units"]}
        for unit in machine["units"]:
            for wait in unit["waits"]:
                ends = machine["fifos"][wait["fifo"]]
                self.assertIn(unit["name"], ends["from" if wait["for"] == "space" else "to"], wait)
        inside = [fifo for fifo in machine["fifos"] if fifo["depth"] > 0]
        self.assertGreater(len(inside), len(units))
        for fifo in inside:
            self.assertLessEqual(fifo["most"], fifo["depth"], fifo)
            self.assertLessEqual(fifo["mean"], fifo["most"], fifo)
            self.assertEqual(fifo["mean"] > 0, fifo["tokens"] > 0, fifo)
        self.browser.click("#tab-machine")
        self.assertEqual(
            self.browser.run("return document.getElementById('fifos').rows.length"),
            1 + len(inside),
        )
        self.browser.click('[data-unit="mailbox"]')
        detail = self.text("unit-detail")
        for wait in units["mailbox"]["waits"]:
            self.assertIn(f"{sum(wait['clocks']):,}", detail)
        keys = self.browser.actions().move_to_element(
            self.browser.driver.find_element("id", "timeline")
        )
        keys.click().send_keys("\ue015" * 3).send_keys("\ue014" * 40).perform()  # down, right
        place = self.browser.driver.find_element("id", "timeline-place")
        unit, part = place.get_attribute("data-unit"), int(place.get_attribute("data-part"))
        said = f"works {100 * units[unit]['work'][part] / machine['part_clocks']:.1f} %"
        self.assertLessEqual((part + 1) * machine["part_clocks"], machine["cycles"])
        self.assertIn(said, place.text)

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

    def test_sets_what_was_chosen_beside_what_was_before(self) -> None:
        self.assertTrue(self.browser.run("return document.getElementById('trials').hidden"))
        clocks = [self.ask("examine")[0]["cycles"]]
        self.browser.set("choice-packets", 4)
        self.browser.wait("location.hash.includes('packets=4')")
        self.still()
        clocks.append(self.ask("examine")[0]["cycles"])
        _, words = self.ask("map", name="wrong")
        wrong = len(words) // 4 - struct.unpack(f"<{len(words) // 4}f", words).count(0)
        rows = "[...document.querySelectorAll('#trials tr')].slice(1)"
        self.browser.wait(
            f"{rows}.length === 2 && !{rows}.some((row) => row.cells[1].textContent === '–')"
        )
        cells = self.browser.run(
            f"return {rows}.map((row) => [...row.cells].map((cell) => cell.textContent))"
        )
        self.assertTrue(cells[0][0].startswith("fast"))
        self.assertEqual(cells[1][0], "fast, 4 packets")
        self.assertEqual(cells[0][2], f"{clocks[0]:,}")
        self.assertEqual(cells[1][2], f"{clocks[1]:,} ({100 * clocks[1] / clocks[0]:.1f} %)")
        share = float(cells[1][1].split()[0]) / 100
        self.assertAlmostEqual(share, wrong / (len(words) // 4), 4)
        self.browser.set("choice-packets", "")
        self.browser.wait("!location.hash.includes('packets=')")
        self.still()

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


if __name__ == "__main__":
    window_testing.main()
