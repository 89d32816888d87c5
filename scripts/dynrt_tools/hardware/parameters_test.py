# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A module of rtl/lib stops elaboration at a parameter outside its documented range, with a message
that names both; the ends of the range pass. In Verilator, Yosys and Icarus Verilog."""

import unittest
from dataclasses import dataclass

from dynrt_tools import testing
from dynrt_tools.hardware import documented_test, rtl_files
from dynrt_tools.hardware.verilator import remarks

Values = dict[str, int]


@dataclass(frozen=True)
class Rule:
    """What a parameter must be, and values that it must not have."""

    parameter: str
    must: str
    bad: tuple[Values, ...]


def at_least(parameter: str, least: int) -> Rule:
    below = tuple({parameter: value} for value in (least - 1, -7))
    return Rule(parameter, f"must_be_at_least_{least}", below)


def flag(parameter: str) -> Rule:
    return Rule(parameter, "must_be_0_or_1", ({parameter: 2}, {parameter: -1}))


def follows(parameter: str, source: str) -> Rule:
    wrong = ({parameter: 3, source: 16}, {parameter: 5, source: 16}, {parameter: 0, source: 2})
    return Rule(parameter, f"must_follow_from_{source}", wrong)


WIDTH = at_least("WIDTH", 1)
ROWS = at_least("ROWS", 1)
RULES = {
    "hls_arbiter": (at_least("INPUTS", 1), WIDTH),
    "hls_buffer": (WIDTH,),
    "hls_clock_fifo": (
        WIDTH,
        Rule(
            "DEPTH",
            "must_be_a_power_of_two_of_at_least_4",
            ({"DEPTH": 0}, {"DEPTH": 2}, {"DEPTH": 12}, {"DEPTH": -4}),
        ),
    ),
    "hls_counters": (Rule("COUNTERS", "must_be_1_to_256", ({"COUNTERS": 0}, {"COUNTERS": 257})),),
    "hls_delay": (WIDTH, at_least("CLOCKS", 3)),
    "hls_fifo": (
        WIDTH,
        at_least("DEPTH", 1),
        Rule(
            "MARGIN",
            "must_be_0_to_DEPTH_minus_1",
            ({"DEPTH": 4, "MARGIN": 4}, {"DEPTH": 4, "MARGIN": 9}, {"MARGIN": -1}),
        ),
        flag("BOUNDED"),
    ),
    "hls_fork": (at_least("OUTPUTS", 1), WIDTH),
    "hls_ram_1r1w": (
        WIDTH,
        ROWS,
        flag("BLOCK"),
        flag("TORN"),
        at_least("COLUMN", 1),
        follows("ADDR_WIDTH", "ROWS"),
    ),
    "hls_ram_words": (
        WIDTH,
        at_least("WORDS", 2),
        Rule("ROWS", "must_be_a_power_of_two", ({"ROWS": 0}, {"ROWS": 12}, {"ROWS": -4})),
        follows("ROW_BITS", "ROWS"),
        follows("WORD_BITS", "WORDS"),
    ),
    "hls_register_file": (WIDTH, ROWS, follows("ADDR_WIDTH", "ROWS")),
    "hls_reset": (at_least("CLOCKS", 4), at_least("PARTS", 1)),
    "hls_repeat": (
        at_least("COUNT_WIDTH", 1),
        Rule("WIDTH", "must_be_at_least_COUNT_WIDTH", ({"WIDTH": 2, "COUNT_WIDTH": 3},)),
    ),
    "hls_synchroniser": (flag("RESET"),),
}
# Values at the ends of the ranges, and between.
GOOD: dict[str, tuple[Values, ...]] = {
    "hls_arbiter": ({}, {"INPUTS": 1, "WIDTH": 1}, {"INPUTS": 5, "WIDTH": 90}),
    "hls_buffer": ({}, {"WIDTH": 1}, {"WIDTH": 90}),
    "hls_clock_fifo": ({}, {"WIDTH": 1, "DEPTH": 4}, {"WIDTH": 30, "DEPTH": 64}),
    "hls_counters": ({}, {"COUNTERS": 2}, {"COUNTERS": 256}),
    "hls_delay": ({}, {"WIDTH": 1, "CLOCKS": 3}, {"WIDTH": 50, "CLOCKS": 12}),
    "hls_fifo": (
        {},
        {"WIDTH": 1, "DEPTH": 1},
        {"DEPTH": 6, "MARGIN": 5},
        {"DEPTH": 128, "BOUNDED": 1},
    ),
    "hls_fork": ({}, {"OUTPUTS": 1, "WIDTH": 1}, {"OUTPUTS": 5, "WIDTH": 86}),
    "hls_ram_1r1w": (
        {},
        {"WIDTH": 1, "ROWS": 1},
        {"ROWS": 10, "BLOCK": 1, "TORN": 1},
        {"ROWS": 4096},
        {"COLUMN": 3},
    ),
    "hls_ram_words": ({}, {"WIDTH": 1, "WORDS": 2, "ROWS": 1}, {"WORDS": 4, "ROWS": 64}),
    "hls_register_file": ({}, {"WIDTH": 1, "ROWS": 1}, {"ROWS": 10}),
    "hls_reset": ({}, {"CLOCKS": 5}, {"PARTS": 4}),
    "hls_repeat": ({}, {"WIDTH": 1, "COUNT_WIDTH": 1}, {"WIDTH": 32, "COUNT_WIDTH": 4}),
    "hls_synchroniser": ({}, {"RESET": 1}),
}


class ParametersTest(testing.InFolder):
    """The modules of rtl/lib, one by one."""

    def elaborate(self, module: str, values: Values) -> list[tuple[str, int, str]]:
        """Each tool with its exit code and messages on an instance that has these values."""
        library = str(rtl_files.LIBRARY / f"{module}.v")
        top = self.folder / "top.v"
        given = ", ".join(f".{name}({value})" for name, value in values.items())
        parameters = f" #({given})" if values else ""
        top.write_text(f"module top;\n  {module}{parameters} it ();\nendmodule\n", encoding="utf-8")
        tools = {
            "Verilator": ["verilator", "--lint-only", "-Wno-lint", str(top), library],
            "Yosys": [
                *("yosys", "-q", "-p"),
                f"read_verilog {top} {library}; hierarchy -check -top top",
            ],
            "Icarus": ["iverilog", "-g2005", "-o", "/dev/null", str(top), library],
        }
        runs = {tool: testing.run(*command) for tool, command in tools.items()}
        return [(tool, run.returncode, run.stdout + run.stderr) for tool, run in runs.items()]

    def test_bad_values_stop_elaboration(self) -> None:
        for module, rules in RULES.items():
            for rule in rules:
                message = f"{module}_{rule.parameter}_{rule.must}"
                for values in rule.bad:
                    for tool, code, output in self.elaborate(module, values):
                        with self.subTest(module=module, values=values, tool=tool):
                            self.assertNotEqual(code, 0)
                            self.assertIn(message, output)

    def test_good_values_pass(self) -> None:
        for module, choices in GOOD.items():
            for values in choices:
                for tool, code, output in self.elaborate(module, values):
                    with self.subTest(module=module, values=values, tool=tool):
                        self.assertEqual(code, 0, output)
                        self.assertEqual(remarks(output), "")

    def test_every_parameter_has_a_rule(self) -> None:
        modules = {path.stem: path for path in rtl_files.library()}
        self.assertEqual(sorted(RULES), sorted(modules))
        self.assertEqual(sorted(GOOD), sorted(modules))
        for module, path in modules.items():
            declared = documented_test.declarations(path.read_text(encoding="utf-8"))
            self.assertEqual(
                sorted(rule.parameter for rule in RULES[module]), sorted(declared["Parameters"])
            )


if __name__ == "__main__":
    unittest.main()
