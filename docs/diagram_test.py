#!/usr/bin/env python3
# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""docs/diagram_test.py CORE.dot: changes a join and expects docs/diagram to notice."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

DIAGRAM = pathlib.Path(__file__).resolve().parent / "diagram"
SVG = DIAGRAM.parent / "core.svg"
CORE = pathlib.Path(sys.argv.pop()) if len(sys.argv) == 2 else None


class Diagram(unittest.TestCase):
    def check(self, old, new):
        text = CORE.read_text(encoding="utf-8")
        self.assertIn(old, text)
        with tempfile.NamedTemporaryFile("w", suffix=".dot") as changed:
            changed.write(text.replace(old, new))
            changed.flush()
            return subprocess.run([DIAGRAM, changed.name, "--check", SVG], capture_output=True,
                                  text=True, check=False)

    def assert_stale(self, old, new, what):
        result = self.check(old, new)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, f"diagram: {SVG} is stale ({what}); "
                                        "`ninja diagram` draws it anew\n")

    def test_the_picture_is_that_of_the_join(self):
        self.assertEqual(self.check("digraph", "digraph").returncode, 0)

    def test_a_channel_that_goes_elsewhere(self):
        self.assert_stale('"list" -> "list_lookup" [label="list_request"',
                          '"list" -> "mailbox" [label="list_request"',
                          "list->list_cache, list->mailbox")

    def test_a_channel_of_another_name(self):
        self.assert_stale("unit_ray", "ray_in_unit_space", "ray in unit space")

    def test_a_unit_without_a_group(self):
        result = self.check('  "list";\n', '  "list";\n  "light";\n')
        self.assertEqual(result.returncode, 1)
        self.assertIn("the join has boxes without a group: light;", result.stderr)


if __name__ == "__main__":
    if CORE is None:
        sys.exit(__doc__)
    unittest.main()
