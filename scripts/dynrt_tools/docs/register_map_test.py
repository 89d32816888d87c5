# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The register map in C and SystemRDL: a compiler reads the header, and both say what the Verilog
says. That the checked-in files are current is a test of all pages."""

import re
import unittest

from dynrt_tools import project, testing
from dynrt_tools.docs import register_map

TEXT = """\
// A map.
localparam [31:0] ID_VALUE = 32'h44;      // "ID"
localparam [25:0] REG_ID = 26'h000;       // R  ID_VALUE
localparam [25:0] REG_LIMITS = 26'h008;   // R  packets in bits 15:0, cache lines in 31:16
localparam [25:0] REG_CONTROL = 26'h00c;  // W  a one starts
localparam [25:0] REG_IRQ_PENDING = 26'h018; // RW bit 0
localparam [25:0] REG_MEMORY_ERROR = 26'h040; // RW see the bits
localparam [25:0] REG_FRAME = 26'h100;    // RW first
localparam CONTROL_START = 0; // render
localparam CONTROL_RESET = 1; // give up
localparam MEMORY_ERROR_SEEN = 0; // one
localparam MEMORY_ERROR_RESPONSE = 2; // which
"""


class RegisterMap(testing.InFolder):
    def test_a_compiler_gives_the_values_of_the_verilog(self) -> None:
        found = register_map.read()
        self.assertGreater(len(found), 30)
        (self.folder / "dynrt_registers.h").write_text(
            register_map.c_header(found), encoding="utf-8"
        )
        checks = "".join(
            f'_Static_assert(DYNRT_{c.name} == {c.value}, "{c.name}");\n' for c in found
        )
        (self.folder / "check.c").write_text(
            f'#include "dynrt_registers.h"\n#include "dynrt_registers.h"\n{checks}',
            encoding="utf-8",
        )
        command = "clang-19 -std=c11 -Wall -Werror -fsyntax-only check.c".split()
        result = testing.run(*command, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_every_constant_of_the_verilog_is_read(self) -> None:
        text = (project.ROOT / register_map.SOURCE).read_text(encoding="utf-8")
        self.assertEqual(len(register_map.read()), text.count("\nlocalparam "))

    def test_rdl_has_every_register_at_its_address(self) -> None:
        found = register_map.read()
        rdl = register_map.system_rdl(found)
        self.assertEqual(rdl.count("{"), rdl.count("}"))
        stated = dict(re.findall(r"^  \} (\w+)(?:\[\d+\])? @ 0x([0-9a-f]+);$", rdl, re.MULTILINE))
        wanted = {
            c.name.removeprefix("REG_"): f"{c.value:03x}"
            for c in found
            if c.name.startswith("REG_")
        }
        self.assertEqual(stated, wanted)

    def test_rdl_of_a_map(self) -> None:
        rdl = register_map.system_rdl(register_map.constants(TEXT))
        self.assertIn('field { sw = w; hw = r; desc = "give up"; } RESET[1:1];', rdl)
        self.assertIn("field { sw = rw; hw = rw; onwrite = woclr; } VALUE[0:0];", rdl)
        self.assertIn('field { sw = rw; hw = rw; onwrite = woclr; desc = "one"; } SEEN[0:0];', rdl)
        self.assertIn('field { sw = r; hw = w; desc = "which"; } RESPONSE[3:2];', rdl)
        self.assertIn("field { sw = rw; hw = r; } VALUE[31:0];\n  } FRAME[64]", rdl)
        self.assertIn("} FRAME[64] @ 0x100;", rdl)

    def test_a_comment_may_name_the_parts_of_a_register(self) -> None:
        rdl = register_map.system_rdl(register_map.constants(TEXT))
        self.assertIn(
            "    field { sw = r; hw = w; } PACKETS[15:0];\n"
            "    field { sw = r; hw = w; } CACHE_LINES[31:16];\n"
            "  } LIMITS @ 0x008;",
            rdl,
        )

    def test_a_register_must_say_who_reads_and_writes_it(self) -> None:
        with self.assertRaisesRegex(project.Failed, "comment of REG_ID .* begin with R, W or RW"):
            register_map.system_rdl(register_map.constants(TEXT.replace("// R  ID_VALUE", "// id")))


if __name__ == "__main__":
    unittest.main()
