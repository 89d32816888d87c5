# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Moves the registers behind products and behind block RAM into the multipliers and block RAMs of
ECP5, which have some of their own and which Yosys leaves unused. A value then has one way to go between
two registers and not two: such a block lies in one of a few columns of the chip.

A register moves if each bit of the block's output goes to one flip-flop and nowhere else, all of the
block's clock, and none has an enable, a reset or an initial value of one, as the stages of hlsc have
it."""

import pathlib
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from dynrt_tools import project
from dynrt_tools.project import read_json, write_json

FLIP_FLOP, MULTIPLIER, BLOCK_RAM = "TRELLIS_FF", "MULT18X18D", "DP16KD"


@dataclass(frozen=True)
class Output:
    """An output of a block with a register of its own: always enabled, never reset, and zero at the
    start."""

    bits: str  # the pattern of its ports' names
    registered: dict[str, str]  # parameters that put the register to use
    clocks: list[str]  # ports of its clock
    enables: list[str]  # ports that are of no use without the register
    resets: list[str]


# Lattice FPGA-TN-02205, "ECP5 and ECP5-5G sysDSP Usage Guide".
PRODUCT = Output(
    r"P\d+$",
    {"REG_OUTPUT_CLK": "CLK0", "REG_OUTPUT_CE": "CE0", "REG_OUTPUT_RST": "RST0"},
    ["CLK0"],
    ["CE0"],
    ["RST0"],
)
# Lattice FPGA-TN-02204, "ECP5 and ECP5-5G Memory Usage Guide". A port of 36 bits has the outputs of
# both.
PORT_A, PORT_B, BOTH_PORTS = (
    Output(
        rf"DO[{ports}]\d+$",
        {f"REGMODE_{port}": "OUTREG" for port in ports},
        [f"CLK{port}" for port in ports],
        [f"OCE{port}" for port in ports],
        [f"RST{port}" for port in ports],
    )
    for ports in ("A", "B", "AB")
)
WIDE = 36  # bits of a port that has the outputs of both


def version() -> str:
    """Of this file: what is made of a netlist depends on all of it."""
    return project.hash_of_files([pathlib.Path(__file__)])


def pack(netlist: pathlib.Path) -> Counter[str]:
    """Changes the file that Yosys wrote of a flat design; gives how many registers have moved into
    blocks of each type."""
    design: Any = read_json(netlist)
    moved: Counter[str] = Counter()
    for module in design["modules"].values():
        moved += _pack(module)
    if moved:
        write_json(netlist, design)
    return moved


def loads_of(module: Any) -> Counter[object]:
    """How many inputs each bit of a netlist's module goes to."""
    loads: Counter[object] = Counter()
    for cell in module["cells"].values():
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] == "input":
                loads.update(bits)
    for port in module["ports"].values():
        if port["direction"] == "output":
            loads.update(port["bits"])
    return loads


def _outputs(cell: Any) -> list[Output]:
    """Of a block in a netlist; of any other cell none."""
    if cell["type"] == BLOCK_RAM:
        wide = int(cell["parameters"]["DATA_WIDTH_B"], 2) == WIDE
        return [BOTH_PORTS] if wide else [PORT_A, PORT_B]
    return [PRODUCT] if cell["type"] == MULTIPLIER else []


def _pack(module: Any) -> Counter[str]:
    cells = module["cells"]
    loads = loads_of(module)
    takes = {
        bit: name
        for name, cell in cells.items()
        if cell["type"] == FLIP_FLOP
        for bit in cell["connections"]["DI"]
    }
    moved: Counter[str] = Counter()
    for cell in cells.values():
        for output in _outputs(cell):
            behind = dict(_behind(module, cell, output, loads, takes))
            clocks = {cells[name]["connections"]["CLK"][0] for name in behind.values() if name}
            if not behind or not all(behind.values()) or not _serves(cell, output, clocks):
                continue
            _move(module, cell, output, behind, clocks.pop())
            moved[cell["type"]] += 1
    for name in [name for name, cell in cells.items() if cell["type"] == "moved"]:
        del cells[name]
    return moved


def _behind(
    module: Any, cell: Any, output: Output, loads: Counter[object], takes: dict[object, str]
) -> Iterator[tuple[str, str]]:
    """The ports in use of a block's output, each with the flip-flop that could move, or empty."""
    for port, bits in cell["connections"].items():
        if re.match(output.bits, port) and bits and loads[bits[0]]:
            name = takes.get(bits[0], "")
            alone = loads[bits[0]] == 1 and name and _is_plain(module["cells"][name])
            yield port, name if alone else ""


def _serves(cell: Any, output: Output, clocks: set[object]) -> bool:
    """Whether the block's register does what flip-flops of these clocks do."""
    ends, parameters = cell["connections"], cell["parameters"]
    never_reset = all(ends.get(port, ["0"]) in ([], ["0"]) for port in output.resets)
    same_clock = len(clocks) == 1 and all(
        ends.get(port, []) in ([], list(clocks)) for port in output.clocks
    )
    rising = all(parameters.get(f"{port}MUX", port) == port for port in output.clocks)
    return never_reset and same_clock and rising


def _move(module: Any, cell: Any, output: Output, behind: dict[str, str], clock: Any) -> None:
    for port, name in behind.items():
        flip_flop = module["cells"][name]
        cell["connections"][port] = flip_flop["connections"]["Q"]
        flip_flop["type"] = "moved"
    cell["parameters"].update(output.registered)
    enabled = {port: "1" for port in output.enables}
    never_reset = {port: "0" for port in output.resets}
    clocked = {port: clock for port in output.clocks}
    for port, value in {**enabled, **never_reset, **clocked}.items():
        cell["connections"][port] = [value]
        cell["port_directions"][port] = "input"


def _is_plain(flip_flop: Any) -> bool:
    """Whether it takes its input with every rising edge, has no reset, and is zero at the start."""
    ends, parameters = flip_flop["connections"], flip_flop["parameters"]
    # Yosys writes a string of digits with a blank behind it.
    enabled = parameters.get("CEMUX", "1").strip() == "1"
    never_reset = ends.get("LSR", ["0"]) in ([], ["0"])
    starts_with_zero = parameters.get("REGSET", "RESET") == "RESET"
    rising = parameters.get("CLKMUX", "CLK") == "CLK"
    return enabled and never_reset and starts_with_zero and rising
