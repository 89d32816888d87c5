# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Plants includes that point the wrong way in a small tree and expects scripts/check-layers to
name each of them."""

import sys
import unittest

from dynrt_tools import project, testing

SCRIPT = project.SCRIPTS / "check-layers"
RIGHT = {
    "hls/include/hls/int.h": "#include <cstdint>\n",
    "hls/include/hls/float.h": '#include "hls/int.h"\n#include "hls/ports.h"\n',
    "hls/native/hls/ports.h": '#include "hls/int.h"\n',
    "hls/units/memory_format.h": '#include "hls/float.h"\n',
    "hls/units/core_model.h": '#include "units/memory_format.h"\n',
    "hls/units/mailbox.h": '#include "memory_format.h"\n#include "hls/ports.h"\n',
    "hls/compiler/emit/emit.h": "#include <string>\n",
    "hls/compiler/emit/emit.cpp": '#include "emit/emit.h"\n#include "hls/int.h"\n',
    "host/board/model_board.h": '#include "units/core_model.h"\n',
    "host/memory/pack.h": '#include "units/memory_format.h"\n#include "fmt/format.h"\n',
    "verif/unit/mailbox_cosim.cpp": '#include "units/mailbox.h"\n#include "host/memory/pack.h"\n',
}


class CheckLayers(testing.InFolder):
    def run_on(self, extra: dict[str, str]) -> testing.Result:
        testing.write_tree(self.folder, RIGHT | extra)
        return testing.run(sys.executable, SCRIPT, self.folder)

    def assert_refused(self, source: str, text: str, message: str) -> None:
        result = self.run_on({source: text})
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn(message, result.stderr)

    def test_right_tree_passes(self) -> None:
        result = self.run_on({})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("13 includes, all pointing the right way", result.stdout)

    def test_language_knows_no_unit(self) -> None:
        self.assert_refused(
            "hls/include/hls/bad.h",
            '\n#include "units/mailbox.h"\n',
            "hls/include/hls/bad.h:2: includes hls/units/mailbox.h, but "
            "hls/include may include only hls/include, hls/lowered, hls/native",
        )

    def test_unit_knows_no_host(self) -> None:
        self.assert_refused(
            "hls/units/bad.h",
            '#include "../../host/memory/pack.h"\n',
            "hls/units/bad.h:1: includes host/memory/pack.h",
        )

    def test_back_end_knows_no_front_end(self) -> None:
        result = self.run_on(
            {
                "hls/compiler/frontend/read.h": "#include <string>\n",
                "hls/compiler/passes/bad.h": '#include "frontend/read.h"\n',
            }
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn(
            "hls/compiler/passes/bad.h:1: includes hls/compiler/frontend/read.h", result.stderr
        )

    def test_compiler_knows_no_unit(self) -> None:
        self.assert_refused(
            "hls/compiler/bad.cpp",
            "#  include <units/mailbox.h>\n",
            "hls/compiler/bad.cpp:1: includes hls/units/mailbox.h",
        )

    def test_host_knows_only_what_is_published(self) -> None:
        self.assert_refused(
            "host/app/bad.cpp",
            '#include "units/mailbox.h"\n',
            "includes hls/units/mailbox.h, but host/app may include only",
        )

    def test_only_the_board_runs_the_model(self) -> None:
        self.assert_refused(
            "host/app/bad.cpp",
            '#include "units/core_model.h"\n',
            "host/app/bad.cpp:1: includes hls/units/core_model.h",
        )

    def test_a_room_of_the_host_knows_those_before_it(self) -> None:
        self.assert_refused(
            "host/memory/bad.h",
            '#include "host/board/model_board.h"\n',
            "host/memory/bad.h:1: includes host/board/model_board.h, but host/memory may include "
            "only",
        )

    def test_only_the_program_includes_the_program(self) -> None:
        result = self.run_on(
            {
                "host/app/flags.h": "#pragma once\n",
                "verif/core/bad.cpp": '#include "host/app/flags.h"\n',
            }
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn("verif/core/bad.cpp:1: includes host/app/flags.h", result.stderr)

    def test_nothing_includes_verification(self) -> None:
        self.assert_refused(
            "host/app/bad.cpp",
            '#include "verif/unit/mailbox_cosim.cpp"\n',
            "host/app/bad.cpp:1: includes verif/unit/mailbox_cosim.cpp",
        )

    def test_wrong_folder_is_not_a_pass(self) -> None:
        result = testing.run(sys.executable, SCRIPT, self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("is this the project's folder?", result.stderr)


if __name__ == "__main__":
    unittest.main()
