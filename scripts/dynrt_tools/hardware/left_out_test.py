# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The Verilog of a configuration lacks the parts that it does not need, and has those that it needs.

Usage: python3 -m dynrt_tools.hardware.left_out_test GENERATED

GENERATED is the folder that has a folder of units for every configuration.
"""

import pathlib
import re
import sys
import unittest

GENERATED = pathlib.Path(sys.argv.pop(1))
STAGE = re.compile(r"^ +\d+ +\d+ +[\d.]+ +(?P<operations>\d+ .*)$", re.MULTILINE)

# Units by the configurations that have them; those beside them, whose Verilog is whole too, do not.
UNITS: dict[str, set[str]] = {
    "secondary_rays": {"whitted", "fast_lit"},
    "shader": {"whitted", "fast_lit"},
    "light_columns": {"whitted", "fast_lit"},
    "camera_rays": {"fast", "fast_lit", "fast_watertight"},
    "world_box": {"fast", "fast_lit", "fast_watertight"},
    "ray_reciprocal": {"fast", "fast_lit", "fast_watertight"},
    "ray_shear": {"watertight"},
}
WHOLE = ("thesis", "full", "fast", "fast_lit", "fast_watertight", "watertight", "whitted")

# What is left out, of which unit: the configuration without it takes fewer operations, of all kinds or
# of the one that is named (numbers are compared with zero by their signs).
PARTS = {
    "tolerance at a triangle's edges": ("intersection", "thesis", "slack", "lt"),
    "spheres beside rectangles": ("intersection", "slack", "primitives"),
    "rectangles": ("intersection", "thesis", "slack"),
    "memory of children that crossing rays want first": ("packet_decision", "thesis", "whitted"),
    "packets split where rays cross": ("packet_decoder", "thesis", "split"),
    "slots for objects": ("packet_mailbox", "lean", "thesis"),
    "slots for objects and triangles": ("packet_mailbox", "one_level", "lean"),
    "a second level": ("node_fetch", "one_level", "thesis"),
    "a second level in packets": ("packet_decoder", "one_level", "thesis"),
    "packets of several origins": ("send_packet", "lean", "thesis"),
}


def operations(config: str, unit: str, kind: str = r"\w+") -> int:
    """The number of operations of a unit, in all its stages."""
    report = (GENERATED / config / f"{unit}.txt").read_text(encoding="utf-8")
    stages = [match["operations"] for match in STAGE.finditer(report)]
    return sum(int(number) for stage in stages for number in re.findall(rf"(\d+) {kind}\b", stage))


class LeftOut(unittest.TestCase):
    def test_units_are_only_where_they_are_needed(self) -> None:
        for unit, needed in UNITS.items():
            having = {config for config in WHOLE if (GENERATED / config / f"{unit}.v").exists()}
            self.assertEqual(having, needed, unit)

    def test_the_core_joins_no_other(self) -> None:
        for config in WHOLE:
            core = (GENERATED / config / "dynrt_core.v").read_text(encoding="utf-8")
            for unit, needed in UNITS.items():
                self.assertEqual(
                    re.search(rf"^  {unit}\b", core, re.MULTILINE) is not None,
                    config in needed,
                    f"{unit} in {config}",
                )

    def test_units_lack_the_parts_that_are_not_needed(self) -> None:
        for what, (unit, without, having, *kind) in PARTS.items():
            with self.subTest(what):
                self.assertGreater(operations(without, unit, *kind), 0)
                self.assertLess(operations(without, unit, *kind), operations(having, unit, *kind))


if __name__ == "__main__":
    unittest.main()
