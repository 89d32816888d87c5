# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of an experiment in a headless Chromium: that it draws every variant and curve, needs no
network, complains of nothing, does what a click or a key asks, and gives the documents their
drawings."""

import base64
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

from dynrt_tools.experiments import drawing, error, hardware, hardware_test, page, page_testing
from dynrt_tools.project import Json

PNG = base64.b64decode(  # one pixel
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAA"
    "AABJRU5ErkJggg=="
)
# Of each variant what it differs by, its LUTs, clocks, and its errors.
VARIANTS: Json = {
    "m8": ({"mantissa_bits": 8}, 100, 1000, (4, 1e-2, 12.5, 20.1)),
    "m12": ({"mantissa_bits": 12}, 150, 1100, (1, 1e-3, 1.5, 40.2)),
    "m16": ({}, 200, 1200, (0, 1e-5, 0.25, 60.3)),
    "m23": ({"mantissa_bits": 23}, 300, 1300, (0, 1e-7, 0, None)),
    "m12_truncate": (
        {"mantissa_bits": 12, "rounding": "truncate"},
        160,
        1150,
        (2, 2e-3, 3.0, 35.0),
    ),
}


def kept() -> Json:
    """Of two scenes; a variant is refused."""
    rows: list[Json] = []
    for scene in ("a", "b"):
        for name, (differs, luts, clocks, (missed, t, rms, psnr)) in VARIANTS.items():
            clock = 8.5 if luts < 200 else 10.0
            row = {"scene": scene, "variant": name, "differs": differs, "LUT": luts, "FF": 5 * luts}
            row |= {"clock_ns": clock, "clocks": clocks, "frame_ms": clocks * clock / 1e6}
            row |= {"primary.missed": missed, "primary.t_median": t, "image.rms": rms}
            rows.append({**row, "image.differ": 0 if psnr is None else 3, "image.psnr": psnr})
        refused = "exponent_bits 5 cannot hold x = 70000"
        differs = {"exponent_bits": 5}
        rows.append(
            {
                "scene": scene,
                "variant": "m16_e5",
                "differs": differs,
                "refused": refused,
                "clock_ns": None,
            }
        )
    about = {"a": {"about": "a </script> scene"}, "b": {"about": "another"}}
    return {
        "size": "4x3",
        "device": "Lattice ECP5",
        "reference": "m16",
        "scenes": about,
        "rows": rows,
    }


class Scatter(page_testing.Opened):
    """Variants over time and area."""

    def shown(self) -> Json:
        data = error.shown(kept())
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "one.png").write_bytes(PNG)
            runs = [{"image": "one.png", "difference": "one.png"} for _ in data["rows"]]
            scenes = {name: {"truth": "one.png"} for name in data["scenes"]}
            found = error.with_pictures(
                data, {"scenes": scenes, "runs": runs}, pathlib.Path(folder)
            )
        for name in found["scenes"]:
            found["scenes"][name]["truth"] = "one.png"
        return found

    def test_every_variant_and_the_front(self) -> None:
        elements, _ = self.open_text(page.page(self.shown()))
        points = [e[1]["data-variant"] for e in elements.of("circle", class_="point")]
        self.assertEqual(points, 2 * list(VARIANTS))
        front = [e[1]["data-variant"] for e in elements.of("circle", class_="on-front")]
        self.assertEqual(front, 2 * ["m8", "m12", "m16", "m23"])
        rows = [e[1]["data-variant"] for e in elements.of("tr") if "data-variant" in e[1]]
        self.assertEqual(rows, 2 * [*VARIANTS, "m16_e5"])
        self.assertIn("exponent_bits 5 cannot hold x = 70000", [e[2] for e in elements.of("td")])
        absent = [e[2] for e in elements.of("figcaption") if "m16_e5" in e[2]]
        self.assertEqual(len(absent), 2)
        self.assertIn("a </script> scene", elements.by_id("scene-about")[2])
        self.assertIn("; clocks of 8.5 to 10 ns; ", elements.by_id("about")[2])
        for picture in ("image", "truth", "difference"):
            self.assertTrue(elements.by_id(picture)[1]["src"].startswith("data:image/png;base64,"))

    def test_would_tell_of_a_request(self) -> None:
        probe = "fetch('http://dynrt.example/x.json').catch(() => 0);"
        with self.assertRaisesRegex(AssertionError, "Content Security Policy"):
            self.open_text(page.page(self.shown()), probe=probe)

    def test_an_address_is_a_view(self) -> None:
        view = "scene=b&y=image.psnr&x0=clocks&x1=FF&variant=m8&sort=image.rms+down"
        elements, found = self.open_text(
            page.page(self.shown()),
            view,
            "found.rows = [...document.querySelectorAll('#table tbody tr')]"
            ".map((r) => r.dataset.variant);",
        )
        titles = [e[2] for e in elements.of("text", class_="title")]
        for start in ("↑ better: image psnr, dB", "time clocks", "area FF"):
            self.assertTrue(any(t.startswith(start) for t in titles), titles)
        self.assertEqual(found["rows"][::2], ["m8", "m12_truncate", "m12", "m16", "m23", "m16_e5"])
        # The most decibels are best, and identical pictures better than any.
        front = [e[1]["data-variant"] for e in elements.of("circle", class_="on-front")]
        self.assertEqual(front, 2 * ["m8", "m12", "m16", "m23"])
        self.assertIn("identical", [e[2] for e in elements.of("td")])
        self.assertIn("mantissa bits 8", elements.by_id("differs")[2])

    def test_does_what_a_click_asks(self) -> None:
        _, found = self.open_text(
            page.page(self.shown()),
            probe="""
            click('circle[data-variant="m12"]');
            found.chosen = document.getElementById("variant").value;
            found.address = location.hash;
            click('tbody tr[data-variant="m23"]');
            found.row = document.getElementById("variant").value;
            const column = [...document.querySelectorAll("thead button")]
                .findIndex((b) => b.textContent === "missed");
            const header = () => document.querySelectorAll("thead button")[column];
            header().click();
            found.up = [...document.querySelectorAll("tbody tr")].map((r) => r.dataset.variant);
            const point = document.querySelector('circle[data-variant="m8"]');
            point.dispatchEvent(new MouseEvent("mouseenter"));
            found.tip = document.getElementById("tip").innerText;
            point.dispatchEvent(new MouseEvent("mouseleave"));
            found.hidden = document.getElementById("tip").hidden;
            const chooser = document.getElementById("y");
            found.choices = [...chooser.options].map((o) => o.value);
            chooser.value = "primary.t_median";
            chooser.dispatchEvent(new Event("change"));
            found.meaning = document.getElementById("meaning").textContent;
            """,
        )
        self.assertEqual((found["chosen"], found["row"]), ("m12", "m23"))
        self.assertIn("variant=m12", found["address"])
        self.assertEqual(found["up"][:4], ["m16", "m23", "m16", "m23"])
        for part in ("m8", "mantissa bits 8", "1,000", "time clock, ns\t8.5", "LUT"):
            self.assertIn(part, found["tip"])
        self.assertTrue(found["hidden"])
        self.assertEqual(
            found["choices"],
            ["primary.missed", "primary.t_median", "image.differ", "image.psnr", "image.rms"],
        )
        self.assertIn("relative error of the distance", found["meaning"])

    def test_where_every_run_was_refused_the_reasons_are_there(self) -> None:
        data = kept()
        data["rows"] = [row for row in data["rows"] if "refused" in row]
        elements, _ = self.open_text(page.page(error.shown(data, ["blocks, m8: it failed"])))
        self.assertIn("No run gives an error", elements.by_id("meaning")[2])
        self.assertIn("exponent_bits 5 cannot hold x = 70000", [e[2] for e in elements.of("td")])
        self.assertIn("blocks, m8: it failed", [e[2] for e in elements.of("li")])

    def test_the_drawing_is_the_pages(self) -> None:
        one = kept()
        one["scenes"].pop("b")
        one["rows"] = [row for row in one["rows"] if row["scene"] == "a"]
        text = drawing.drawings(error.shown(one))["error.svg"]
        picture = xml.etree.ElementTree.fromstring(text)
        names = [e.get("data-variant") for e in picture.iter() if e.get("data-variant")]
        self.assertEqual(names, 2 * list(VARIANTS))
        for part in (
            "svg .front {",
            "prefers-color-scheme: dark",
            "area LUT",
            ">How wrong and how fast: 4x3",
        ):
            self.assertIn(part, text)


class Curves(page_testing.Opened):
    """The thesis's figures."""

    report: Json

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.report = hardware_test.report(folder)

    def test_every_curve_and_the_thesis(self) -> None:
        row = {
            "scene": "lamps",
            "configuration": "wide",
            "addition": "four ways, not two",
            "QHW with": None,
        }
        data = {
            **self.report,
            "additions": [row | {"frame rate gained": 12.5}],
            "missing": ["a walk"],
        }
        elements, found = self.open_text(
            page.page(hardware.shown(data)),
            probe="""
            found.curves = {};
            for (const section of document.querySelectorAll("[data-figure]")) {
              found.curves[section.dataset.figure] = section.querySelectorAll(".curve").length;
            }
            found.marks = [...document.querySelectorAll(".thesis")]
                .map((m) => m.closest("section").dataset.figure);
            found.missing = document.getElementById("missing").innerText;
            found.scatter = document.getElementById("scatter").hidden;
            found.pictures = document.getElementById("shown").hidden;
            """,
        )
        # Hit rates of three caches in two orders; four units.
        curves = {"7.5 and 7.10": 6, "7.6": 1, "7.7": 1, "7.8": 4, "7.9": 1, "7.11": 1, "7.12": 1}
        self.assertEqual(found["curves"], curves)
        # Of cistern the text gives the best index and a range of frame rates.
        self.assertEqual(found["marks"], ["7.6", "7.9"])
        self.assertIn("a walk", found["missing"])
        self.assertEqual((found["scatter"], found["pictures"]), (True, True))
        labels = [e[1].get("aria-label", "") for e in elements.of("circle", class_="point")]
        self.assertIn("wide: 21.05 rays a clock per million gates at 4 packets", labels)
        self.assertIn("wide: 2,361 frames per second at 127.5 MB/s of memory bandwidth", labels)
        cells = [e[2] for e in elements.of("td")]
        for word in ("narrow", "17 to 25", "487,020 + 56,028 P + 996 CL", "about 9.5", "12.5"):
            self.assertIn(word, cells)

    def test_without_a_mouse(self) -> None:
        _, found = self.open_text(
            page.page(hardware.shown(self.report)),
            probe="""
            const plot = document.querySelector('[data-figure="7.8"] svg');
            found.stops = plot.querySelectorAll('[tabindex="0"]').length;
            const press = (key) => document.activeElement.dispatchEvent(
                new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
            const at = () => document.activeElement.getAttribute("aria-label");
            plot.querySelector('[tabindex="0"]').focus();
            found.went = [at()];
            for (const key of ["ArrowRight", "ArrowDown", "ArrowLeft"]) {
              press(key);
              found.went.push(at());
            }
            found.tip = document.getElementById("tip").innerText;
            found.still = plot.querySelectorAll('[tabindex="0"]').length;
            """,
        )
        self.assertEqual((found["stops"], found["still"]), (1, 1))
        self.assertEqual(
            found["went"],
            [
                "wide, traversal: 10 % at 1 packets",
                "wide, traversal: 20 % at 2 packets",
                "wide, list: 5 % at 2 packets",
                "wide, list: 2.5 % at 1 packets",
            ],
        )
        self.assertIn("wide, list", found["tip"])

    def test_what_no_frame_gives_is_not_mentioned(self) -> None:
        runs = [{k: v for k, v in run.items() if k != "QHW"} for run in self.report["runs"]]
        found = hardware.shown({**self.report, "runs": runs})
        self.assertNotIn("7.6", [figure["name"] for figure in found["figures"]])

    def test_every_figure_is_a_drawing(self) -> None:
        files = drawing.drawings(hardware.shown(self.report))
        self.assertEqual(
            sorted(files)[:3], ["figure_7_11.svg", "figure_7_12.svg", "figure_7_5_and_7_10.svg"]
        )
        self.assertEqual(len(files), 7)
        for text in files.values():
            xml.etree.ElementTree.fromstring(text)
        self.assertIn("MB/s of memory bandwidth", files["figure_7_11.svg"])
        self.assertEqual(files["figure_7_8.svg"].count('class="curve"'), 8)


class Measures(unittest.TestCase):
    def test_they_are_those_of_the_document(self) -> None:
        known = page.read_measures()
        self.assertIn(
            ("image", "psnr", "dB", "more"),
            [(m["group"], m["name"], m["unit"], m["better"]) for m in known],
        )
        self.assertGreater(len(known), 30)
        for measure in known:
            self.assertIn(measure["better"], ("less", "more", "-"), measure)


if __name__ == "__main__":
    unittest.main()
