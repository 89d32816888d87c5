# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which modules scripts/try takes, and what it says of them."""

import contextlib
import io
import pathlib
import unittest
from collections.abc import Callable

from dynrt_tools import testing
from dynrt_tools.build import try_unit
from dynrt_tools.build.try_unit import Failed, Module, Refused, chosen

MODULES = [
    Module("thesis", "list", "list", "cosim_list"),
    Module("thesis", "node_lookup", "cache_lookup", "cosim_cache_lookup"),
    Module("thesis", "list_lookup", "cache_lookup", "cosim_cache_lookup"),
    Module("whitted", "shader", "shader", "cosim_whitted_shader"),
    Module("fast", "list", "quick_list", "cosim_fast_quick_list"),
]


class Steps(try_unit.Trial):
    """A trial whose steps are given."""

    def __init__(self, given: list[tuple[str, Callable[[], str]]]) -> None:
        super().__init__(pathlib.Path("build"), MODULES[:1])
        self.given = given

    def steps(self) -> list[tuple[str, Callable[[], str]]]:
        return self.given


def fails() -> str:
    """A step that does not pass."""
    raise Failed("list.h:7: wrong")


class TryUnit(testing.InFolder):
    """One test for each decision."""

    def test_all_modules_of_a_header_are_taken(self) -> None:
        """They share a native test and a co-simulation."""
        for unit in ("node_lookup", "cache_lookup"):
            self.assertEqual(chosen(MODULES, unit, None), MODULES[1:3])

    def test_first_configuration_that_has_the_unit(self) -> None:
        """Not thesis alone."""
        self.assertEqual(chosen(MODULES, "shader", None), MODULES[3:4])
        self.assertEqual(MODULES[3].target, "whitted_shader_verilog")
        self.assertEqual(MODULES[0].target, "list_verilog")

    def test_a_module_may_have_another_header_in_another_configuration(self) -> None:
        """Either name finds it there."""
        self.assertEqual(chosen(MODULES, "list", None), MODULES[:1])
        self.assertEqual(chosen(MODULES, "list", "fast"), MODULES[4:])
        self.assertEqual(chosen(MODULES, "quick_list", None), MODULES[4:])
        with self.assertRaisesRegex(Refused, "'thesis' has no co-simulation of unit 'quick_list'"):
            chosen(MODULES, "quick_list", "thesis")

    def test_unknown_names_are_refused(self) -> None:
        """With those that there are."""
        with self.assertRaisesRegex(
            Refused, r"no unit 'lists' \(.*; the units are list, list_lookup"
        ):
            chosen(MODULES, "lists", None)
        with self.assertRaisesRegex(Refused, "'full' has no co-simulation of unit 'list'.*thesis"):
            chosen(MODULES, "list", "full")

    def test_folder_without_a_build(self) -> None:
        """Says how to make one; reads what a build has written."""
        with self.assertRaisesRegex(Refused, "run scripts/test --build-only"):
            try_unit.read_modules(self.folder)
        (self.folder / "cosimulated_units.txt").write_text("thesis|list|list|cosim_list\n")
        self.assertEqual(try_unit.read_modules(self.folder), MODULES[:1])

    def test_no_test_is_no_success(self) -> None:
        """GoogleTest is content with zero tests."""
        self.assertEqual(try_unit.tests_in("[  PASSED  ] 12 tests.\n"), "12 tests")
        for output in ("", "[  PASSED  ] 0 tests.\n"):
            with self.assertRaisesRegex(Failed, "no test was run"):
                try_unit.tests_in(output)

    def test_stops_at_the_first_failure(self) -> None:
        """And prints a line for each step before."""
        for given, good, lines in (
            ([("build", lambda: "3 steps"), ("lint", lambda: "no warning")], True, 3),
            ([("build", lambda: "3 steps"), ("lint", fails), ("more", fails)], False, 2),
        ):
            out, errors = io.StringIO(), io.StringIO()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
                self.assertEqual(try_unit.try_unit(Steps(given)), good)
            self.assertEqual(len(out.getvalue().splitlines()), lines)
            self.assertEqual("list.h:7: wrong" in errors.getvalue(), not good)


if __name__ == "__main__":
    unittest.main()
