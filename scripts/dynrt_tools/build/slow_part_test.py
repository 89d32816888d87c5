# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which slow tests a run of CI takes."""

import pathlib
import subprocess
import unittest
from collections.abc import Sequence
from functools import partial

from dynrt_tools import project, testing
from dynrt_tools.build.slow_part import Part, chosen, commit_number, run_part, run_tests, slow_tests

NAMES = [f"test{number:02}" for number in range(32)]
CTEST_FILE = """
add_test(quick true)
add_test(good true)
set_tests_properties(good PROPERTIES LABELS "system;slow")
add_test(bad.one false)
set_tests_properties(bad.one PROPERTIES LABELS slow TIMEOUT 60)
add_test(slowly true)
set_tests_properties(slowly PROPERTIES LABELS slower)
"""


class Selection(unittest.TestCase):
    """The parts."""

    def test_ten_commits_in_a_row_run_every_test_once(self) -> None:
        for first in (0, 7, 1103):
            taken = [chosen("10", partial(int, n)).take(NAMES) for n in range(first, first + 10)]
            self.assertEqual(sorted(sum(taken, [])), NAMES)
            self.assertLessEqual({len(part) for part in taken}, {3, 4})

    def test_next_round_begins_with_another_test(self) -> None:
        began = {chosen("10", partial(int, n)).take(NAMES)[0] for n in range(3, 43, 10)}
        self.assertEqual(began, {"test03", "test13", "test23"})

    def test_named_part_asks_for_no_commit(self) -> None:
        self.assertEqual(chosen("3/10", self.fail), Part(3, 10))
        self.assertEqual(Part(3, 10).take(NAMES), ["test03", "test13", "test23"])
        self.assertEqual(Part(3, 10).take(NAMES[:2]), [])


class Running(unittest.TestCase):
    """The tests of a part."""

    def run_all(self, passes: Sequence[bool], times: Sequence[bool]) -> tuple[bool, list[str], int]:
        started: list[str] = []
        outcomes, has_time = iter(passes), iter(times)

        def run(names: Sequence[str]) -> bool:
            started.extend(names)
            return next(outcomes)

        passed, left = run_part(NAMES[:5], 2, lambda some: next(has_time), run)
        self.assertEqual(started + left, NAMES[:5])
        return passed, left, len(started)

    def test_all_start_while_there_is_time(self) -> None:
        self.assertEqual(self.run_all([True] * 3, [True] * 3), (True, [], 5))

    def test_none_starts_later(self) -> None:
        self.assertEqual(self.run_all([True], [True, False]), (True, NAMES[2:5], 2))
        self.assertEqual(self.run_all([], [False]), (True, NAMES[:5], 0))

    def test_a_failure_stops_no_other_and_counts(self) -> None:
        self.assertEqual(self.run_all([False, True, True], [True] * 3), (False, [], 5))


class WithCtest(testing.InFolder):
    """ctest's own view."""

    def setUp(self) -> None:
        super().setUp()
        (self.folder / "CTestTestfile.cmake").write_text(CTEST_FILE, encoding="utf-8")

    def test_only_slow_tests_are_listed(self) -> None:
        self.assertEqual(slow_tests(self.folder), {"good": 1500, "bad.one": 60})

    def test_a_test_that_fails_is_noticed(self) -> None:
        self.assertTrue(run_tests(self.folder, ["good"]))
        self.assertFalse(run_tests(self.folder, ["good", "bad.one"]))
        self.assertFalse(run_tests(self.folder, ["bad-one"]), "no pattern matches a name")


class CommitNumber(testing.InFolder):
    """The number that chooses."""

    def git(self, *words: str | pathlib.Path) -> str:
        return subprocess.run(
            ["git", "-c", "user.name=a", "-c", "user.email=a@localhost", *words],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            check=True,
        ).stdout.strip()

    def test_commits_are_counted_and_a_shallow_clone_has_a_number_too(self) -> None:
        whole, shallow = self.folder / "whole", self.folder / "shallow"
        self.git("init", "-q", whole)
        for _ in range(3):
            self.git("-C", whole, "commit", "-q", "--allow-empty", "-m", "One more")
        self.assertEqual(commit_number(whole), 3)
        self.git("clone", "-q", "--depth", "1", f"file://{whole}", shallow)
        head = self.git("-C", whole, "rev-parse", "HEAD")
        self.assertEqual(commit_number(shallow), int(head[:8], 16))

    def test_without_a_repository_the_part_has_to_be_named(self) -> None:
        with self.assertRaisesRegex(project.Failed, "name the part yourself, such as --slow-part"):
            commit_number(self.folder)


if __name__ == "__main__":
    unittest.main()
