# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which pins of distributed RAM lose their constant. That the RAM does the same is the test
netlist.cells."""

import copy
import unittest
from collections import Counter
from typing import Any

from dynrt_tools.hardware import distributed_ram
from dynrt_tools.hardware.distributed_ram import ADDRESS, ENABLE

# Yosys writes the bits of a port from the lowest, a net as a number.
FOUR_ROWS: dict[str, Any] = {"WAD": [10, 11, "0", "0"], "RAD": [20, 21, "0", "0"], "WRE": ["1"]}


class Spare(unittest.TestCase):
    def spare(self, connections: Any, **parameters: str) -> tuple[Counter[str], Any]:
        """How many pins of a RAM have lost a constant, and the RAM after that."""
        ram = {
            "type": distributed_ram.RAM,
            "connections": copy.deepcopy(connections),
            "parameters": parameters,
        }
        spared = distributed_ram.spare({"modules": {"m": {"cells": {"ram": ram}}}})
        return spared, ram

    def test_a_constant_address_bit_becomes_another_one(self) -> None:
        spared, ram = self.spare(FOUR_ROWS)
        self.assertEqual(spared, {ADDRESS: 4, ENABLE: 1})
        self.assertEqual(ram["connections"]["WAD"], [10, 11, 10, 10])
        self.assertEqual(ram["connections"]["RAD"], [20, 21, 20, 20])

    def test_a_constant_enable_becomes_the_rams_own(self) -> None:
        _, ram = self.spare(FOUR_ROWS, WREMUX="WRE ")
        self.assertEqual(ram["connections"]["WRE"], [])
        self.assertEqual(ram["parameters"]["WREMUX"], "1 ")

    def test_a_bit_of_an_address_that_is_constant_on_one_side_stays(self) -> None:
        read_in_two_rows = {**FOUR_ROWS, "RAD": [20, "1", "0", "0"]}
        _, ram = self.spare(read_in_two_rows)
        self.assertEqual(ram["connections"]["WAD"], [10, 11, 10, 10])
        self.assertEqual(ram["connections"]["RAD"], [20, "1", 20, 20])

    def test_bits_that_are_constant_and_differ_stay(self) -> None:
        never_written = {**FOUR_ROWS, "RAD": [20, 21, "1", "0"]}
        spared, ram = self.spare(never_written)
        self.assertEqual(spared[ADDRESS], 2)
        self.assertEqual(ram["connections"]["RAD"], [20, 21, "1", 20])

    def test_an_address_all_of_whose_bits_are_constant_stays(self) -> None:
        one_row = {**FOUR_ROWS, "WAD": ["0"] * 4, "RAD": ["0"] * 4}
        spared, ram = self.spare(one_row)
        self.assertEqual(spared, {ENABLE: 1})
        self.assertEqual(ram["connections"]["WAD"], ["0"] * 4)

    def test_rows_that_hold_something_from_the_start_stay(self) -> None:
        spared, ram = self.spare(FOUR_ROWS, INITVAL="0" * 60 + "1010")
        self.assertEqual(spared, {ENABLE: 1})
        self.assertEqual(ram["connections"]["WAD"], FOUR_ROWS["WAD"])

    def test_rows_that_are_zero_or_unknown_at_the_start_do_not_stay(self) -> None:
        for start in ("0" * 64, "x" * 64):
            spared, _ = self.spare(FOUR_ROWS, INITVAL=start)
            self.assertEqual(spared[ADDRESS], 4)

    def test_an_enable_that_is_used_or_inverted_stays(self) -> None:
        for enable, mux in ((30, "WRE "), ("1", "INV "), ("0", "WRE ")):
            spared, ram = self.spare({**FOUR_ROWS, "WRE": [enable]}, WREMUX=mux)
            self.assertEqual(spared, {ADDRESS: 4})
            self.assertEqual(ram["connections"]["WRE"], [enable])


if __name__ == "__main__":
    unittest.main()
