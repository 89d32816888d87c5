# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What hls/configs/generate refuses of lines of several nodes, as refused_test.py of all else."""

import unittest

from generate_case import GenerateCase, listing

BEHIND_PORT: dict[str, object] = {"memory": "port", "scan_out": False}


class RefusedLines(GenerateCase):
    def test_they_lie_behind_a_port(self) -> None:
        for nodes in (2, 4):
            self.assert_refused(
                listing({"line_nodes": nodes, "lines": 512}),
                "configuration 'tiny': with memory \"banks\" the key 'line_nodes' must be 1, as a "
                f"bank gives one node in a clock; it is {nodes}",
            )
        self.assertIn("kLineNodes = 2;", self.written(line_nodes=2, lines=16, **BEHIND_PORT))

    def test_each_way_has_a_line(self) -> None:
        for nodes in (2, 4):
            lines = 4 * nodes
            self.assert_refused(
                listing({"line_nodes": nodes, "lines": lines, **BEHIND_PORT}),
                f"configuration 'tiny': with line_nodes {nodes} the key 'lines' must be {2 * lines} "
                "or more, as a line of list entries takes the place of twice as many, in each of up "
                f"to four ways; it is {lines}",
            )


if __name__ == "__main__":
    unittest.main()
