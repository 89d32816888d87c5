# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of README and first hour in a copy of the project.

python3 -m dynrt_tools.docs.first_hour_test BUILD   both at a small size, with that build
python3 -m dynrt_tools.docs.first_hour_test         the first hour's as they stand, in their order
"""

import pathlib
import sys
import tempfile
import unittest

from dynrt_tools.docs import first_hour

BUILD = pathlib.Path(sys.argv.pop()).resolve() if len(sys.argv) > 1 else None
MADE = (
    "office.png",
    "blocks.png",
    "moved.png",
    "blocks.fst",
    "flat.png",
    "made/configuration.json",
)
MADE_SMALL = (*MADE[:-1], "YOUR.png", "view.html")


class Reading(unittest.TestCase):
    """How the pages are read."""

    PAGE = (
        "text\n\n```sh\none    # fails\ntwo\n```\n\n```text\nnot this\n```\n\n```sh\ncat a\n```\n"
    )
    README = "    scripts/a b   # why\n1. Do `dynrt c` or `scripts/d\ne`:\n\n    scripts   folder\n"

    def test_commands_and_their_lines(self) -> None:
        found = first_hour.commands(self.PAGE)
        self.assertEqual(
            [(c.line, c.text, c.fails) for c in found],
            [(4, "one    # fails", True), (5, "two", False), (13, "cat a", False)],
        )

    def test_commands_of_the_readme(self) -> None:
        found = first_hour.readme_commands(self.README)
        self.assertEqual(
            [(c.line, c.text) for c in found],
            [(1, "scripts/a b"), (2, "dynrt c"), (2, "scripts/d e")],
        )

    def test_a_command_that_ends_otherwise_is_named(self) -> None:
        here = pathlib.Path(".")
        self.assertIsNone(first_hour.run(first_hour.Command(1, "true"), here))
        self.assertIsNone(first_hour.run(first_hour.Command(1, "false # fails"), here))
        problem = first_hour.run(first_hour.Command(7, "echo why; exit 3"), here)
        self.assertEqual(
            problem, "docs/first-hour.md:7: 'echo why; exit 3' ends with exit code 3:\nwhy"
        )


class Pages(unittest.TestCase):
    """The commands of both pages."""

    def setUp(self) -> None:
        self.hour = first_hour.commands(first_hour.PAGE.read_text(encoding="utf-8"))
        self.readme = first_hour.readme_commands(first_hour.README.read_text(encoding="utf-8"))
        self.assertGreater(len(self.hour), 10)
        self.assertGreater(len(self.readme), 10)
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "dynrt"

    def run_all(self, commands: list[first_hour.Command]) -> None:
        for command in commands:
            problem = first_hour.run(command, self.folder)
            if problem:
                self.fail(problem)

    def test_each_exception_is_a_command(self) -> None:
        named = {command.text for command in self.hour + self.readme}
        self.assertLessEqual({*first_hour.SMALL, *first_hour.ELSEWHERE}, named)

    @unittest.skipUnless(BUILD, "needs a build")
    def test_all_at_a_small_size(self) -> None:
        assert BUILD
        first_hour.copy_project(self.folder)
        (self.folder / "build").mkdir()
        (self.folder / "build" / "release").symlink_to(BUILD)
        (self.folder / "YOUR.ply").write_text(first_hour.PLY, encoding="utf-8")
        both = {command.text: command for command in self.hour + self.readme}
        small = [command.small for command in both.values()]
        self.run_all([command for command in small if command])
        for name in MADE_SMALL:
            self.assertTrue((self.folder / name).exists(), name)

    @unittest.skipIf(BUILD, "makes a build of its own")
    def test_the_first_hour_as_it_stands(self) -> None:
        first_hour.copy_project(self.folder)
        self.run_all(self.hour)
        for name in MADE:
            self.assertTrue((self.folder / name).exists(), name)
        flat = (self.folder / "flat.png").read_bytes()
        self.assertNotEqual(flat, (self.folder / "blocks.png").read_bytes())


if __name__ == "__main__":
    unittest.main()
