# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds scripts/demo against what is checked in: it builds its configuration without hlsc, so the
Verilog and the schedules of that must be under rtl/generated, as the build folder has them.

Its argument is the build folder.
"""

import json
import pathlib
import sys
import unittest

from dynrt_tools import project

ROOT = project.ROOT
BUILD = pathlib.Path(sys.argv.pop()) if len(sys.argv) > 1 else ROOT / "build" / "release"


def demo_configuration() -> str:
    """The configuration that scripts/demo renders with."""
    text = (ROOT / "scripts" / "demo").read_text(encoding="utf-8")
    return project.searched(r"^configuration=(\w+)", text)[1]


class Demo(unittest.TestCase):
    def test_preset_builds_the_configuration(self) -> None:
        presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        program = next(p for p in presets["configurePresets"] if p["name"] == "program")
        self.assertEqual(program["cacheVariables"]["DYNRT_BUILT_IN"], demo_configuration())
        self.assertEqual(program["cacheVariables"]["DYNRT_PROGRAM_ONLY"], "ON")

    def test_verilog_and_schedules_are_checked_in(self) -> None:
        lowered = BUILD / "generated" / demo_configuration()
        checked_in = ROOT / "rtl" / "generated" / demo_configuration()
        made = sorted(p for p in lowered.iterdir() if p.suffix in (".v", ".vh", ".json"))
        self.assertGreater(len(made), 40)
        for path in made:
            twin = checked_in / path.name
            self.assertTrue(twin.is_file(), f"{twin} is missing; ninja update-generated writes it")
            self.assertEqual(
                twin.read_bytes(),
                path.read_bytes(),
                f"{twin} is stale; ninja update-generated renews it",
            )


if __name__ == "__main__":
    unittest.main()
