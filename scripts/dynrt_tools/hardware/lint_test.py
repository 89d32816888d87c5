# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Plants mistakes in a small tree and expects scripts/lint to find each, and scripts/synth to count
what a known design takes."""

import os
import pathlib
import shutil
import tempfile
import unittest
from typing import Any

from dynrt_tools import project, testing

SCRIPTS = project.SCRIPTS
RAM = """\
module ram (
    input             clk_i,
    input             we_i,
    input      [ 7:0] addr_i,
    input      [31:0] data_i,
    output reg [31:0] data_o
);
  reg [31:0] rows[0:255];
  always @(posedge clk_i) begin
    if (we_i) rows[addr_i] <= data_i;
    data_o <= rows[addr_i];
  end
endmodule
"""
UNIT = """\
module unit (
    input             clk_i,
    input             we_i,
    input      [ 7:0] addr_i,
    input      [16:0] a_i,
    output reg [31:0] product_o
);
  wire [31:0] row;
  ram u_ram (.clk_i(clk_i), .we_i(we_i), .addr_i(addr_i), .data_i(product_o), .data_o(row));
  reg [33:0] product;
  always @(posedge clk_i) begin
    product   <= row[16:0] * a_i;
    product_o <= product[31:0] ^ {30'd0, product[33:32]} ^ {17'd0, row[31:17]};
  end
endmodule
"""
TREE = {
    "rtl/lib/ram.v": RAM,
    "rtl/generated/thesis/unit.v": UNIT,
    "rtl/lint/lib.vlt": "`verilator_config\n",
}


def copy_scripts(root: pathlib.Path) -> None:
    shutil.copytree(SCRIPTS, root / "scripts", ignore=shutil.ignore_patterns("__pycache__"))


class Planted(testing.InFolder):
    def run_script(
        self, extra: dict[str, str], *command: str, env: dict[str, str] | None = None
    ) -> tuple[testing.Result, Any]:
        """What a command does in the small tree with more files, and the figures that it writes."""
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            copy_scripts(root)
            testing.write_tree(root, TREE | extra)
            result = testing.run(root / "scripts" / command[0], *command[1:], cwd=root, env=env)
            figures = root / "figures.json"
            return result, project.read_json(figures) if figures.exists() else None

    def assert_lint(self, extra: dict[str, str], message: str) -> None:
        result, _ = self.run_script(extra, "lint")
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(message, result.stderr)


class Lint(Planted):
    def test_clean_tree_passes(self) -> None:
        result, _ = self.run_script({}, "lint")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "2 Verilog files are clean\n")

    def test_unused_signal(self) -> None:
        self.assert_lint(
            {"rtl/lib/ram.v": RAM.replace("  reg [31:0] rows", "  wire x;\n  reg [31:0] rows")},
            "Signal is not driven, nor used: 'x'",
        )

    def test_waiver_with_reason(self) -> None:
        bad = RAM.replace("  reg [31:0] rows", "  wire x;\n  reg [31:0] rows")
        waiver = (
            "`verilator_config\n// Kept for a later port.\n"
            'lint_off -rule UNUSEDSIGNAL -file "*/rtl/lib/ram.v" -match "*\'x\'*"\n'
        )
        result, _ = self.run_script({"rtl/lib/ram.v": bad, "rtl/lint/lib.vlt": waiver}, "lint")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_waiver_without_reason(self) -> None:
        self.assert_lint(
            {"rtl/lint/lib.vlt": '`verilator_config\nlint_off -rule WIDTH -file "*/ram.v"\n'},
            "rtl/lint/lib.vlt:2: the waiver has no reason",
        )

    def test_waiver_by_line(self) -> None:
        self.assert_lint(
            {
                "rtl/lint/lib.vlt": "`verilator_config\n// Why.\n"
                'lint_off -rule WIDTH -file "*/ram.v" -lines 3\n'
            },
            "rtl/lint/lib.vlt:3: a waiver is written",
        )

    def test_waiver_of_a_file_that_is_gone(self) -> None:
        self.assert_lint(
            {
                "rtl/lint/lib.vlt": "`verilator_config\n// Why.\n"
                'lint_off -rule WIDTH -file "*/gone.v"\n'
            },
            "rtl/lint/lib.vlt:3: no Verilog file matches */gone.v",
        )

    def test_two_drivers_are_refused_by_yosys(self) -> None:
        bad = UNIT.replace("endmodule", "  always @(posedge clk_i) product <= 34'd0;\nendmodule")
        self.assert_lint({"rtl/generated/thesis/unit.v": bad}, "yosys\n")

    def test_missing_module(self) -> None:
        self.assert_lint(
            {"rtl/generated/thesis/unit.v": UNIT.replace("  ram u_ram", "  rom u_ram")},
            "Module `\\rom' referenced in module `\\unit'",
        )

    def test_another_configuration_is_linted_instead(self) -> None:
        bad = UNIT.replace("  wire [31:0] row;", "  wire x;\n  wire [31:0] row;")
        built = {"build/release/generated/huge/unit.v": bad}
        result, _ = self.run_script(built, "lint")
        self.assertEqual(result.returncode, 0, result.stderr)
        flags = ("--config", "huge", "--build", "build/release")
        result, _ = self.run_script(built, "lint", *flags)
        self.assertEqual(result.returncode, 1)
        self.assertIn("verilator: build/release/generated/huge/unit.v\n", result.stderr)
        self.assertIn("Signal is not driven, nor used: 'x'", result.stderr)
        result, _ = self.run_script(built, "lint", "--config", "huge", "--build", "elsewhere")
        self.assertEqual(
            result.stderr,
            "lint: --config huge: there is no Verilog of it in elsewhere/generated/huge\n",
        )

    def test_boards_need_a_build(self) -> None:
        result, _ = self.run_script({"rtl/link/link.v": UNIT.replace("unit", "link")}, "lint")
        self.assertEqual(result.returncode, 1)
        self.assertIn("lint: no build with hlsc is in ", result.stderr)
        self.assertIn("; scripts/test --build-only makes one", result.stderr)

    def test_no_verilog_is_not_a_pass(self) -> None:
        copy_scripts(self.folder)
        result = testing.run(self.folder / "scripts" / "lint")
        self.assertEqual(result.returncode, 1)
        self.assertIn("holds no Verilog", result.stderr)


class Synth(Planted):
    def test_counts(self) -> None:
        result, figures = self.run_script({}, "synth", "unit", "--json", "figures.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        for device in ("ecp5-85", "virtex2-6000"):
            row = figures["devices"][device]["unit"]
            self.assertEqual((row["mult"], row["BRAM"]), (1, 1), device)
            self.assertGreaterEqual(row["LUT"], 15)
            self.assertGreaterEqual(row["FF"], 32)
            taken = figures["resources"][device]["unit"]
            self.assertEqual((taken["multiplier"], taken["block RAM"]), (1, 1), device)
            self.assertGreaterEqual(taken["LUT4"], row["LUT"])
        self.assertIn("Lattice LFE5U-85F (synth_ecp5 -nowidelut)", result.stdout)
        formula = "LUT4 of the device = LUT4 + 2 x CCU2C + 6 x TRELLIS_DPR16X4"
        self.assertEqual(figures["counted"]["ecp5-85"], formula)
        share = figures["shares"]["ecp5-85"]["unit"]["block RAM"]
        self.assertEqual(share, round(100 / figures["has"]["ecp5-85"]["block RAM"], 1))
        self.assertIn(f"\n{formula}, in cells of Yosys\n", result.stdout)
        self.assertRegex(result.stdout, r"(?m)^LUT4 of the device = \(LUT\[1-4\], INV, SRL16")
        self.assertRegex(result.stdout, r"(?m)^unit .* 1   0.5 % +1   0.6 %$")

    def test_a_family_has_areas_alone(self) -> None:
        result, figures = self.run_script(
            {}, "synth", "unit", "--device", "ecp5", "--json", "figures.json"
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(figures["devices"]["ecp5"]["unit"]["mult"], 1)
        self.assertNotIn("of the device", result.stdout)

    def test_unknown_device(self) -> None:
        result, _ = self.run_script({}, "synth", "--device", "ecp5-86")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr,
            (
                "synth: there is no device 'ecp5-86'; the devices are ecp5-85, ice40-hx8k, artix7-100, "
                "artix7-200, virtex2-6000, the families, of which only areas are known, ecp5, ice40, "
                "xc7, xc2v\n"
            ),
        )

    def test_what_fits_no_device_says_what_is_missing(self) -> None:
        large = {
            "rtl/lib/ram.v": RAM.replace("[ 7:0] addr_i", "[15:0] addr_i").replace(
                "[0:255]", "[0:65535]"
            )
        }
        command = ("synth", "ram", "--device", "ice40-hx8k")
        result, _ = self.run_script(large, *command)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(
            result.stderr,
            r"synth: ram does not fit ice40-hx8k: .*\b512 block RAMs of 32, 480 too many",
        )
        result, _ = self.run_script(large, *command, "--device", "ecp5-85")
        self.assertEqual(result.returncode, 0, "it fits one of the two")
        self.assertIn("ram does not fit ice40-hx8k", result.stderr)

    def test_missing_yosys_names_the_package(self) -> None:
        testing.link_tools(self.folder, "python3", "env")
        result, _ = self.run_script({}, "synth", "unit", env={"PATH": str(self.folder)})
        self.assertEqual(result.returncode, 1)
        self.assertIn("synth: yosys is not installed; Debian's package yosys has it", result.stderr)

    def test_what_reads_the_same_is_synthesized_once(self) -> None:
        root = self.folder
        copy_scripts(root)
        testing.write_tree(root, TREE)

        def kept() -> tuple[str, dict[str, int]]:
            result = testing.run(
                root / "scripts/synth",
                *("ram", "--device", "ecp5"),
                env=os.environ | {"DYNRT_CACHE": str(root / "cache")},
            )
            self.assertEqual(result.returncode, 0, result.stderr)
            entries = [p for p in (root / "cache").glob("area-*") if p.is_dir()]
            return result.stdout, {p.name: p.stat().st_mtime_ns for p in entries}

        first = kept()
        (root / "rtl/lib/ram.v").write_text("// A comment.\n" + RAM, encoding="utf-8")
        self.assertEqual(kept(), first)
        (root / "rtl/lib/ram.v").write_text(RAM.replace("31:0", "15:0"), encoding="utf-8")
        self.assertEqual(len(kept()[1]), 2)

    def test_unknown_unit(self) -> None:
        for name, question in (("mailbox", ""), ("units", " (did you mean unit?)")):
            result, _ = self.run_script({}, "synth", name)
            self.assertEqual(result.returncode, 1)
            self.assertEqual(
                result.stderr,
                f"synth: there is no unit '{name}'{question}; the units are ram, unit\n",
            )

    def test_unknown_configuration(self) -> None:
        result, _ = self.run_script({}, "synth", "--config", "huge")
        self.assertEqual(result.returncode, 1)
        self.assertIn(
            "synth: --config huge: its Verilog is not checked in, and no build with hlsc is in ",
            result.stderr,
        )

    def test_output_is_checked_before_the_work(self) -> None:
        result, _ = self.run_script({}, "synth", "no_such_unit", "--json", "no/where/x.json")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr,
            "synth: --json no/where/x.json: there is no folder "
            "'no/where'; create it or name a file elsewhere\n",
        )
        result, _ = self.run_script({}, "synth", "no_such_unit", "--json", "rtl")
        self.assertEqual(
            result.stderr, "synth: --json rtl: cannot be written; name a file that can\n"
        )

    def test_what_cannot_be_synthesized_is_a_failure(self) -> None:
        bad = UNIT.replace("  ram u_ram", "  rom u_ram")
        result, _ = self.run_script(
            {"rtl/generated/thesis/unit.v": bad}, "synth", "unit", "--device", "ecp5"
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn("synth: unit on ecp5: ERROR: Module `\\rom'", result.stderr)


if __name__ == "__main__":
    unittest.main()
