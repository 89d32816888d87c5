# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page and the drawings of a hardware report: that they have every curve, that the page says what
is missing, needs no network and can be used without a mouse."""

import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

from dynrt_tools.hardware_report import example, page, plots
from dynrt_tools.hardware_report.figures import FIGURES, PACKETS
from dynrt_tools.project import Json
from dynrt_tools.report import page_testing

TEXT = "{http://www.w3.org/2000/svg}text"


class Page(page_testing.Opened):
    def test_every_curve_and_the_thesis(self) -> None:
        elements, found = self.open_text(
            page.page(example.report()),
            probe="""
            found.curves = {};
            for (const section of document.querySelectorAll("[data-figure]")) {
              found.curves[section.dataset.figure] = section.querySelectorAll(".curve").length;
            }
            found.marks = [...document.querySelectorAll(".thesis")]
                .map((m) => m.closest("section").dataset.figure);
            found.missing = document.getElementById("missing").hidden;
            found.added = document.getElementById("added").hidden;
            found.reading = document.getElementById("reading").innerText;
            """,
        )
        # Hit rates of three caches in two orders; four units.
        curves = {"7.5 and 7.10": 6, "7.6": 1, "7.7": 1, "7.8": 4, "7.9": 1, "7.11": 1, "7.12": 1}
        self.assertEqual(found["curves"], curves)
        # Of cistern the text gives the best index and a range of frame rates.
        self.assertEqual(found["marks"], ["7.6", "7.9"])
        self.assertTrue(found["missing"])
        self.assertTrue(found["added"], "there is none")
        self.assertEqual(found["reading"], "how </script> it is read")
        labels = [e[1].get("aria-label", "") for e in elements.of("circle", class_="point")]
        self.assertIn("wide: 21.05 rays a clock per million gates at 4 packets", labels)
        self.assertIn("wide: 2,361 frames per second at 127.5 MB/s of memory bandwidth", labels)
        rows = [e[2] for e in elements.of("td")]
        for word in ("wide", "narrow", "17 to 25", "487,020 + 56,028 P + 996 CL", "about 9.5"):
            self.assertIn(word, rows)

    def test_what_this_project_added(self) -> None:
        row: Json = {"scene": "lamps", "configuration": "wide", "addition": "four ways, not two"}
        row |= {"frame rate gained": 12.5, "QHW without": 3.0, "QHW with": None}
        elements, found = self.open_text(
            page.page(example.report(additions=[row])),
            probe="""
            found.hidden = document.getElementById("added").hidden;
            found.cells = [...document.querySelectorAll("#additions tbody td")]
                .map((c) => c.textContent);
            found.frames = document.getElementById("frames").textContent;
            """,
        )
        self.assertFalse(found["hidden"])
        self.assertEqual(found["cells"][:4], ["lamps", "wide", "four ways, not two", "12.5"])
        self.assertEqual(found["frames"], "3 frames")
        self.assertIn("frame rate gained", [e[2] for e in elements.of("th")])

    def test_an_address_is_a_view(self) -> None:
        view = "scene=lamps&sort=rays+per+clock+down"
        elements, found = self.open_text(
            page.page(example.report()),
            view,
            """
            found.marks = document.querySelectorAll(".thesis").length;
            found.order = [...document.querySelectorAll("#table tbody tr")]
                .map((r) => r.children[1].textContent);
            """,
        )
        self.assertIn("three lamps", elements.by_id("about")[2])
        self.assertEqual(found["marks"], 0)
        self.assertEqual(found["order"], ["wide", "wide", "narrow", "narrow"])

    def test_without_a_mouse(self) -> None:
        _, found = self.open_text(
            page.page(example.report()),
            probe="""
            const plot = document.querySelector('[data-figure="7.8"] svg');
            found.stops = plot.querySelectorAll('[tabindex="0"]').length;
            const press = (key) => document.activeElement.dispatchEvent(
                new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
            const at = () => document.activeElement.getAttribute("aria-label");
            plot.querySelector('[tabindex="0"]').focus();
            found.first = at();
            press("ArrowRight"); found.right = at();
            press("ArrowDown"); found.down = at();
            press("ArrowLeft"); press("ArrowLeft"); found.end = at();
            found.tip = document.getElementById("tip").innerText;
            found.still = plot.querySelectorAll('[tabindex="0"]').length;
            document.querySelectorAll("#table th button")[6].click();
            found.sort = document.querySelectorAll("#table th")[6].getAttribute("aria-sort");
            """,
        )
        self.assertEqual((found["stops"], found["still"]), (1, 1))
        self.assertEqual(found["first"], "wide, traversal: 10 % at 1 packets")
        self.assertEqual(found["right"], "wide, traversal: 20 % at 2 packets")
        self.assertEqual(found["down"], "wide, list: 5 % at 2 packets")
        self.assertEqual(found["end"], "wide, list: 2.5 % at 1 packets")
        self.assertIn("wide, list", found["tip"])
        self.assertEqual(found["sort"], "ascending")

    def test_says_what_is_missing(self) -> None:
        report = example.report(missing=["lamps, wide: 14 of 14 frames"])
        report["runs"] = [r for r in report["runs"] if r["scene"] != "lamps"]
        _, found = self.open_text(
            page.page(report),
            "scene=lamps",
            probe="""
            found.missing = document.getElementById("missing").innerText;
            found.figures = document.getElementById("figures").innerText;
            """,
        )
        self.assertIn("lamps, wide: 14 of 14 frames", found["missing"])
        self.assertIn("No frame of this scene gives it", found["figures"])

    def test_a_figure_that_no_frame_gives_is_not_mentioned(self) -> None:
        report = example.report()
        for run in report["runs"]:
            run.pop("QHW")
        self.assertNotIn("7.6", [figure["name"] for figure in page.shown(report)["figures"]])


class Plots(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_every_figure_is_a_drawing(self) -> None:
        paths = plots.write(self.folder, example.report())
        self.assertEqual([path.stem for path in paths], [figure.file for figure in FIGURES])
        first = [path.read_bytes() for path in paths]
        plots.write(self.folder, example.report())
        self.assertEqual([path.read_bytes() for path in paths], first)
        self.assertIn("MB/s of memory bandwidth", paths[-2].read_text(encoding="utf-8"))
        for path in paths:
            xml.etree.ElementTree.parse(path)

    def test_plots_of_scenes_and_configurations(self) -> None:
        figures = {figure.name: figure for figure in FIGURES}
        report = example.report()
        several = plots.panels(report, figures["7.8"])
        self.assertEqual([scene for scene, _ in several], ["cistern", "lamps"])
        self.assertEqual([len(group) for group in several[0][1]], [4])
        (group,) = plots.panels(report, figures["7.9"])[0][1]
        self.assertEqual([x for x, _ in group[0].points], [p for p in PACKETS if p <= 4])

    def test_a_figure_that_no_frame_gives_is_not_drawn(self) -> None:
        report = example.report()
        for run in report["runs"]:
            run.pop("QHW")
        plots.write(self.folder, report)
        self.assertFalse((self.folder / "figure_7_6.svg").exists())


if __name__ == "__main__":
    unittest.main()
