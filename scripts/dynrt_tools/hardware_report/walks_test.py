# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The means of the frames of a walk, computed by hand."""

import unittest

from dynrt_tools.hardware_report import walks
from dynrt_tools.project import Json


def frame(cycles: int, use: float, lookups: int, misses: int, read: int) -> Json:
    return {
        "packets": 4,
        "cache_lines": 2,
        "width": 32,
        "height": 24,
        "cycles": cycles,
        "units": {"list": {"utilisation": use}},
        "caches": {"node": {"lookups": lookups, "misses": misses}},
        "memory": {"bytes_read": read, "pixel_bytes_written": 3072, "hit_bytes_written": 0},
    }


class Walks(unittest.TestCase):
    def test_a_share_is_one_of_the_clocks_or_lookups_of_all_frames(self) -> None:
        found = walks.mean([frame(1000, 0.5, 100, 10, 800), frame(3000, 0.1, 300, 90, 200)])
        self.assertEqual((found["cycles"], found["most_cycles"]), (2000, 3000))
        self.assertAlmostEqual(found["units"]["list"]["utilisation"], (500 + 300) / 4000)
        self.assertAlmostEqual(found["caches"]["node"]["hit_rate"], 1 - 100 / 400)
        self.assertEqual(found["memory"]["bytes_read"], 500)
        self.assertEqual(found["memory"]["pixel_bytes_written"], 3072)

    def test_a_cache_that_nobody_asks(self) -> None:
        found = walks.mean([frame(1000, 0.5, 0, 0, 0)])
        self.assertEqual(found["caches"]["node"]["hit_rate"], 0)


if __name__ == "__main__":
    unittest.main()
