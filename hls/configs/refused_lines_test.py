# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What hls/configs/generate refuses of lines of several nodes, as refused_test.py of all else."""

import unittest

from generate_case import GenerateCase, listing

BEHIND_PORT: dict[str, object] = {"memory": "port", "scan_out": False}


class RefusedLines(GenerateCase):
    def test_they_lie_behind_a_port(self) -> None:
        for nodes in (2, 4, 8):
            self.assert_refused(
                listing({"line_nodes": nodes, "lines": 512}),
                "configuration 'tiny': with memory \"banks\" the key 'line_nodes' must be 1, as a "
                f"bank gives one node in a clock; it is {nodes}",
            )
        self.assertIn("kLineNodes = 2;", self.written(line_nodes=2, lines=16, **BEHIND_PORT))

    def test_each_way_has_a_line(self) -> None:
        for nodes in (2, 4, 8):
            lines = 4 * nodes
            self.assert_refused(
                listing({"line_nodes": nodes, "lines": lines, **BEHIND_PORT}),
                f"configuration 'tiny': with line_nodes {nodes} the key 'lines' must be {2 * lines} "
                "or more, as a line of list entries takes the place of twice as many, in each of up "
                f"to four ways; it is {lines}",
            )

    def test_one_lies_in_a_line_of_the_second_level(self) -> None:
        why = "as a line of the node cache, 8 bytes for each node, lies in one of the second level"
        wide: dict[str, object] = {
            "lines": 512,
            "second_level": 64,
            "port_bytes": 16,
            **BEHIND_PORT,
        }
        self.assert_refused(
            listing({"line_nodes": 4, "second_line": 16, **wide}),
            f"configuration 'tiny': with line_nodes 4 the key 'second_line' must be 32, {why}; it is "
            "16",
        )
        self.assert_refused(
            listing({"line_nodes": 8, **wide}),
            f"configuration 'tiny': with line_nodes 8 the key 'second_level' must be 0, {why}, which "
            "has 32 at most; it is 64",
        )

    def test_a_read_is_no_longer_than_its_count_of_beats(self) -> None:
        self.assert_refused(
            listing({"line_nodes": 8, "lines": 512, "port_bytes": 2, **BEHIND_PORT}),
            "configuration 'tiny': with line_nodes 8 the key 'port_bytes' must be 4 or more, as a "
            "read has 16 beats at most; it is 2",
        )


if __name__ == "__main__":
    unittest.main()
