# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""python3 -m dynrt_tools.docs.diagram_test CORE.json: changes a join and expects scripts/diagram to
notice."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
from typing import Any

from dynrt_tools import project

DIAGRAM = project.SCRIPTS / "diagram"
SVG = project.ROOT / "docs" / "pictures" / "core.svg"
CORE = pathlib.Path(sys.argv.pop()) if len(sys.argv) == 2 else None


class Diagram(unittest.TestCase):
    def setUp(self) -> None:
        assert CORE is not None
        self.join = json.loads(CORE.read_text(encoding="utf-8"))

    def check(self, text: str | None = None) -> tuple[int, str]:
        with tempfile.NamedTemporaryFile("w", suffix=".json") as changed:
            changed.write(json.dumps(self.join) if text is None else text)
            changed.flush()
            result = subprocess.run(
                [DIAGRAM, changed.name, "--check", SVG], capture_output=True, text=True, check=False
            )
            return result.returncode, result.stderr.replace(changed.name, "CORE")

    def channel(self, name: str) -> Any:
        return next(c for c in self.join["channels"] if c["name"] == name)

    def assert_stale(self, what: str) -> None:
        self.assertEqual(
            self.check(),
            (1, f"diagram: {SVG} is stale ({what}); `ninja diagram` draws it again\n"),
        )

    def test_the_picture_is_that_of_the_join(self) -> None:
        self.assertEqual(self.check(), (0, ""))

    def test_a_channel_that_goes_elsewhere(self) -> None:
        self.channel("list_request")["to"] = ["mailbox.entry"]
        self.assert_stale("list->list_cache, list->mailbox")

    def test_a_channel_of_another_name(self) -> None:
        self.channel("unit_ray")["name"] = "ray_in_unit_space"
        self.assert_stale("ray in unit space")

    def test_another_unit(self) -> None:
        self.join["units"].append({"name": "light", "module": "light", "group": "Lights"})
        self.assert_stale("light")

    def test_a_group_of_another_name(self) -> None:
        for unit in self.join["units"]:
            unit["group"] = unit["group"].replace("Traversal", "Going down")
        self.assert_stale("Going down")

    def test_a_unit_without_a_group(self) -> None:
        self.join["units"].append({"name": "light", "module": "light", "group": ""})
        self.assertEqual(
            self.check(),
            (
                1,
                "diagram: unit 'light' has no group; call join.group() "
                "before it is named in hls/units/core.h\n",
            ),
        )

    def test_what_is_no_join(self) -> None:
        del self.join["banks"]
        self.assertEqual(
            self.check(),
            (
                1,
                "diagram: CORE is no dynrt_core.json of this project "
                "('banks'); build the target `verilog`\n",
            ),
        )
        self.assertEqual(self.check("{")[0], 1)


if __name__ == "__main__":
    if CORE is None:
        sys.exit(__doc__)
    unittest.main()
