# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs a stand-in for Yosys in which ABC aborts, as Debian's does now and then."""

import contextlib
import io
import os
import unittest
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.hardware import synthesis

# Fails in its first FAILURES runs with the sentence ERROR, in its log and on stderr.
STAND_IN = """#!/bin/sh
echo run >> "$RUNS"
while [ "$1" != -l ]; do shift; done
if [ "$(wc -l < "$RUNS")" -le "$FAILURES" ]; then
  echo "ERROR: $ERROR" | tee "$2" >&2
  exit 1
fi
echo done > "$2"
"""
ABORTED = 'ABC: execution of command "berkeley-abc" -s -f /tmp/abc.script failed: return code {}.'


class Yosys(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        testing.write_program(self.folder / "yosys", STAND_IN)

    def run_yosys(self, failures: int, error: str) -> tuple[int, str | None, str]:
        """How often it ran, the sentence with which it failed, and what stands on stderr."""
        runs, sentence, errors = self.folder / "runs", None, io.StringIO()
        runs.unlink(missing_ok=True)
        environment = {
            "PATH": f"{self.folder}:{os.environ['PATH']}",
            "RUNS": str(runs),
            "FAILURES": str(failures),
            "ERROR": error,
        }
        with (
            mock.patch.dict(os.environ, environment),
            mock.patch.object(synthesis, "KEPT", self.folder),
            contextlib.redirect_stderr(errors),
        ):
            try:
                synthesis.run_yosys(["stat"], self.folder, "mailbox")
            except project.Failed as failed:
                sentence = str(failed)
        return len(runs.read_text().splitlines()), sentence, errors.getvalue()

    def test_a_run_that_succeeds_is_the_only_one(self) -> None:
        self.assertEqual(self.run_yosys(0, ""), (1, None, ""))

    def test_after_an_abort_of_abc_it_runs_again(self) -> None:
        again = "mailbox: a signal aborted ABC; Yosys runs again\n"
        for code in (134, 139):
            self.assertEqual(self.run_yosys(1, ABORTED.format(code)), (2, None, again))
        self.assertEqual(self.run_yosys(2, ABORTED.format(134)), (3, None, 2 * again))

    def test_an_abort_that_repeats_is_an_error(self) -> None:
        error = ABORTED.format(134)
        runs, sentence, _ = self.run_yosys(99, error)
        self.assertEqual(
            (runs, sentence),
            (3, f"mailbox: ERROR: {error}; the whole log is {self.folder / 'failed.log'}"),
        )
        self.assertEqual((self.folder / "failed.log").read_text(), f"ERROR: {error}\n")

    def test_after_another_error_it_does_not_run_again(self) -> None:
        for error in (ABORTED.format(1), ABORTED.format(1340), "Module `\\mailbox' not found!"):
            runs, sentence, errors = self.run_yosys(1, error)
            self.assertEqual((runs, errors), (1, ""))
            self.assertIn(error, sentence or "")


if __name__ == "__main__":
    unittest.main()
