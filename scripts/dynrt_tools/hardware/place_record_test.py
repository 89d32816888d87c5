# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Records of placements: which ends they have, what their hash is of, and files that are none."""

import pathlib
import tempfile
import typing
import unittest

from dynrt_tools import project, testing
from dynrt_tools.hardware import (
    place_record,
    placed_ends,
    source_names,
    synthesis,
    timing_graph,
)
from dynrt_tools.hardware.placed_example import SDF, with_second_bit
from dynrt_tools.project import Json


def ends(**times: float) -> dict[placed_ends.End, Json]:
    """Of a unit `u`, by the signal."""
    start = {"unit": "u", "signal": "a_s0"}
    return {
        placed_ends.End("u", signal, ""): {"ns": ns, "source": f"line of {ns}", "from": start}
        for signal, ns in times.items()
    }


class Limiting(unittest.TestCase):
    def found(self, *by_seed: dict[placed_ends.End, Json], periods: list[float]) -> Json:
        rows = place_record.limiting("u", by_seed, periods)
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
        rows = place_record.limiting(
            "u", [ends(a=9, b=10), ends(a=9.5, b=9), ends(a=9.2, b=9.9)], [10, 10, 10]
        )
        self.assertEqual([row["signal"] for row in rows], ["b", "a"])
        self.assertEqual(rows[0]["source"], "line of 9.9")


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
        return place_record.hash_of("a", files)

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

    def record(self, **row: object) -> Json:
        row = {"mhz": [100.0, 125.0, 80.0], "delay": "a"} | row
        return {
            "copies": 1,
            "asked_mhz": 110,
            "units": {"list": row},
            "models": {},
            "ends": [{"row": "list"}],
        }

    def test_what_is_written_is_read(self) -> None:
        path = self.folder / "record.json"
        record = self.record()
        place_record.write(path, record)
        self.assertEqual(place_record.read(path), record)
        self.assertIn('\n    {"row": "list"}\n', path.read_text(encoding="utf-8"))

    def test_a_fit_takes_cores_and_units_with_a_median(self) -> None:
        good = self.record()
        board = good | {"units": {"dynrt_board": good["units"]["list"]}}
        board["ends"] = [{"row": "dynrt_board"}]
        for record, fits in (
            (good, ["list"]),
            (good | {"ends": []}, []),
            (good | {"copies": 2}, []),
            (good | {"asked_mhz": 90}, []),
            (self.record(mhz=[1.0, 2.0]), []),
            (board, []),
        ):
            self.assertEqual(list(place_record.for_a_fit(record)), fits)

    def test_a_file_that_is_none_is_refused(self) -> None:
        path = self.folder / "record.json"
        for text, said in (("{", "Expecting"), ("[1]", "list indices"), ("{}", "'units'")):
            path.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(project.Failed, f"is no record of placements .{said}"):
                place_record.read(path)
        with self.assertRaisesRegex(project.Failed, r"none.json: is no record .*\(No such file"):
            place_record.read(self.folder / "none.json")

    def test_without_a_schedule_there_is_no_promise(self) -> None:
        path = self.folder / "a.v"
        path.write_text(self.MODULE, encoding="utf-8")
        with self.assertRaisesRegex(project.Failed, "no unit is among the files"):
            place_record.scheduled_for([path])


if __name__ == "__main__":
    unittest.main()
