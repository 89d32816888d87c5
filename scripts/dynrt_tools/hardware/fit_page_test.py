# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the page of results says of kept placements: above all, whether each is of the Verilog that
there is now."""

import unittest

from dynrt_tools import project
from dynrt_tools.hardware import fit_page, kept_placement, rtl_files
from dynrt_tools.project import Json


class States(unittest.TestCase):
    def core(self, **changes: object) -> Json:
        verilog = kept_placement.hash_of(rtl_files.CORE, rtl_files.core_files())
        return {"unit": rtl_files.CORE, "config": "thesis", "verilog": verilog} | changes

    def test_a_placement_of_the_checked_in_core_is_of_the_present_verilog(self) -> None:
        self.assertEqual(fit_page.state(self.core()), fit_page.PRESENT)

    def test_another_hash_is_of_an_earlier_one(self) -> None:
        self.assertEqual(fit_page.state(self.core(verilog="0123")), fit_page.EARLIER)

    def test_a_unit_s_verilog_is_only_known_to_a_build(self) -> None:
        with self.assertRaisesRegex(project.Failed, "only a build knows the Verilog of list"):
            fit_page.state(self.core(unit="list"))


if __name__ == "__main__":
    unittest.main()
