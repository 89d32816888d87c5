# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The rows of an experiment from frames whose figures are known, beside each other and what is
asked."""

import unittest
from typing import Any

from dynrt_tools.experiments import frame, rows, sdram, table
from dynrt_tools.experiments.frame import Work
from dynrt_tools.experiments.testing_frames import frame as made
from dynrt_tools.experiments.testing_frames import walk
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Json

MEMORY = table.experiment("memory")
COUNTERS = {
    "shade_job.tokens": 49152,
    "list_lookup.transactions": 311024,
    "collect_hits.transactions": 1135952,
    "transform_job.tokens": 333140,
    "list_job.tokens": 435918,
    "node_lookup.transactions": 1681545,
}


def memory_rows(clocks: dict[tuple[str, str], int]) -> list[Json]:
    """Of frames that take so many clocks."""
    frames = {place: {"frame": {**made(4, 2), "cycles": n}} for place, n in clocks.items()}
    return rows.rows_of(MEMORY, table.of_experiment("memory"), frames, "32x24")


class Frames(unittest.TestCase):
    def test_figures(self) -> None:
        found = frame.figures_of(made(4, 2))
        self.assertEqual((found["clocks"], found["rays per clock"]), (19200, 0.04))
        self.assertEqual(found["node cache hits"], 60)
        self.assertEqual((found["busiest unit"], found["use"]), ("slice_0", 40))
        self.assertEqual((found["bytes written per ray"], found["port use"]), (28, None))
        self.assertAlmostEqual(found["bytes read per ray"], (200 * 8 + 50 * 4 + 100 * 12) / 768)
        self.assertAlmostEqual(found[frame.RATE], 85e6 / 19200)

    def test_the_mean_of_a_walk(self) -> None:
        mean = frame.mean([one["figures"] for one in walk(4, 2)["walk"]["frames"]])
        self.assertEqual((mean["cycles"], mean["most_cycles"]), (19200, 19202))
        self.assertAlmostEqual(frame.figures_of(mean)[frame.SLOWEST], 85e6 / 19202)
        slow: Json = {**made(4, 2), "cycles": 57600}
        slow["units"] = {**slow["units"], "slice_0": {"utilisation": 0.8}}
        slow["caches"] = {"node": {"lookups": 1500, "misses": 0}}
        both = frame.mean(
            [{**made(4, 2), "caches": {"node": {"lookups": 500, "misses": 200}}}, slow]
        )
        self.assertAlmostEqual(both["units"]["slice_0"]["utilisation"], (0.4 + 3 * 0.8) / 4)
        self.assertAlmostEqual(both["caches"]["node"]["hit_rate"], 0.9)

    def test_work_of_a_frame(self) -> None:
        one: dict[str, Any] = {"configuration": "full", "counters": COUNTERS}
        work = Work.of(one)
        self.assertEqual(work, Work(49152, 1681545, 311024, 0, 1556651, 124894, 234836, 49152))
        self.assertEqual(work.bound(), 1681545)
        # The counters of other cores say less.
        for other in ("fast", "whitted", "watertight", "configuration"):
            work = Work.of({**one, "configuration": other})
            self.assertEqual(work, Work(49152, 1681545, 311024, 0), other)

    def test_what_holds_up_a_frame(self) -> None:
        units = {
            "slice_0": {"utilisation": 0.8, "transactions": 20, "stalled": 0.03},
            "memory_interface": {"utilisation": 0.25},
        }
        one = {"configuration": "fast", "counters": {"shade_job.tokens": 2}, "units": units}
        self.assertEqual(
            frame.waits(one),
            "slice_0 works in 80.0 % of the clocks, 10 times for each packet, and otherwise waits for "
            "packets that are elsewhere; the memory serves cache misses in 25.0 %; held up for want of "
            "room behind them: slice_0 3.0 %",
        )


class Rows(unittest.TestCase):
    def test_beside_each_other(self) -> None:
        found = memory_rows(
            {
                ("fast", "office"): 1000,
                ("latency 30", "office"): 1250,
                ("ways 4", "office"): 1100,
                ("pipelines 2", "office"): 625,
                ("pipelines 4, ways 4", "office"): 275,
                ("latency 30", "conference"): 5000,
            }
        )
        share, times = "share of SRAM", "frames of one pipeline"
        self.assertEqual([row[share] for row in found[:2]], [1, 0.8])
        self.assertEqual([row[times] for row in found[:5]], [None, None, None, 2, 4])
        self.assertIsNone(found[5][share], "conference has no frame with SRAM")

    def test_aims(self) -> None:
        found = memory_rows({("fast", "office"): 1000, ("latency 30", "office"): 1250})
        aims = rows.aims_of(MEMORY, found)
        share, read = aims[0], aims[-1]
        self.assertEqual(len(aims), 2)
        self.assertEqual(
            (share["asked"], share["reached"], share["verdict"]), (0.97, 0.8, "missed")
        )
        self.assertEqual((read["bound"], read["verdict"]), ("at most", "reached"))
        self.assertEqual(
            rows.aim_text(share, MEMORY["columns"]),
            "latency 30, office: share of SRAM 0.800, asked at least 0.970: missed",
        )

    def test_beside_the_thesis(self) -> None:
        for clocks, verdict in (
            (85e6 // 25, "within"),
            (85e6 // 31, "above"),
            (85e6 // 19, "below"),
        ):
            row = {"scene": "office", "clocks": clocks, frame.RATE: 85e6 / clocks}
            found = rows.beside_the_thesis(row, "fast", "512x384")
            self.assertEqual((found[rows.RATES], found[rows.VERDICT]), ("20 to 30", verdict))
            self.assertEqual(rows.beside_the_thesis(row, "fast", "32x24")[rows.VERDICT], "-")
            self.assertEqual(found[rows.PLACED], placed_clocks.rate_text(clocks, "fast", ".2f"))
        self.assertNotIn(rows.RATES, rows.beside_the_thesis({**row, "scene": "blocks"}, "fast", ""))

    def test_as_text(self) -> None:
        found = memory_rows({("fast", "office"): 1000, ("latency 30", "office"): 1250})
        text = rows.text(
            MEMORY, {"size": "32x24", "rows": found, "aims": rows.aims_of(MEMORY, found)}
        )
        self.assertRegex(text, r"\n\s+fast +latency 30\n\s+office +office\nclocks +1,000 +1,250\n")
        self.assertRegex(text, r"\nsecond cache hits +- +-\n")
        self.assertIn("\n\nlatency 30, office: share of SRAM 0.800, asked", text)


class Sdram(unittest.TestCase):
    """A core of 100 MHz behind an SDRAM of 100 MHz; half of its clocks move words, a quarter find
    no burst."""

    def found(self) -> Json:
        stated = {"like": "fast_port", "program": "p", "core_mhz": 100, "sdram_mhz": 100}
        placed = table.variant("placed", stated, None, "thesis")
        sram = table.variant("SRAM", {"like": "fast"}, None, "thesis")
        counts = {"clocks": 1250, "busy": 625, "idle": 312.5, "activations": 30, "bursts": 40}
        counts |= {"refreshes": 2, "refresh_clocks": 12, "reads": 10, "read_nanoseconds": 5000}
        for name, each in (("read", 9), ("written", 2), ("displayed", 0.5)):
            counts[f"bytes_{name}"] = each * 768
        counts |= {f"{kind}_bytes_read": 3 * 768 for kind in ("node", "list", "matrix")}
        units = {
            "node_fetch": {"utilisation": 0.7, "stalled": 0},
            "memory_lookup": {"utilisation": 0.95, "stalled": 0.1},
        }
        one: Json = {**made(4, 2), "cycles": 1250, "units": units, "sdram": counts}
        banks: Json = {**made(4, 2), "cycles": 1000, "units": {"node_fetch": {"utilisation": 0.9}}}
        frames: dict[tuple[str, str], Json | None] = {
            ("SRAM", "office"): {"frame": banks},
            ("placed", "office"): one,
        }
        variants = {"SRAM": sram, "placed": placed}
        self.assertEqual(sdram.flags_of(placed), ["--core-mhz", "100", "--sdram-mhz", "100"])
        found = rows.rows_of(table.experiment("board"), variants, frames, "32x24")
        (budget,) = sdram.budgets(found, variants)
        return {**found[1], "budget": budget}

    def test_figures(self) -> None:
        row = self.found()
        self.assertEqual((row["share of SRAM"], row["busiest unit"]), (0.8, "node_fetch"))
        self.assertAlmostEqual(row["use with SRAM"], 90)
        shares = ("share of the peak", "waits for the core", "waits for rows and turns")
        self.assertEqual([row[name] for name in shares], [0.5, 0.25, 0.25])
        self.assertAlmostEqual(row["MB per second read"], 9 * 768 / 12.5)
        self.assertEqual((row["rows opened per burst"], row["ns of a read"]), (0.75, 500))
        self.assertAlmostEqual(row["reads under way"], 5000 / 12500)

    def test_the_budget_limits_the_aim(self) -> None:
        row = self.found()["budget"]
        asked, displayed, refresh = 11 * 768 / 10, 0.5 * 768 / 12.5, 200 * 24 / 1250
        self.assertAlmostEqual(row["peak"], 200)
        self.assertAlmostEqual(row["read"] + row["written"], asked)
        self.assertAlmostEqual(row["sum"], asked + displayed + refresh)
        self.assertAlmostEqual(row["reachable"], (0.85 * 200 - displayed - refresh) / asked)
        self.assertEqual((row["aim"], row["verdict"]), (row["reachable"], "reached"))
        self.assertIn("MB/s", sdram.text([row]))


if __name__ == "__main__":
    unittest.main()
