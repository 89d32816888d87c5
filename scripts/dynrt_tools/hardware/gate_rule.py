# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Gates of a Virtex-II netlist by the thesis's rule (table 7.2), and the bits of its memories.

The rule is the worst case of XAPP059, in NAND gates: full adder 9; flip-flop 6, with a clock enable
8; LUT of four inputs up to 9, of three up to 6; memory bit 4, and a bit of a dual-port memory is two;
an 18-bit multiplier 7,000 (thesis 7.1.1). What it leaves open is read so:
  - a full adder is a place in a carry chain, that is MUXCY, XORCY or both at one operand, with the
    LUT of one or two inputs that feeds it alone; what more a LUT computes there is counted as a LUT;
  - a LUT of two inputs is one of three, an inverter is one gate;
  - a flip-flop with a synchronous set or reset costs what one with an enable costs;
  - a memory is dual-port if its ports have different addresses; each further read port is a copy.
"""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy
from dynrt_tools.hardware import source_names
from dynrt_tools.project import Failed, Json

FULL_ADDER, FLIP_FLOP, FLIP_FLOP_ENABLED = 9, 6, 8
LUT = {"LUT4": 9, "LUT3": 6, "LUT2": 6, "LUT1": 1, "INV": 1}
MEMORY_BIT, MULTIPLIER = 4, 7000
FREE = ("BUFG", "BUF", "GND", "VCC", "$scopeinfo")


class Uncounted(Failed):
    """A cell that the rule has nothing for, in a sentence."""


@dataclass(frozen=True)
class Memory:
    """A memory of `rows` rows of `width` bits; a bit of it counts `ports` times."""

    name: str
    rows: int
    width: int
    ports: int

    @property
    def bits(self) -> int:
        return self.rows * self.width * self.ports


@dataclass(frozen=True)
class Count:
    cells: Counter[
        str
    ]  # full adders, LUTs by inputs, flip-flops with and without enable, multipliers
    memories: tuple[Memory, ...]

    @property
    def logic(self) -> int:
        """Gates of all but the memories."""
        kinds = {
            "full adder": FULL_ADDER,
            "flip-flop": FLIP_FLOP,
            "flip-flop with enable": FLIP_FLOP_ENABLED,
            "multiplier": MULTIPLIER,
            **LUT,
        }
        return sum(kinds[kind] * count for kind, count in self.cells.items())

    @property
    def bits(self) -> int:
        return sum(m.bits for m in self.memories)


def count(cells: dict[str, Json]) -> Count:
    """Counts the cells of a module as Yosys writes them to JSON, memories as $mem_v2."""
    loads = Counter(
        bit
        for cell in cells.values()
        for port, bits in cell["connections"].items()
        if cell.get("port_directions", {}).get(port, "input") == "input"
        for bit in bits
    )
    operands: Counter[int] = Counter()
    constant = 0  # places in carry chains by their operand's net
    for cell in cells.values():
        port = {"MUXCY": "S", "XORCY": "LI"}.get(cell["type"])
        if port:
            (bit,) = cell["connections"][port]
            if isinstance(bit, int):
                operands[bit] += 1
            elif cell["type"] == "MUXCY":
                constant += 1
    total, memories = Counter({"full adder": len(operands) + constant}), []
    for name, cell in cells.items():
        kind, ends = cell["type"], cell["connections"]
        if kind in LUT:
            (out,) = ends["O"]
            alone = out in operands and loads[out] == operands[out]
            if not (alone and kind in ("INV", "LUT1", "LUT2")):
                total[kind] += 1
        elif re.match(r"FD\w*$", kind):
            enabled = ends.get("CE", ["1"]) != ["1"] or any(
                ends.get(port, ["0"]) != ["0"] for port in ("R", "S")
            )
            total["flip-flop with enable" if enabled else "flip-flop"] += 1
        elif re.match(r"MULT18X18S?$", kind):
            total["multiplier"] += 1
        elif kind == "$mem_v2":
            memories.append(memory(name, cell))
        elif kind not in ("MUXCY", "XORCY", *FREE):
            raise Uncounted(f"the rule has no gates for the cell {name} of type {kind}")
    return Count(Counter({k: n for k, n in total.items() if n}), tuple(memories))


def memory(name: str, cell: Json) -> Memory:
    def number(key: str) -> int:
        return int(cell["parameters"][key], 2)

    def addresses(side: str) -> set[tuple[object, ...]]:
        bits, wide = cell["connections"][f"{side}_ADDR"], number("ABITS")
        return {tuple(bits[i * wide : (i + 1) * wide]) for i in range(number(f"{side}_PORTS"))}

    reads, writes = addresses("RD"), addresses("WR")
    ports = len(reads | writes)
    counted = 1 if ports == 1 or not writes else 2 * max(1, len(reads))
    return Memory(
        tidy(cell["parameters"].get("MEMID", name)), number("SIZE"), number("WIDTH"), counted
    )


def tidy(memid: str) -> str:
    """The name of the FIFO, RAM or register file that a memory is the rows of."""
    row = source_names.of_row(memid.lstrip("\\"))
    return re.sub(r"(\.(exclusive|torn))?\.rows$", "", row).replace("\\", "")


def fit(points: Sequence[tuple[int, int]], values: Sequence[float]) -> tuple[float, ...]:
    """Least squares of value = a + b x + c y over the points (x, y); returns (a, b, c)."""
    matrix = numpy.array([(1.0, *point) for point in points])
    solution, _, rank, _ = numpy.linalg.lstsq(matrix, numpy.array(values, float), rcond=None)
    if rank < matrix.shape[1]:
        raise ValueError("the points lie on a line; take more values of both")
    return tuple(float(x) for x in solution)
