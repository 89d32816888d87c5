# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The JSON that every command writes."""

import unittest

from dynrt_tools import project, testing


class WholeNumbers(testing.InFolder):
    def test_they_have_no_decimal_point(self) -> None:
        said = {"clock_ns": 0.0, "rows": [{"n": 2.0, "by": -1.5}, (3.0, True)], "text": "0.0"}
        self.assertEqual(
            project.json_text(said),
            '{"clock_ns": 0, "rows": [{"n": 2, "by": -1.5}, [3, true]], "text": "0.0"}',
        )

    def test_in_files_as_well(self) -> None:
        project.write_rows(self.folder / "rows.json", {"at": 4.0, "runs": [{"n": 5.0}]}, "runs")
        text = (self.folder / "rows.json").read_text(encoding="utf-8")
        self.assertEqual(text, '{\n  "at": 4,\n  "runs": [\n    {"n": 5}\n  ]\n}\n')
        project.write_json(self.folder / "one.json", {"at": 4.0})
        text = (self.folder / "one.json").read_text(encoding="utf-8")
        self.assertEqual(text, '{\n  "at": 4\n}\n')


if __name__ == "__main__":
    unittest.main()
