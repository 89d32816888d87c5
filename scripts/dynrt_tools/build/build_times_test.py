# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads made-up logs of Ninja."""

import pathlib
import unittest

from dynrt_tools import testing
from dynrt_tools.build import build_times

LOG = """# ninja log v5
0\t2500\t17\thost/image.cpp.o\taa
2500\t2600\t17\tboard.verilated/shard_fast_0.cpp\tbb
2500\t2600\t17\tboard.verilated/shard_slow.cpp\tbb
10\t5010\t17\tgenerated/thesis/list.v\tcc
10\t5010\t17\tgenerated/thesis/list.json\tcc
5010\t5110\t17\tdynrt\tdd
"""


class BuildTimes(testing.InFolder):
    """One test for each table and mistake."""

    def setUp(self) -> None:
        super().setUp()
        self.path = self.folder / "log"

    def write(self, text: str) -> pathlib.Path:
        """The log with this text."""
        self.path.write_text(text, encoding="utf-8")
        return self.path

    def test_command_with_two_outputs_is_one_step(self) -> None:
        """Verilator writes many files at once."""
        steps = build_times.steps_of(self.write(LOG))
        self.assertEqual(
            [(s.kind, s.seconds) for s in steps],
            [("lower", 5.0), ("compile", 2.5), ("Verilate", 0.1), ("link", 0.1)],
        )

    def test_entries_from_before_are_left_out(self) -> None:
        """So that a build is told from the one before."""
        before = frozenset(build_times.read_lines(self.write(LOG)))
        self.write(LOG + "0\t100\t17\tnew.cpp.o\tee\n")
        self.assertEqual(
            [s.outputs for s in build_times.steps_of(self.path, before)], [("new.cpp.o",)]
        )

    def test_tables(self) -> None:
        """Their rows."""
        steps = build_times.steps_of(self.write(LOG))
        self.assertEqual(
            build_times.table_of_longest(steps, 1), "      5.0 s  lower     generated/thesis/list.v"
        )
        self.assertEqual(
            build_times.table_of_kinds(steps).splitlines()[0],
            "  lower            5.0 s in 1 steps, the longest 5.0 s",
        )

    def test_what_is_no_log_is_refused(self) -> None:
        """With file and line."""
        for text, message in (
            ("hello\n", ":1: is no log of Ninja"),
            (LOG + "1\t2\n", ":8: is no entry of five fields"),
        ):
            with self.assertRaisesRegex(build_times.Refused, message):
                build_times.steps_of(self.write(text))
        self.path.unlink()
        with self.assertRaisesRegex(build_times.Refused, "No such file"):
            build_times.steps_of(self.path)


if __name__ == "__main__":
    unittest.main()
