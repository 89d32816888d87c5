# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of frames, as the data of the page that says what each idea brings."""

import pathlib
import shutil
import tempfile
import unittest

from dynrt_tools import project
from dynrt_tools.docs import ideas

FRAME = """\
#!/usr/bin/python3
import json, sys
scheduled = "--schedule" in sys.argv
if "refused" in sys.argv:
    sys.exit("dynrt: no such scene")
cache = {"lookups": 8, "misses": 2, "hit_rate": 0.75}
frame = {"cycles": 100, "caches": {"matrix": cache, "node": cache},
         "counters": {"node_fetch.transactions": 7}}
if scheduled:
    frame["cycles_by_schedule"] = True
path = sys.argv[sys.argv.index("--json") + 1]
json.dump({"frame": frame}, open(path, "w"))
"""


class Ideas(unittest.TestCase):
    """A build whose program stands in for dynrt."""

    def setUp(self) -> None:
        self.build = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.build)
        (self.build / "dynrt").write_text(FRAME, encoding="utf-8")
        (self.build / "dynrt").chmod(0o755)
        (self.build / "generated" / "thesis").mkdir(parents=True)

    def test_clocks_are_those_of_schedules(self) -> None:
        data = self.build / "ideas.json"
        ideas.measure(self.build, data)
        rows = project.read_json(data)["frames"]
        self.assertEqual(len(rows), len(ideas.FRAMES))
        self.assertEqual(rows[0]["clocks"], 100)  # thesis
        self.assertIsNone(rows[1]["clocks"])  # compact, without schedules
        self.assertEqual(rows[0]["lines read"], 4)
        self.assertEqual(project.read_json(data)["crossing"], {"remember": 0, "split": 0})
        self.assertEqual(rows[0]["columns in the cache"], 0.75)

    def test_a_frame_that_fails_is_named(self) -> None:
        with self.assertRaisesRegex(
            project.Failed, "render refused .* fails: dynrt: no such scene"
        ):
            ideas.render(self.build, "refused", "thesis", ())

    def test_a_folder_without_the_program_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "has no dynrt; build it"):
            ideas.measure(self.build / "generated")


if __name__ == "__main__":
    unittest.main()
