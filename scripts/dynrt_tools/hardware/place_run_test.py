# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place does around a placer that places: rows, and what is kept of them."""

import unittest
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import block_registers, kept_placement, model_file, placers
from dynrt_tools.hardware.place_stand_in import UNIT, StandIn
from dynrt_tools.project import Json


class Placed(StandIn):
    def test_a_row_with_its_paths(self) -> None:
        code, output, errors, data = self.called()
        self.assertEqual((code, errors), (0, ""))
        self.assertTrue((self.folder / "kept" / data["units"][0]["placed"][0]["run"]).is_dir())
        self.assertRegex(output, r"sum +2 +3.00 +40 +244 +244 to 244 +4.10 +137 %")
        record = project.read_json(self.folder / "record.json")
        shown = {"stages": 2, "predicted, ns": 3.0, "cells": 40, "ends too slow": 0}
        shown |= {
            "MHz, median": 244,
            "range low": 244,
            "range high": 244,
            "placed, ns": 4.1,
            "of predicted": 137,
        }
        self.assertEqual(record["units"], {"sum": shown})
        self.assertEqual(record["lowered"], {"units": 1, "of": 1, "stages": 2})
        self.assertIn("4.10 ns = 1.10 logic + 3.00 wires, 2 levels, 1 ends", output)
        (row,) = data["units"]
        self.assertEqual([p["seed"] for p in row["placed"]], [1, 2, 3])
        placed = row["placed"][0]
        self.assertEqual((placed["placer"], placed["too_slow"]), ("nextpnr-0.11", 0))
        self.assertEqual(len(placed["paths"][0]["hops"]), 4)
        self.assertTrue(placed["netlist"])

    def test_a_placement_is_kept(self) -> None:
        source = self.folder / "sum.v"
        source.write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", encoding="utf-8")
        self.called(keep=str(self.folder / "{unit}.json"))
        kept = kept_placement.read(self.folder / "sum.json")
        shown = {key: kept[key] for key in ("unit", "device", "grade", "copies", "placer", "seeds")}
        self.assertEqual(
            shown,
            {
                "unit": "sum",
                "device": "ecp5-85",
                "grade": "6",
                "copies": 1,
                "placer": "nextpnr-0.11",
                "seeds": 3,
            },
        )
        self.assertEqual(kept["clock_ns"], 3.5)
        self.assertEqual(kept["model"], self.model("ecp5.json"))
        self.assertAlmostEqual(kept_placement.period(kept), 4.1, delta=0.01)
        self.assertEqual(kept["verilog"], kept_placement.hash_of("sum", [source]))
        (end,) = kept_placement.that_limit(kept)
        self.assertEqual((end["ns"], end["median"]), ([4.1, 4.1, 4.1], 4.1))

    @staticmethod
    def model(name: str) -> dict[str, float]:
        return model_file.constants(project.ROOT / "hls/compiler/delay" / name)

    def test_what_is_kept_has_the_model_that_its_row_was_lowered_by(self) -> None:
        (self.folder / "sum.v").write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", "utf-8")
        self.delay = {"delay": "hls/compiler/delay/ecp5-8.json"}
        self.called(seeds=1, grade="8", keep=str(self.folder / "{unit}.json"))
        kept = kept_placement.read(self.folder / "sum.json")
        self.assertEqual(kept["model"], self.model("ecp5-8.json"))

    def test_a_row_that_cannot_be_kept_leaves_the_others(self) -> None:
        (self.folder / "sum.v").write_text(f"// Scheduled for 3.5 ns on x: y\n{UNIT}", "utf-8")
        code, output, errors, data = self.called(
            names=("wide", "sum"), seeds=1, keep=str(self.folder / "{unit}.json")
        )
        self.assertEqual(code, 1)
        self.assertEqual(
            errors,
            "place: wide is placed and not kept: no unit is among the files; their periods would be "
            "in their heads\nplace: not kept are wide\n",
        )
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertTrue(data["complete"])
        self.assertEqual(kept_placement.read(self.folder / "sum.json")["unit"], "sum")
        self.assertFalse((self.folder / "wide.json").exists())

    def test_clock_and_grade_reach_the_placer(self) -> None:
        for asked, mhz, grade in ((None, "100.0000", "6"), (120.0, "120.0000", "8")):
            self.called(seeds=1, ask_mhz=asked, grade=grade)
            run = self.runs()[-1]
            self.assertEqual(run[run.index("--freq") + 1], mhz)
            self.assertEqual(run[run.index("--speed") + 1], grade)

    def test_a_placer_that_places_for_another_clock_is_an_error(self) -> None:
        code, _, errors, data = self.called("deaf", seeds=1)
        self.assertEqual(code, 1)
        self.assertIn("was asked for 100.00 MHz and placed for 125.00 of clk", errors)
        self.assertEqual(data["units"][0]["placed"], [])

    def test_a_placement_is_not_repeated(self) -> None:
        first = self.called()[3]
        self.assertEqual(len(self.runs()), 3)
        self.assertEqual(self.called()[3], first)
        self.assertEqual(len(self.runs()), 3)

    def test_what_decides_a_placement_makes_it_new(self) -> None:
        self.called(seeds=1)
        changes: list[Json] = [
            {"grade": "8"},
            {"ask_mhz": 120.0},
            {"version": "nextpnr-0.12"},
            {"copies": 2},
        ]
        for number, flags in enumerate(changes, 2):
            self.called(seeds=1, **flags)
            self.assertEqual(len(self.runs()), number, flags)
        with mock.patch.object(placers, "constraints_text", lambda device: "other"):
            self.called(seeds=1)
        self.assertEqual(len(self.runs()), 6)
        with mock.patch.dict(placers.PLACERS["ecp5-85"], flags=["--85k"]):
            self.called(seeds=1)
        self.assertEqual(len(self.runs()), 7)
        self.write_unit("a_i - b_i")
        self.called(seeds=1)
        self.assertEqual(len(self.runs()), 8)

    def test_verilog_of_the_same_netlist_is_not_placed_again(self) -> None:
        first = self.called(seeds=1)[3]
        self.write_unit("\n(a_i + b_i)")
        second = self.called(seeds=1)[3]
        self.assertEqual(len(self.runs()), 1)
        runs = [data["units"][0]["placed"][0].pop("run") for data in (first, second)]
        self.assertNotEqual(*runs)  # the lines of its paths are those of the text
        self.assertEqual(
            first["units"][0]["placed"][0]["mhz"], second["units"][0]["placed"][0]["mhz"]
        )

    def test_another_packer_makes_the_netlist_new(self) -> None:
        first = self.called(seeds=1)[3]
        with mock.patch.object(block_registers, "version", lambda: "another"):
            second = self.called(seeds=1)[3]
        self.assertNotEqual(*(d["units"][0]["placed"][0]["netlist"] for d in (first, second)))


if __name__ == "__main__":
    unittest.main()
