# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Flags that several commands have: what is no number of jobs is refused by each."""

import unittest

from dynrt_tools import project, testing

COMMANDS = {
    "place": (),
    "fit-delays": (),
    "synth": (),
    "gates": (),
    "configuration": ("none.json",),
}


class Jobs(unittest.TestCase):
    def test_less_than_one_is_refused(self) -> None:
        for name, words in COMMANDS.items():
            for jobs in ("0", "-1", "two"):
                with self.subTest(name, jobs=jobs):
                    done = testing.run(project.SCRIPTS / name, *words, f"--jobs={jobs}")
                    self.assertEqual((done.returncode, done.stdout), (2, ""))
                    self.assertTrue(
                        done.stderr.endswith(
                            f"scripts/{name}: error: argument --jobs: '{jobs}' is not a whole "
                            "number above 0\n"
                        ),
                        done.stderr,
                    )


if __name__ == "__main__":
    unittest.main()
