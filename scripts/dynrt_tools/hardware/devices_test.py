# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The line that says how LUTs are counted says what is counted."""

import re
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import devices

TERM = re.compile(r"(?:(\d+) x )?(?:\(([^)]+)\)|([\w*]+))(?: \+ |$)")


def terms(formula: str) -> dict[str, float]:
    """How many LUTs the formula gives each type of cell; a * or a set stands for one type of it."""
    _, _, sums = formula.partition(" = ")
    assert "".join(m[0] for m in TERM.finditer(sums)) == sums, formula
    found = {}
    for match in TERM.finditer(sums):
        for cell in (match[2] or match[3]).split(", "):
            found[re.sub(r"\[1-\d\]", "2", cell.replace("*", "X"))] = float(match[1] or 1)
    return found


class Formula(unittest.TestCase):
    def test_each_family_s_is_what_is_counted(self) -> None:
        for family, facts in devices.FAMILIES.items():
            formula = devices.formula(family)
            lut = formula.partition(" ")[0]
            for cell, amount in terms(formula).items():
                taken = devices.resources(family, {cell: 1})
                self.assertEqual(taken[lut], amount, f"{family}: {cell}")
            shown = formula.count(" x ") + 1
            counted = [a for _, amounts in facts["takes"] for a in amounts]
            self.assertEqual(shown, counted.count(lut), family)

    def test_ecp5(self) -> None:
        self.assertEqual(
            devices.formula("ecp5"),
            "LUT4 of the device = LUT4 + 2 x CCU2C + 6 x TRELLIS_DPR16X4",
        )

    def test_the_page_has_it(self) -> None:
        page = (project.ROOT / "docs" / "results" / "devices.md").read_text(encoding="utf-8")
        self.assertIn(f"**{devices.formula('ecp5')}**", page)


if __name__ == "__main__":
    unittest.main()
