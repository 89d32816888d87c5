# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The command lines of `dynrt report error` and `dynrt choose`, with mistakes."""

import json
import unittest

from dynrt_tools import project, testing
from dynrt_tools.report import variants

THESIS = variants.base_configuration("thesis")


class CommandLine(testing.InFolder):
    def assert_mistake(
        self, script: str, arguments: list[str], sentence: str, program_only: bool = False
    ) -> None:
        build = self.folder / "build.json"
        described = {
            "source": str(self.folder),
            "identity": {},
            "program_only": program_only,
        }
        build.write_text(json.dumps(described), encoding="utf-8")
        given = ("--program", "dynrt", "--build", build, "--expect", "f")
        result = testing.run(project.SCRIPTS / script, *given, *arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"dynrt: {sentence}\n")

    def test_mistakes(self) -> None:
        self.assert_mistake(
            "report_error",
            ["--colour"],
            "unrecognized arguments: --colour; dynrt report error --help lists what there is",
        )
        self.assert_mistake("report_error", ["--jobs", "0"], "--jobs 0: at least one is needed")
        self.assert_mistake(
            "report_error",
            ["--variant", "x"],
            "--variant x: unknown; the variants "
            "are " + ", ".join(variants.read_variants(variants.LISTED, THESIS)),
        )
        bound = ["office", "--max-error", "1"]
        scripts: dict[str, list[str]] = {"report_error": [], "choose": bound}
        for script, more in scripts.items():
            self.assert_mistake(
                script,
                more,
                "the sources have changed since this program was built; build it again",
            )
        self.assert_mistake(
            "choose",
            ["office"],
            "the following arguments are required: "
            "--max-error; dynrt choose --help lists what there is",
        )

    def test_a_program_that_was_built_alone(self) -> None:
        commands = {"report_error": list[str](), "choose": ["office", "--max-error", "1"]}
        for script, more in commands.items():
            self.assert_mistake(
                script,
                more,
                "measuring variants needs hlsc, CGAL and Embree, and scripts/demo built this "
                "program without; scripts/test --build-only builds the whole program",
                program_only=True,
            )


if __name__ == "__main__":
    unittest.main()
