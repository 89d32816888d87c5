# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Loops of templates."""

import unittest

from dynrt_tools import project
from dynrt_tools.docs import loops


def lines(text: str) -> list[str]:
    """The lines without loops."""
    return [line for _, line in loops.unrolled(text, "t.md")]


class Loops(unittest.TestCase):
    """Texts with loops against texts without."""

    def test_lines_are_repeated(self) -> None:
        text = "a\n{{for x in 1; two}}\n| {x} | {{d:{x}/{x}|.1f}} |\n--\n{{end}}\nz\n"
        expected = ["a", "| 1 | {{d:1/1|.1f}} |", "--", "| two | {{d:two/two|.1f}} |", "--", "z"]
        self.assertEqual(lines(text), expected)

    def test_cells_are_repeated(self) -> None:
        self.assertEqual(lines("|{{for x in a; b}} {x} |{{end}} c |\n"), ["| a | b | c |"])

    def test_a_turn_may_have_two_values_in_lines(self) -> None:
        text = "{{for x=text in\n a=one, two;\n b=three: four}}\n{text} {x}\n{{end}}\n"
        self.assertEqual(lines(text), ["one, two a", "three: four b"])

    def test_loops_stand_in_loops(self) -> None:
        inner = "{x}{y}{{for z in p; q}} {z}{x}{{end}}\n"
        text = "{{for x in a; b}}\n{{for y in 1; 2}}\n" + inner + "{{end}}\n{{end}}\n"
        self.assertEqual(lines(text), ["a1 pa qa", "a2 pa qa", "b1 pb qb", "b2 pb qb"])

    def test_lines_keep_their_numbers(self) -> None:
        text = "a\n{{for x in 1;\n2}}\nb\nc\n{{end}}\nd\n"
        numbers = [number for number, _ in loops.unrolled(text, "t.md")]
        self.assertEqual(numbers, [1, 4, 5, 4, 5, 7])

    def test_a_loop_without_an_end_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "^t.md:2: the loop has no end"):
            lines("a\n{{for x in 1; 2}}\nb\n")

    def test_a_turn_without_a_value_is_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "^t.md:1: each turn of a loop has a value"):
            lines("{{for x=y in a=b; c}}{x}{y}{{end}}\n")


if __name__ == "__main__":
    unittest.main()
