# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The command lines of `dynrt report error` and `dynrt choose`, with mistakes."""

import json
import unittest

from dynrt_tools import project, testing
from dynrt_tools.report import variants

THESIS = variants.base_configuration("thesis")


class CommandLine(testing.InFolder):
    def assert_mistake(self, script: str, arguments: list[str], sentence: str) -> None:
        build = self.folder / "build.json"
        build.write_text(json.dumps({"source": str(self.folder), "identity": {}}), encoding="utf-8")
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


if __name__ == "__main__":
    unittest.main()
