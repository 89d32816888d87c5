# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The constraints of the board's top: each of its ports is a clock or has a delay, in its direction,
and below a comment with the reason; the period is the one that hlsc schedules for."""

import re
import unittest

from dynrt_tools import project

SDC = project.ROOT / "constraints" / "dynrt_board.sdc"
PORT_SDC = project.ROOT / "constraints" / "memory_port.sdc"  # of ports that not every core has
BOARD = project.ROOT / "rtl" / "board" / "dynrt_board.v"
PORT = re.compile(r"^  (input|output) +(?:wire|reg) +(\[[^]]*\])? *(\w+),?(?: *//.*)?$", re.M)
OPTIONAL = re.compile(r"^`ifdef.*?^`endif$", re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^set_(input|output)_delay -clock clk (\S+) \[get_ports \{([^}]*)\}\]$")
CLOCK = re.compile(r"^create_clock -name \w+ -period (\S+) \[get_ports (\w+)\]$")


def head(optional: bool) -> str:
    """The ports of the top that every core has, or those that some have."""
    text = BOARD.read_text(encoding="utf-8").partition("\n);\n")[0]
    return "\n".join(OPTIONAL.findall(text)) if optional else OPTIONAL.sub("", text)


def ports(optional: bool = False) -> dict[str, str]:
    """The direction of each port of the top; a vector has a * in brackets behind its name."""
    found = PORT.findall(head(optional))
    return {name + ("[*]" if bits else ""): way for way, bits, name in found}


def problems(text: str, optional: bool = False) -> list[str]:
    """What the constraints lack or have too much, as sentences."""
    values: dict[str, str] = {}
    listed: list[str] = []
    constrained: dict[str, str] = {}
    above = ""
    for line in text.splitlines():
        if match := re.match(r"^set (\w+) ([\d.]+)$", line):
            values[match[1]] = match[2]
        elif match := CLOCK.match(line):
            constrained[match[2]] = "input"
        elif match := COMMAND.match(line):
            delay = float(values.get(match[2].removeprefix("$"), match[2]))
            if not 0 < delay < float(values["period_ns"]):
                listed.append(f"a delay of {delay} ns is not within the period")
            constrained |= {port: match[1] for port in match[3].split()}
            if not above:
                listed.append(f"no comment gives the reason for {match[3]}")
        elif line and not line.startswith("#"):
            listed.append(f"cannot read '{line}'")
        above = line
    there = ports(optional)
    listed += [f"{port} has no delay" for port in there if port not in constrained]
    for port, way in constrained.items():
        if there.get(port) != way:
            listed.append(f"{port} is no {way} of the board")
    return listed


class ConstraintsTest(unittest.TestCase):
    """The checked-in file, and the check itself."""

    def setUp(self) -> None:
        self.text = SDC.read_text(encoding="utf-8")

    def test_every_port(self) -> None:
        for optional, least in ((False, 20), (True, 8)):
            self.assertGreater(len(ports(optional)), least)
            declared = re.findall(r"^ *(?:input|output) ", head(optional), re.M)
            self.assertEqual(len(ports(optional)), len(declared))
        self.assertEqual(problems(self.text), [])
        text = PORT_SDC.read_text(encoding="utf-8")
        self.assertEqual(problems(text, optional=True), [])
        missing = problems(text.replace("memory_beat_last_i", ""), optional=True)
        self.assertEqual(missing, ["memory_beat_last_i has no delay"])

    def test_finds_what_is_missing(self) -> None:
        bad = self.text.replace("irq_o}", "irq_i}").replace(
            "$outside_ns [get_ports {rst", "12 [get_ports {rst"
        )
        self.assertEqual(
            problems(bad),
            [
                "a delay of 12.0 ns is not within the period",
                "irq_o has no delay",
                "irq_i is no output of the board",
            ],
        )

    def test_the_period_is_that_of_the_schedules(self) -> None:
        cmake = (project.ROOT / "cmake" / "HlsUnit.cmake").read_text(encoding="utf-8")
        scheduled = project.searched(r"set\(DYNRT_CLOCK_NS ([\d.]+)", cmake)
        period = project.searched(r"^set period_ns ([\d.]+)$", self.text)
        self.assertEqual(float(period[1]), float(scheduled[1]))


if __name__ == "__main__":
    unittest.main()
