# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How a configuration comes from needs and measurements, and the table that says so."""

import unittest
from collections.abc import Sequence

from dynrt_tools.build import configs
from dynrt_tools.project import Failed, Json
from dynrt_tools.specialise import decisions, table
from dynrt_tools.specialise.analyst import FrameCosts
from dynrt_tools.specialise.costs import less

GENERATE = configs.load_configurations()
LISTED = GENERATE.listed()
THESIS = LISTED["thesis"]
WHITTED = LISTED["whitted"]


def decide(
    needed: Json,
    measured: decisions.Measured | None = None,
    keep: Sequence[str] = (),
    general: Json = THESIS,
    name: str = "thesis",
) -> Json:
    """The decisions where the scene needs these values and the rest is as in the general core."""
    needs = {
        key: {"value": value, "reason": f"as in {decisions.called(name)}: nothing decides it"}
        for key, value in general.items()
        if key not in decisions.TEXTS
    }
    needs |= {
        key: {"value": value, "reason": f"the scene needs {value}"} for key, value in needed.items()
    }
    return decisions.decide(GENERATE.KEYS, name, general, needs, measured or {}, keep)


class Decisions(unittest.TestCase):
    def test_every_key_has_a_reason(self) -> None:
        decided = decide({"stack_depth": 14})
        self.assertEqual(set(decided), set(GENERATE.KEYS) - set(decisions.TEXTS))
        for one in decided.values():
            self.assertGreater(len(one["reason"]), 10)
        self.assertEqual(decided["stack_depth"], {"value": 14, "reason": "the scene needs 14"})
        self.assertEqual(decided["mantissa_bits"]["value"], 16)

    def test_what_an_allowed_error_buys_is_told_beside_the_general_core(self) -> None:
        decided = decide({}, {"mantissa_bits": (12, "the cheapest that keeps the bound")})
        self.assertEqual(
            decided["mantissa_bits"], {"value": 12, "reason": "the cheapest that keeps the bound"}
        )
        self.assertIn("mantissa_bits", decisions.left_out(decided, THESIS))

    def test_counters_and_display_go_unless_they_are_kept(self) -> None:
        unused = {"counters": False, "scan_out": False}
        decided = decide(unused)
        self.assertEqual(
            (decided["counters"]["value"], decided["scan_out"]["value"]), (False, False)
        )
        decided = decide(unused | {"stack_depth": 3}, keep=["scan_out", "stack_depth"])
        self.assertEqual(
            (decided["counters"]["value"], decided["scan_out"]["value"]), (False, True)
        )
        self.assertEqual(
            decided["stack_depth"], {"value": 31, "reason": "as in thesis: --keep asks for it"}
        )
        with self.assertRaisesRegex(
            Failed, "^--keep speed: unknown; the keys are pipelines, packets, "
        ):
            decide({}, keep=["speed"])

    def test_the_configuration_is_one_that_can_be_built(self) -> None:
        decided = decide(
            {"stack_depth": 14, "lights": 2, "reflections": 0, "crossing": "none"},
            {"packets": (16, "with 32 a frame takes 100 clocks")},
            (),
            WHITTED,
            "whitted",
        )
        stated = decisions.configuration("lamps", "whitted", decided)
        config = GENERATE.checked("special", stated)
        self.assertEqual(
            (
                config["stack_depth"],
                config["lights"],
                config["packets"],
                config["made_for"],
                config["made_from"],
            ),
            (14, 2, 16, "lamps", "whitted"),
        )
        self.assertIn("stack_depth", decisions.left_out(decided, WHITTED))
        self.assertNotIn("mantissa_bits", decisions.left_out(decided, WHITTED))

    def test_a_general_configuration_that_a_file_states(self) -> None:
        decided = decide({}, name="/folder/mine.json")
        self.assertIn("as in mine: ", decided["mantissa_bits"]["reason"])
        stated = decisions.configuration("lamps", "/folder/mine.json", decided)
        self.assertEqual(
            (stated["about"], stated["made_from"]),
            ("made for the scene lamps, from the configuration mine", "/folder/mine.json"),
        )
        GENERATE.checked("special", stated)


class Table(unittest.TestCase):
    def result(self) -> Json:
        decided = decide({"stack_depth": 14, "lights": 0})
        costs = {
            "general": {"LUT4": 33000, "FF": 20000, "gates": 2800000, "clocks": 1000},
            "special": {"LUT4": 22000, "FF": 20000, "gates": 2100000, "clocks": 1010},
        }
        return {
            "configuration": decided,
            "left_out": decisions.left_out(decided, THESIS),
            "costs": costs,
            "layouts": {},
            "curves": {"packets": {32: 1000, 16: 1010}, "lines": {512: 1010, 256: 1100}},
        }

    def test_what_is_left_out_and_what_it_saves(self) -> None:
        page = table.page("office: one object", "thesis", THESIS, self.result())
        self.assertRegex(page, r"(?m)^  stack_depth +31 +14 +the scene needs 14$")
        self.assertRegex(page, r"(?m)^  LUTs +33,000 +22,000 +33.3 %$")
        self.assertRegex(page, r"(?m)^  clocks of a frame +1,000 +1,010 +1.0 % more$")
        self.assertRegex(page, r"(?m)^  packets +32 +16$")
        self.assertIn("as in thesis: ", page)
        self.assertNotIn("line_nodes   ", page)
        self.assertLessEqual(max(map(len, page.splitlines())), table.WIDTH + 4)

    def test_the_lines_that_were_tried(self) -> None:
        tried = {1: FrameCosts(1200, 6.84)._asdict(), 2: FrameCosts(1000, None)._asdict()}
        page = table.page("office", "thesis", THESIS, self.result() | {"layouts": tried})
        self.assertRegex(page, r"(?m)^  line_nodes +1 +2\n  clocks +1,200 +1,000\n")
        self.assertRegex(page, r"(?m)^  bytes a ray +6.84 +-$")


class Less(unittest.TestCase):
    def test_it_is_a_part_of_the_general_core(self) -> None:
        general: dict[str, int] = {"LUT4": 400, "multiplier": 0, "stages": 95}
        special: dict[str, int] = {"LUT4": 300, "multiplier": 0, "stages": 95}
        self.assertEqual(less(general, special), {"LUT4": 25.0, "stages": 0.0})


if __name__ == "__main__":
    unittest.main()
