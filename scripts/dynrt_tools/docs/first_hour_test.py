# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of the first hour in a copy of the project.

python3 -m dynrt_tools.docs.first_hour_test BUILD   those that take seconds, with that build
python3 -m dynrt_tools.docs.first_hour_test         all, from a clean copy on, in their order
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
MADE_QUICKLY = ("blocks.png", "moved.png", "blocks.fst")


class Reading(unittest.TestCase):
    """How the page is read."""

    PAGE = (
        "text\n\n```sh\none    # fails\ntwo\n```\n\n```text\nnot this\n```\n\n```sh\ncat a\n```\n"
    )

    def test_commands_and_their_lines(self) -> None:
        found = first_hour.commands(self.PAGE)
        self.assertEqual(
            [(c.line, c.text, c.fails, c.quick) for c in found],
            [
                (4, "one    # fails", True, False),
                (5, "two", False, False),
                (13, "cat a", False, True),
            ],
        )

    def test_a_command_that_ends_otherwise_is_named(self) -> None:
        here = pathlib.Path(".")
        self.assertIsNone(first_hour.run(first_hour.Command(1, "true"), here))
        self.assertIsNone(first_hour.run(first_hour.Command(1, "false # fails"), here))
        problem = first_hour.run(first_hour.Command(7, "echo why; exit 3"), here)
        self.assertEqual(
            problem, "docs/first-hour.md:7: 'echo why; exit 3' ends with exit code 3:\nwhy"
        )


class FirstHour(unittest.TestCase):
    """The page's commands."""

    def test_commands(self) -> None:
        commands = first_hour.commands(first_hour.PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(commands), 10)
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary) / "dynrt"
            first_hour.copy_project(folder)
            if BUILD:
                (folder / "build").mkdir()
                (folder / "build" / "release").symlink_to(BUILD)
                commands = [command for command in commands if command.quick]
                self.assertGreater(len(commands), 6)
            for command in commands:
                problem = first_hour.run(command, folder)
                if problem:
                    self.fail(problem)
            for name in MADE_QUICKLY if BUILD else MADE:
                self.assertTrue((folder / name).exists(), name)
            if not BUILD:
                flat = (folder / "flat.png").read_bytes()
                self.assertNotEqual(flat, (folder / "blocks.png").read_bytes())


if __name__ == "__main__":
    unittest.main()
