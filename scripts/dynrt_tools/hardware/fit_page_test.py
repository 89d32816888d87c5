# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the page of results says of kept placements: above all, whether each is of the Verilog that
there is now."""

import unittest

from dynrt_tools import project
from dynrt_tools.hardware import fit_delays, fit_page, kept_placement, rtl_files
from dynrt_tools.project import Json

PAGE = project.ROOT / "docs" / "results" / "devices.md"


class States(unittest.TestCase):
    def core(self, **changes: object) -> Json:
        verilog = kept_placement.hash_of(rtl_files.CORE, rtl_files.core_files())
        return {"unit": rtl_files.CORE, "config": "thesis", "verilog": verilog} | changes

    def test_a_placement_of_the_checked_in_core_is_of_the_present_verilog(self) -> None:
        self.assertEqual(fit_page.state(self.core()), fit_page.PRESENT)

    def test_another_hash_is_of_an_earlier_one(self) -> None:
        self.assertEqual(fit_page.state(self.core(verilog="0123")), fit_page.EARLIER)

    def test_without_a_hash_nothing_is_claimed(self) -> None:
        self.assertIn("no hash", fit_page.state({"unit": rtl_files.CORE}))

    def test_a_unit_s_verilog_is_only_known_to_a_build(self) -> None:
        with self.assertRaisesRegex(project.Failed, "only a build knows the Verilog of list"):
            fit_page.state(self.core(unit="list"))


class Page(unittest.TestCase):
    def test_it_says_truthfully_which_placements_are_out_of_date(self) -> None:
        page = PAGE.read_text(encoding="utf-8")
        for path in sorted(fit_delays.DATA.glob("fit_*.json")):
            data = project.read_json(path)
            for row in data["placements"]:
                kept = kept_placement.read(fit_delays.file_of(row["placement"]))
                if kept_placement.of_checked_in(kept):
                    present = kept_placement.is_current(kept)
                else:
                    present = row["placement"] not in data["earlier"]
                verilog = fit_page.PRESENT if present else fit_page.EARLIER
                shown = rf"\| `{row['unit']}` \|.*\| {row['placed, ns']:.2f} \|.*\| {verilog} \|"
                self.assertRegex(
                    page, shown, f"{row['placement']}: 'scripts/docs --renew' corrects the page"
                )


if __name__ == "__main__":
    unittest.main()
