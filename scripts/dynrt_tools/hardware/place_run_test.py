# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place does around a placer that places: rows, and what is kept of them."""

import unittest
from unittest import mock

from dynrt_tools import project
from dynrt_tools.hardware import (
    block_registers,
    model_file,
    place_record,
    placed_clocks,
    placers,
    rtl_files,
)
from dynrt_tools.hardware.place_stand_in import UNIT, StandIn
from dynrt_tools.project import ROOT, Json


class Placed(StandIn):
    def test_a_row_with_its_paths(self) -> None:
        code, output, errors, data = self.called()
        self.assertEqual((code, errors), (0, ""))
        self.assertTrue((self.folder / "kept" / data["units"][0]["placed"][0]["run"]).is_dir())
        self.assertRegex(output, r"sum +2 +3.00 +40 +244 +244 to 244 +4.10 +137 %")
        self.assertIn("4.10 ns = 1.10 logic + 3.00 wires, 2 levels, 1 ends", output)
        (row,) = data["units"]
        self.assertEqual([p["seed"] for p in row["placed"]], [1, 2, 3])
        placed = row["placed"][0]
        self.assertEqual((placed["placer"], placed["too_slow"]), ("nextpnr-0.11", 0))
        self.assertEqual(len(placed["paths"][0]["hops"]), 4)
        self.assertTrue(placed["netlist"])

    def test_a_record_has_what_the_documents_and_a_fit_need(self) -> None:
        self.delay = {"delay": "hls/compiler/delay/ecp5-8.json"}
        self.called(grade="8", ask_mhz=300.0)
        record = place_record.read(self.folder / "record.json")
        for key, value in (
            ("device", "ecp5-85"),
            ("grade", "8"),
            ("copies", 1),
            ("placer", "nextpnr-0.11"),
            ("seeds", 3),
            ("date", project.today()),
            ("lowered", {"units": 1, "of": 1, "stages": 2}),
        ):
            self.assertEqual(record[key], value, key)
        row = record["units"]["sum"]
        shown = (row["stages"], row["cells"], row["MHz, median"], row["placed, ns"])
        self.assertEqual(shown, (2, 40, 244, 4.1))
        self.assertEqual((row["of predicted"], row["clock_ns"]), (137, 3.5))
        (file, constants), *_ = record["models"].items()
        self.assertEqual((file, constants), (row["delay"], model_file.constants(ROOT / file)))
        self.assertEqual(row["verilog"], place_record.hash_of("sum", [self.folder / "sum.v"]))
        (end,) = record["ends"]
        self.assertEqual((end["row"], end["ns"], end["median"]), ("sum", [4.1, 4.1, 4.1], 4.1))
        self.assertEqual(list(place_record.for_a_fit(record)), ["sum"])

    def test_what_cannot_be_recorded_is_named(self) -> None:
        (self.folder / "wide.v").write_text(
            UNIT.partition("\n")[2].replace("sum", "wide", 1), "utf-8"
        )
        code, output, errors, data = self.called(names=("wide", "sum"), seeds=1)
        self.assertEqual(code, 1)
        self.assertIn("place: wide is placed and not recorded: no unit is among the files", errors)
        self.assertIn("place: not everything is recorded\n", errors)
        self.assertRegex(output, r"sum +2 +3.00 +40 +244")
        self.assertTrue(data["complete"])

    def test_the_clock_of_a_core_is_stated(self) -> None:
        for mode, stated in (("no route:2", 0), ("", 1)):
            with (
                mock.patch.object(rtl_files, "CORE", "sum"),
                mock.patch.object(placed_clocks, "write") as write,
            ):
                self.called(mode, clock=True)
            self.assertEqual(write.call_count, stated, mode)
        (clock,) = write.call_args.args
        self.assertEqual(clock.key, ("ecp5-85", "6", "thesis"))
        self.assertEqual((clock.mhz, clock.seeds, clock.date), (243.9, 3, project.today()))

    def test_any_seeds_and_a_line_for_each(self) -> None:
        *_, data = self.called(seed=[7, 11])
        (row,) = data["units"]
        self.assertEqual([p["seed"] for p in row["placed"]], [7, 11])
        self.assertIn("place: placing sum, seed 11\n", self.progress)
        self.assertIn("place: sum, seed 11: 243.9 MHz\n", self.progress)

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
