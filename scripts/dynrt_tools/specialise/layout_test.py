# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many nodes a line gets where the costs of each number are known, and which numbers a core
may have."""

import argparse
import typing
import unittest

from dynrt_tools.build import configs
from dynrt_tools.specialise import decisions, layout
from dynrt_tools.specialise.analyst import FrameCosts
from dynrt_tools.specialise.specialiser import Project, Specialiser

LISTED = configs.load_configurations().listed()


class Layout(unittest.TestCase):
    COSTS = {
        1: FrameCosts(1010, 6.8),
        2: FrameCosts(1000, 5.7),
        4: FrameCosts(1020, 5.1),
        8: FrameCosts(1200, 9.9),
    }

    def test_the_bytes_decide_among_those_that_are_as_fast(self) -> None:
        self.assertEqual(layout.best(self.COSTS), 4)
        self.assertEqual(layout.best(self.COSTS | {4: FrameCosts(1021, 5.1)}), 2)

    def test_of_equal_ones_the_smallest(self) -> None:
        self.assertEqual(layout.best({n: FrameCosts(10, None) for n in (2, 1, 4)}), 1)

    def test_nothing_is_measured_beyond_one_that_is_worse_in_both(self) -> None:
        asked = []

        def frame_of(nodes: int) -> FrameCosts:
            asked.append(nodes)
            return (self.COSTS | {4: FrameCosts(1001, 5.8)})[nodes]

        self.assertEqual(list(layout.measured(frame_of, (8, 4, 2, 1))), [1, 2, 4])
        self.assertEqual(asked, [1, 2, 4])

    def test_slower_with_fewer_bytes_goes_on(self) -> None:
        self.assertEqual(list(layout.measured(self.COSTS.__getitem__, self.COSTS)), [1, 2, 4, 8])

    def test_the_reason_has_all_that_were_measured(self) -> None:
        self.assertEqual(
            layout.reason({n: self.COSTS[n] for n in (1, 2)}, 2, "a frame"),
            "with 2 a frame takes 1,000 clocks and 5.70 bytes a ray, with 1 1.0 % more and 6.80 "
            "bytes a ray",
        )
        self.assertEqual(
            layout.reason({1: FrameCosts(50, None)}, 1, "a frame"),
            "with 1 a frame takes 50 clocks",
        )


class Allowed(unittest.TestCase):
    """What the rules of the keys leave, of cores whose every other key is the general core's."""

    def numbers(self, name: str, **changed: object) -> tuple[list[int], int]:
        general = LISTED[name] | changed
        project = typing.cast(
            Project, argparse.Namespace(name="office", args=argparse.Namespace(keep=[]))
        )
        needs = {"keys": {k: {"value": v, "reason": "as it is"} for k, v in general.items()}}
        whole: decisions.Measured = {
            key: (general[key], "being measured") for key in ("packets", "lines")
        }
        made = Specialiser(project, name, general, needs, {})
        return made.nodes_of_a_line(whole), made.least_lines(whole)

    def test_banks_leave_no_choice(self) -> None:
        self.assertEqual(self.numbers("fast"), ([], 1))

    def test_a_port(self) -> None:
        self.assertEqual(self.numbers("fast_port", second_level=0), ([1, 2, 4], 16))
        self.assertEqual(self.numbers("fast_port", line_nodes=1)[1], LISTED["fast_port"]["ways"])

    def test_few_lines_leave_few_nodes(self) -> None:
        self.assertEqual(self.numbers("fast_port", second_level=0, lines=32)[0], [1, 2, 4])


if __name__ == "__main__":
    unittest.main()
