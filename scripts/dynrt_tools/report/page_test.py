# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of an error report in a headless Chromium: that it draws every variant, needs no
network, complains of nothing and does what a click asks."""

import base64
import json
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree
from typing import Any

from dynrt_tools import project
from dynrt_tools.report import page, page_testing, plot
from dynrt_tools.report.page_testing import Elements

# One pixel.
PNG = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAA"
    "AABJRU5ErkJggg=="
)
REPORT: project.Json = {
    "size": "4x3",
    "device": "Lattice ECP5",
    "reference": "m16",
    "scenes": {
        "a": {"about": "a </script> scene", "truth": "pictures/truth.png"},
        "b": {"about": "another", "truth": "pictures/truth.png"},
    },
    "variants": {
        name: {
            "differs": differs,
            "configuration": {},
            "area": {"LUT": lut, "FF": 5 * lut},
            "schedule": {"stages": 100, "clock_ns": 8.5 if lut < 200 else 10.0},
        }
        for name, differs, lut in (
            ("m8", {"mantissa_bits": 8}, 100),
            ("m12", {"mantissa_bits": 12}, 150),
            ("m16", {}, 200),
            ("m23", {"mantissa_bits": 23}, 300),
            ("m12_truncate", {"mantissa_bits": 12, "rounding": "truncate"}, 160),
            ("m16_e5", {"exponent_bits": 5}, 190),
        )
    },
    "runs": [],
}


def measures(missed: int, t: float, rms: float, psnr: float | None) -> project.Json:
    return {
        "primary": {"rays": 12, "hits": 9, "missed": missed, "double": None, "t_median": t},
        "image": {"pixels": 12, "differ": 0 if psnr is None else 3, "rms": rms, "psnr": psnr},
    }


for scene in ("a", "b"):
    for variant, clocks, figures in (
        ("m8", 1000, (4, 1e-2, 12.5, 20.1)),
        ("m12", 1100, (1, 1e-3, 1.5, 40.2)),
        ("m16", 1200, (0, 1e-5, 0.25, 60.3)),
        ("m23", 1300, (0, 1e-7, 0, None)),
        ("m12_truncate", 1150, (2, 2e-3, 3.0, 35.0)),
    ):
        REPORT["runs"].append(
            {
                "scene": scene,
                "variant": variant,
                "clocks": clocks,
                "frame_ms": clocks * REPORT["variants"][variant]["schedule"]["clock_ns"] / 1e6,
                "image": f"pictures/{variant}.png",
                "difference": f"pictures/{variant}.difference.png",
                "counters": {},
                "seconds": {},
                "measures": measures(*figures),
            }
        )
    REPORT["runs"].append(
        {"scene": scene, "variant": "m16_e5", "refused": "exponent_bits 5 cannot hold x = 70000"}
    )
VARIANTS = list(REPORT["variants"])


class PageTest(page_testing.Opened):
    folder: pathlib.Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (cls.folder / "pictures").mkdir()
        for name in page.pictures_of(REPORT):
            (cls.folder / name).write_bytes(PNG)
        (cls.folder / "error.json").write_text(json.dumps(REPORT), encoding="utf-8")
        page.write_page(cls.folder / "error.json", cls.folder / "error.html")

    def open(self, view: str = "", probe: str = "") -> tuple[Elements, Any]:
        """The page's elements in Chromium after `probe` ran, and what the probe found."""
        return self.open_text((self.folder / "error.html").read_text(encoding="utf-8"), view, probe)

    def points(self, elements: Elements) -> tuple[list[str], list[str]]:
        """Names of the variants of each plot."""
        found = [e[1]["data-variant"] for e in elements.of("circle", class_="point")]
        return found[: len(found) // 2], found[len(found) // 2 :]

    def test_shows_every_variant_and_the_front(self) -> None:
        elements, _ = self.open()
        drawn = [v for v in VARIANTS if v != "m16_e5"]
        self.assertEqual(self.points(elements), (drawn, drawn))
        rows = [e[1]["data-variant"] for e in elements.of("tr") if "data-variant" in e[1]]
        self.assertEqual(rows, VARIANTS)
        self.assertIn("m16_e5", elements.by_id("time-left-out")[2])
        self.assertIn("exponent_bits 5 cannot hold x = 70000", [e[2] for e in elements.of("td")])
        front = [e[1]["data-variant"] for e in elements.of("circle", class_="on-front")]
        self.assertEqual(front, 2 * ["m8", "m12", "m16", "m23"])
        self.assertIn("a </script> scene", elements.by_id("about")[2])
        self.assertIn("; clocks of 8.5 to 10 ns; ", elements.by_id("about")[2])
        for picture in ("image", "truth", "difference"):
            self.assertTrue(elements.by_id(picture)[1]["src"].startswith("data:image/png;base64,"))
        # An error of 0 has no place on a logarithmic axis but one of its own.
        zero = [e for e in elements.of("circle", class_="point") if e[1]["data-variant"] == "m23"][
            0
        ]
        others = [
            float(e[1]["cy"])
            for e in elements.of("circle", class_="point")
            if e[1]["data-variant"] != "m23"
        ]
        self.assertGreater(float(zero[1]["cy"]), max(others) + 10)

    def test_would_tell_of_a_request(self) -> None:
        for probe in (
            "document.getElementById('image').src = 'http://dynrt.example/x.png';",
            "fetch('http://dynrt.example/x.json').catch(() => 0);",
        ):
            with self.assertRaisesRegex(AssertionError, "Content Security Policy"):
                self.open(probe=probe)

    def test_an_address_is_a_view(self) -> None:
        elements, _ = self.open(
            "scene=b&measure=image.psnr&time=clocks&area=FF&variant=m8&sort=image.rms+down"
        )
        self.assertIn("another", elements.by_id("about")[2])
        titles = [e[2] for e in elements.of("text", class_="title")]
        self.assertTrue(any("↑ better: image psnr, dB" in t for t in titles), titles)
        self.assertTrue(any(t.startswith("clocks a frame") for t in titles), titles)
        self.assertTrue(any(t.startswith("FF cells") for t in titles), titles)
        rows = [e[1]["data-variant"] for e in elements.of("tr") if "data-variant" in e[1]]
        self.assertEqual(rows, ["m8", "m12_truncate", "m12", "m16", "m23", "m16_e5"])
        # The most decibels are best, and identical pictures better than any.
        front = [e[1]["data-variant"] for e in elements.of("circle", class_="on-front")]
        self.assertEqual(front, 2 * ["m8", "m12", "m16", "m23"])
        self.assertIn("identical", [e[2] for e in elements.of("td")])
        self.assertIn("mantissa bits 8", elements.by_id("differs")[2])

    def test_does_what_a_click_asks(self) -> None:
        _, found = self.open(
            probe="""
            click('circle[data-variant="m12"]');
            found.chosen = document.getElementById("variant").value;
            found.address = location.hash;
            click('tbody tr[data-variant="m23"]');
            found.row = document.getElementById("variant").value;
            const rows = () => [...document.querySelectorAll("tbody tr")].map((r) => r.dataset.variant);
            const column = [...document.querySelectorAll("thead button")]
                .findIndex((b) => b.textContent === "missed");
            const header = () => document.querySelectorAll("thead button")[column];
            header().click(); found.up = rows();
            header().click(); found.down = rows();
            const point = document.querySelector('circle[data-variant="m8"]');
            point.dispatchEvent(new MouseEvent("mouseenter"));
            found.tip = document.getElementById("tip").innerText;
            point.dispatchEvent(new MouseEvent("mouseleave"));
            found.hidden = document.getElementById("tip").hidden;
            const chooser = document.getElementById("measure");
            found.choices = [...chooser.options].map((o) => o.value);
            chooser.value = "primary.t_median";
            chooser.dispatchEvent(new Event("change"));
            found.title = document.querySelector("#time-plot .title:last-of-type").textContent;
            found.meaning = document.getElementById("meaning").textContent;
            """
        )
        self.assertEqual(found["chosen"], "m12")
        self.assertIn("variant=m12", found["address"])
        self.assertEqual(found["row"], "m23")
        self.assertEqual(found["up"], ["m16", "m23", "m12", "m12_truncate", "m8", "m16_e5"])
        self.assertEqual(found["down"], ["m8", "m12_truncate", "m12", "m16", "m23", "m16_e5"])
        for part in ("m8", "mantissa bits 8", "1,000", "clock, ns\t8.5", "12.5 levels", "LUT"):
            self.assertIn(part, found["tip"])
        self.assertTrue(found["hidden"])
        # Neither what is no error nor what no run can tell.
        self.assertEqual(
            found["choices"],
            ["primary.missed", "primary.t_median", "image.differ", "image.psnr", "image.rms"],
        )
        self.assertIn("relative error of the distance", found["meaning"])

    def test_without_clocks_the_other_plot_remains(self) -> None:
        report = json.loads(json.dumps(REPORT))
        for run in report["runs"]:
            run.pop("clocks", None)
            run.pop("frame_ms", None)
        kept = (self.folder / "error.html").read_text(encoding="utf-8")
        (self.folder / "error.html").write_text(page.page(report, self.folder), encoding="utf-8")
        try:
            elements, _ = self.open()
        finally:
            (self.folder / "error.html").write_text(kept, encoding="utf-8")
        self.assertIn("no variant has figures for ms a frame", [e[2] for e in elements.of("text")])
        self.assertEqual(len(elements.of("circle", class_="point")), len(VARIANTS) - 1)

    def test_where_every_run_was_refused_the_reasons_are_there(self) -> None:
        report = json.loads(json.dumps(REPORT))
        report["runs"] = [r for r in report["runs"] if "refused" in r]
        kept = (self.folder / "error.html").read_text(encoding="utf-8")
        (self.folder / "error.html").write_text(page.page(report, self.folder), encoding="utf-8")
        try:
            elements, _ = self.open()
        finally:
            (self.folder / "error.html").write_text(kept, encoding="utf-8")
        self.assertIn("No run gives an error", elements.by_id("meaning")[2])
        self.assertIn("exponent_bits 5 cannot hold x = 70000", [e[2] for e in elements.of("td")])

    def test_the_documents_plots_are_the_pages(self) -> None:
        text = plot.svg(self.folder / "error.json", "a", "image.rms", "FF")
        picture = xml.etree.ElementTree.fromstring(text)
        names = [e.get("data-variant") for e in picture.iter() if e.get("data-variant")]
        self.assertEqual(names, 2 * [v for v in VARIANTS if v != "m16_e5"])
        self.assertIn("svg .front {", text)
        self.assertIn("prefers-color-scheme: dark", text)
        self.assertIn("FF cells", text)
        self.assertIn(">a, 4x3, clocks of 8.5 to 10 ns, area on ", text)

    def test_the_data_of_the_plots_say_each_period(self) -> None:
        drawn = plot.figures(REPORT, "a", "image.rms", "FF")["variants"]
        self.assertEqual(
            {point["variant"]: point["clock, ns"] for point in drawn},
            {"m8": 8.5, "m12": 8.5, "m16": 10.0, "m23": 10.0, "m12_truncate": 8.5},
        )

    def test_the_measures_are_those_of_the_document(self) -> None:
        known = page.read_measures()
        self.assertIn(
            {"group": "image", "name": "psnr", "unit": "dB", "better": "more"},
            [{k: m[k] for k in ("group", "name", "unit", "better")} for m in known],
        )
        self.assertGreater(len(known), 30)
        for measure in known:
            self.assertIn(measure["better"], ("less", "more", "-"), measure)
            self.assertTrue(measure["meaning"].strip(" |"), measure)


if __name__ == "__main__":
    unittest.main()
