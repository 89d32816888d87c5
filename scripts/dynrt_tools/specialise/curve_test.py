# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many packets and lines are chosen where the clocks of each number are known."""

import unittest

from dynrt_tools.specialise import curve


class Curve(unittest.TestCase):
    CLOCKS = {32: 1000, 16: 1009, 8: 1100, 4: 1700, 2: 3000, 1: 6000}

    def test_the_smallest_number_that_costs_little_enough(self) -> None:
        for percent, expected in ((0, 32), (1, 16), (10, 8), (9.9, 16), (1000, 4)):
            _, chosen = curve.walk_down(self.CLOCKS.__getitem__, 32, percent)
            self.assertEqual(chosen, expected)

    def test_what_is_much_slower_is_measured_once_and_no_further(self) -> None:
        found, _ = curve.walk_down(self.CLOCKS.__getitem__, 32, 1)
        self.assertEqual(found, {n: self.CLOCKS[n] for n in (32, 16, 8, 4)})

    def test_numbers_between_powers_of_two(self) -> None:
        self.assertEqual(list(curve.powers_below(48)), [32, 16, 8, 4, 2, 1])
        self.assertEqual(list(curve.powers_below(64)), [32, 16, 8, 4, 2, 1])

    def test_no_number_is_below_the_least(self) -> None:
        self.assertEqual(list(curve.powers_below(16, 4)), [8, 4])
        self.assertEqual(list(curve.powers_below(4, 4)), [])

    def test_the_reason_has_the_numbers_on_both_sides(self) -> None:
        self.assertEqual(
            curve.reason(self.CLOCKS, 16, 1, "a frame"),
            "with 32 a frame takes 1,000 clocks, with 16 0.9 % more, with 8 10.0 % "
            "more; 1 % are allowed",
        )
        self.assertEqual(
            curve.reason({1: 50}, 1, 1, "a frame of 64x48 at time 0"),
            "with 1 a frame of 64x48 at time 0 takes 50 clocks; 1 % are allowed",
        )

    def test_fewer_clocks_are_no_negative_part_more(self) -> None:
        self.assertEqual(
            curve.reason({32: 1000, 16: 961, 8: 1000}, 16, 1, "a frame"),
            "with 32 a frame takes 1,000 clocks, with 16 3.9 % fewer, with 8 0.0 % "
            "more; 1 % are allowed",
        )
        self.assertEqual(
            [curve.by_percent(p, "fewer") for p in (-3.94, -0.04, 0, 0.06)],
            ["3.9 % fewer", "0.0 %", "0.0 %", "0.1 %"],
        )

    def test_lines_are_measured_with_the_packets_that_were_chosen(self) -> None:
        class Meter(curve.Meter):
            asked: list[tuple[int, int]] = []

            def __init__(self) -> None:  # pylint: disable=super-init-not-called
                pass

            def clocks(self, packets: int, lines: int) -> int:
                self.asked.append((packets, lines))
                return 1000 if packets >= 16 and lines >= 64 else 2000

        meter = Meter()
        decided, curves = curve.choose(meter, 32, 512, 2)
        self.assertEqual((decided["packets"][0], decided["lines"][0]), (16, 64))
        self.assertEqual(list(curves["lines"]), [512, 256, 128, 64, 32])
        self.assertEqual({p for p, n in meter.asked if n < 512}, {16})


if __name__ == "__main__":
    unittest.main()
