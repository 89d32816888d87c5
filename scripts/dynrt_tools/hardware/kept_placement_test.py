# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Kept placements: which ends they have, what their hash is of, and files that are none."""

import json
import pathlib
import tempfile
import typing
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import (
    kept_placement,
    placed_clocks,
    placed_ends,
    placing,
    source_names,
    synthesis,
    timing_graph,
)
from dynrt_tools.hardware.placed_example import SDF, with_second_bit
from dynrt_tools.project import Json, read_json


def ends(**times: float) -> dict[placed_ends.End, Json]:
    """Of a unit `u`, by the signal."""
    start = {"unit": "u", "signal": "a_s0"}
    return {
        placed_ends.End("u", signal, ""): {"ns": ns, "source": f"line of {ns}", "from": start}
        for signal, ns in times.items()
    }


class Limiting(unittest.TestCase):
    def found(self, *by_seed: dict[placed_ends.End, Json], periods: list[float]) -> Json:
        rows = kept_placement.limiting(by_seed, periods)
        return {row["signal"]: (row["ns"], row["median"]) for row in rows}

    def test_an_end_limits_in_one_seed_or_in_the_median(self) -> None:
        found = self.found(
            ends(always=10, once=9, never=8.4),
            ends(always=9.5, once=7, never=8.0),
            ends(always=12, never=8.4),
            periods=[10, 10, 12],
        )
        self.assertEqual(found, {"always": ([10, 9.5, 12], 10), "once": ([9, 7, None], 7)})

    def test_the_worst_comes_first_with_the_line_of_the_median(self) -> None:
        rows = kept_placement.limiting(
            [ends(a=9, b=10), ends(a=9.5, b=9), ends(a=9.2, b=9.9)], [10, 10, 10]
        )
        self.assertEqual([row["signal"] for row in rows], ["b", "a"])
        self.assertEqual(rows[0]["source"], "line of 9.9")

    def test_of_what_is_kept_the_median_s_are_judged(self) -> None:
        kept = {"mhz": [100, 125, 80], "limits": 0.85, "ends": [{"median": 8.5}, {"median": 8.4}]}
        self.assertEqual(kept_placement.that_limit(kept), [{"median": 8.5}])


class Kept(unittest.TestCase):
    def test_cores_were_placed_as_the_script_places_now(self) -> None:
        files = sorted(kept_placement.DATA.glob(placed_clocks.FILES))
        self.assertTrue(files)
        for path in files:
            kept = kept_placement.read(path)
            again = (
                f"{path.name}: made with other tools or flags; its command in runs.json renews it"
            )
            self.assertEqual(kept["tools"], placing.tools(kept["device"]), again)

    def test_those_of_an_earlier_verilog_are_named(self) -> None:
        """As a test that is skipped, since a machine without the placer cannot renew them."""
        kept = {
            p.name: kept_placement.read(p)
            for p in kept_placement.DATA.glob("place_*.json")
            if "ends" in read_json(p)
        }
        whole = {name: k for name, k in kept.items() if kept_placement.of_checked_in(k)}
        self.assertIn("place_core.json", whole)
        earlier = sorted(name for name, k in whole.items() if not kept_placement.is_current(k))
        if earlier:
            self.skipTest(f"of an earlier Verilog: {', '.join(earlier)}; place them again")


class Names(unittest.TestCase):
    """Ends of an SDF file, under names that a stand-in gives."""

    class StandIn:
        """A register that a path ends at, and where it starts."""

        def register(self, cell: str) -> source_names.Origin:
            return source_names.Origin("u", f"{cell.partition('[')[0]}_s2[3]", "units/u.h:1")

        def origin(self, cell: str, _: str) -> source_names.Origin:
            return source_names.Origin("v", f"{cell}_q[1]", "")

    def read(self, text: str) -> dict[placed_ends.End, Json]:
        path = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "a.sdf"
        path.write_text(text, encoding="utf-8")
        timing = timing_graph.Timing(timing_graph.read_sdf(path))
        return placed_ends.ends_of(timing, typing.cast(source_names.Names, self.StandIn()))

    def test_bits_are_one_end_with_the_worst_time(self) -> None:
        found = self.read(with_second_bit(1500))
        (end, about), *more = found.items()
        self.assertEqual((end, more), (placed_ends.End("u", "end_s2", ""), []))
        self.assertEqual(about["ns"], 4.1)
        self.assertEqual(about["from"], {"unit": "v", "signal": "start_q"})

    def test_the_columns_of_a_ram_are_one_end(self) -> None:
        for signal in ("a_ram.exclusive.column[3].rows", "a_ram.exclusive.rows"):
            self.assertEqual(placed_ends.name_of(signal), "a_ram.exclusive.rows")
        self.assertEqual(
            placed_ends.name_of("a_ram.exclusive.column[0].row_q[7]"), "a_ram.exclusive.row_q"
        )

    def test_a_path_from_a_reset_is_another_end(self) -> None:
        found = self.read(SDF.replace("start", "u_reset"))
        self.assertEqual([end.port for end in found], ["reset"])

    def test_a_memory_s_pins_are_its_ports(self) -> None:
        ports = {
            "write_data": ("WD", "DIA3", "WDATA_11"),
            "write_addr": ("WAD2", "ADA10", "WADDR_5"),
            "write_en": ("WRE", "WEA", "WCLKE"),
            "read_addr": ("ADB3", "RADDR_0"),
            "read_en": ("CEB", "RCLKE"),
        }
        for port, pins in ports.items():
            for pin in pins:
                self.assertEqual(placed_ends.port_of("a_ram.exclusive.rows", pin), port)
        self.assertEqual(placed_ends.port_of("a_file.rows", "I2"), "")
        self.assertEqual(placed_ends.port_of("a_s2", "CE"), "")


class Files(testing.InFolder):
    MODULE = "module a (input clk_i);\n  b inner (.clk_i(clk_i));\nendmodule\n"

    def hash(self, **texts: str) -> str:
        files = []
        for name, text in texts.items():
            files.append(self.folder / f"{name}.v")
            files[-1].write_text(text, encoding="utf-8")
        synthesis._text.cache_clear()  # pylint: disable=protected-access
        synthesis.meaning.cache_clear()
        return kept_placement.hash_of("a", files)

    def test_the_hash_is_of_the_headers_too(self) -> None:
        first = self.hash(a=self.MODULE)
        (self.folder / "a.vh").write_text("`define A 1\n", encoding="utf-8")
        self.assertNotEqual(self.hash(a=self.MODULE), first)

    def test_the_hash_is_of_what_the_module_needs(self) -> None:
        inner = "module b (input clk_i);\nendmodule\n"
        first = self.hash(a=self.MODULE, b=inner)
        other = inner.replace("module b", "module c")
        self.assertEqual(self.hash(a=self.MODULE + "// why\n", b=inner, c=other), first)
        self.assertNotEqual(self.hash(a=self.MODULE, b=inner.replace("clk_i", "clock_i")), first)

    def test_what_is_written_is_read(self) -> None:
        kept = {key: 1 for key in kept_placement.HAS} | {"ends": [{"signal": "a"}, {"signal": "b"}]}
        path = self.folder / "kept.json"
        kept_placement.write(path, kept)
        self.assertEqual(kept_placement.read(path), kept)
        self.assertIn('\n    {"signal": "a"},\n', path.read_text(encoding="utf-8"))

    def test_a_fit_takes_cores_and_units_with_a_median(self) -> None:
        path = self.folder / "kept.json"
        good: Json = {key: 1 for key in kept_placement.HAS}
        good |= {"unit": "list", "mhz": [1.0, 2.0, 3.0], "ends": []}
        cases: list[tuple[Json, bool]] = [
            ({}, True),
            ({"mhz": [1.0, 2.0]}, False),
            ({"copies": 2}, False),
            ({"unit": "dynrt_board"}, False),
        ]
        for change, fits in cases:
            kept_placement.write(path, good | change)
            self.assertEqual(kept_placement.is_for_a_fit(path), fits, change)

    def test_a_file_that_is_none_is_refused(self) -> None:
        path = self.folder / "kept.json"
        cases = {
            "{": "cannot be read",
            "[1]": "is no kept placement, as it has no 'unit'",
            json.dumps({"unit": "list"}): "is no kept placement, as it has no 'config'",
        }
        for text, said in cases.items():
            path.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(project.Failed, f"kept.json: {said}.*scripts/place --keep"):
                kept_placement.read(path)
        with self.assertRaisesRegex(project.Failed, r"none.json: cannot be read \(No such file"):
            kept_placement.read(self.folder / "none.json")

    def test_without_a_schedule_there_is_no_promise(self) -> None:
        path = self.folder / "a.v"
        path.write_text(self.MODULE, encoding="utf-8")
        with self.assertRaisesRegex(project.Failed, "no unit is among the files"):
            kept_placement.scheduled_for([path])


if __name__ == "__main__":
    unittest.main()
