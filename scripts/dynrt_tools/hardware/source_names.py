# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The unit, the signal and the source line that a cell of a synthesized netlist comes from."""

import functools
import pathlib
import re
from collections import defaultdict
from dataclasses import dataclass
from typing import Any

from dynrt_tools import project
from dynrt_tools.hardware import block_registers
from dynrt_tools.project import read_json

# What placers add to the name of a cell that they pack into another one.
PACKED = re.compile(
    r"(?:\$(?:CCU2_COMB\d|DPRAM_COMB\d|RAMW_SLICE|RAMW_BLOCK\d)|_LC|_DFFLC|_RAM|_DSP)$"
)
# What Yosys adds to the name of a signal for a cell that drives it.
DRIVES = re.compile(r"_(?:LUT4|TRELLIS_FF|L6MUX21|PFUMX|CCU2C|SB_\w+?)_[A-Z]\w*$")
# A name that Yosys made up of a signal and a cell beside it.
INVENTED = re.compile(r"_(?:LUT4|TRELLIS_FF|L6MUX21|PFUMX|CCU2C|SB_[A-Z0-9]+)_[A-Z]")
# The first line of an instance, in the Verilog of hlsc and of this project.
INSTANCE = re.compile(r"^\s*\w+\s+(?:#\s*\(.*\)\s*)?\w+\s*\(\s*(?:\.|$)")
# What it adds to a memory's name for a cell of it, and for an output of that.
PART = re.compile(r"\.\d+\.\d+(?:_[A-Z]\w*)?(?:\[\d+\])?$")
COPY = re.compile(r"copy_(\d+)\.")
COMMENT = re.compile(r"// (units/\S+:\d+)")
STAGE = re.compile(r"_(?:s\d+|q)$")
BIT = re.compile(r"\[\d+\]$")
# The columns that hls_ram_1r1w divides a row into.
COLUMN = re.compile(r"\.column\[\d+\](?=\.)")
# How hlsc and the primitives name a register, where a net has more names.
REGISTER = re.compile(r"_(?:s\d+|q|still)(?:\[\d+\])?$")
FLIP_FLOP = re.compile(r"^(?:TRELLIS_FF$|SB_DFF)")


@dataclass(frozen=True)
class Origin:
    """Where a cell is from. `unit` is an instance of the core or the module that is placed alone,
    `source` a line of C++ where the Verilog names one, else of the Verilog."""

    unit: str
    signal: str
    source: str


def of_row(signal: str) -> str:
    """A signal of a RAM by its row, and not by a column of that."""
    return COLUMN.sub("", signal)


class Names:
    """Of the cells in a netlist that Yosys wrote of a module in its wrapper; `verilog` is a folder
    with its files. A module that joins others gives its cells the names of their instances."""

    def __init__(
        self, netlist: pathlib.Path, verilog: pathlib.Path, module: str, joins: bool = False
    ) -> None:
        design: Any = read_json(netlist)
        top = next(
            m for m in design["modules"].values() if int(str(m["attributes"].get("top", "0")), 2)
        )
        self._module, self._verilog, self._joins = module, verilog, joins
        self._cells: dict[str, Any] = top["cells"]
        self._loads = block_registers.loads_of(top)
        self._flip_flops = {  # by the bit that they take
            bit: cell
            for cell in self._cells.values()
            if FLIP_FLOP.match(cell["type"])
            for port in ("D", "DI")
            for bit in cell["connections"].get(port, ())
        }
        self._declared: dict[str, str] = {}  # a net's place, by the instance that it is in
        self._nets: dict[int, list[tuple[str, str]]] = defaultdict(list)
        for name, net in top["netnames"].items():
            if net["hide_name"]:
                continue
            source = net["attributes"].get("src", "")
            self._declared.setdefault(name.rpartition(".")[0], source)
            wide = len(net["bits"]) > 1
            for at, bit in enumerate(net["bits"]):
                if isinstance(bit, int):
                    self._nets[bit].append((f"{name}[{at}]" if wide else name, source))

    def origin(self, placed: str, port: str = "") -> Origin:
        """Of a placed cell, by the net at one of its ports, the output where none is named."""
        name, cell = self._found(placed)
        return self._origin(name, cell, port)

    def register(self, placed: str) -> Origin:
        """Of the flip-flop or memory that a path ends at. A placer that packs a flip-flop behind
        a LUT calls both by the LUT's name."""
        name, cell = self._found(placed)
        if cell is not None and cell["type"] == block_registers.MULTIPLIER:
            return self._origin(name, cell, self._lowest_read(cell), REGISTER)
        if cell is not None and not FLIP_FLOP.match(cell["type"]):
            behind = [self._flip_flops.get(bit) for bit in cell["connections"].get("O", ())]
            cell = next((ff for ff in behind if ff), None)
        if cell is None:  # a memory: its outputs have the names of those who read them
            source = self._source(
                "", self._cells.get(name, {"attributes": {}})["attributes"].get("src", ""), name
            )
            return Origin(self._unit(name), self._plain(name), source)
        return self._origin(name, cell, "", REGISTER)

    def _lowest_read(self, cell: Any) -> str:
        """The port of the lowest bit in a multiplier's register: a bit that nobody reads is not in
        it, and its net has the name of the product."""
        ports = [
            port
            for port, bits in cell["connections"].items()
            if re.match(block_registers.PRODUCT.bits, port) and bits and self._loads[bits[0]]
        ]
        return min(ports, key=lambda port: int(port[1:]), default="")

    def _found(self, placed: str) -> tuple[str, Any]:
        """The netlist's cell that a placed one is of, None where there is none."""
        name = placed
        while name not in self._cells and PACKED.search(name):
            name = PACKED.sub("", name)
        return name, self._cells.get(name)

    def _origin(
        self, name: str, cell: Any, port: str, preferred: re.Pattern[str] = re.compile("")
    ) -> Origin:
        if cell is None:
            return Origin(self._unit(name), self._plain(name), "")
        source = cell["attributes"].get("src", "")
        signal, declared = self._signal(cell, port, source, preferred) or (
            DRIVES.sub("", name),
            "",
        )
        return Origin(
            self._unit(signal if signal.startswith(("unit.", "copy_")) else name),
            self._plain(signal),
            self._source(declared, source, signal),
        )

    def _signal(
        self, cell: Any, port: str, source: str, preferred: re.Pattern[str]
    ) -> tuple[str, str] | None:
        """The best name of the net that the cell drives, with the place of its declaration: none
        of Yosys's own, one declared in the file that the cell is from, one that is preferred, the
        innermost, no port's."""
        directions = cell.get("port_directions", {})
        outs = [p for p, d in directions.items() if d == "output"]
        bits = [
            bit
            for p in ([port] if port in outs else outs)
            for bit in cell["connections"][p]
            if isinstance(bit, int) and self._nets.get(bit)
        ]
        if not bits or len(outs) > 1 and port not in outs:
            return None
        from_file = self._innermost(source)

        def rank(net: tuple[str, str]) -> tuple[bool, bool, bool, int, bool, str]:
            near = self._innermost(net[1]) == from_file
            invented = bool(INVENTED.search(net[0]))
            return (
                invented,
                not near,
                not preferred.search(net[0]),
                -net[0].count("."),
                BIT.sub("", net[0]).endswith(("_i", "_o")),
                net[0],
            )

        return min(self._nets[bits[0]], key=rank)

    def _unit(self, name: str) -> str:
        """The instance that a hierarchical name is in."""
        copied = COPY.match(name)
        where = f" of copy {copied[1]}" if copied else ""
        if not copied and not name.startswith("unit."):
            return "wrapper"
        inner = name[copied.end() if copied else len("unit.") :].removeprefix("core.")
        first, dot, _ = inner.partition(".")
        if not (dot and self._joins):
            return self._module + where
        return first.removeprefix("u_") + where

    def _plain(self, name: str) -> str:
        """A hierarchical name without the wrapper's and the unit's part."""
        plain = DRIVES.sub("", PART.sub("", COPY.sub("", name).removeprefix("unit."))).removeprefix(
            "core."
        )
        _, dot, rest = plain.partition(".")
        return rest if dot and self._joins else plain

    def _source(self, declared: str, driven: str, signal: str) -> str:
        """A C++ line named beside one of the Verilog lines, else the first Verilog line."""
        places = self._known(declared) + self._known(driven)
        for file, line in places:
            if found := COMMENT.search(self._line(file, line)):
                return f"hls/{found[1]}"
        stem = STAGE.sub("", BIT.sub("", signal.rpartition(".")[2]))
        for file, _ in places:
            if found := re.search(
                rf"\b{re.escape(stem)}_s\d+ =.*{COMMENT.pattern}", self._text(file)
            ):
                return f"hls/{found[1]}"
        if not places and (place := self._memory(PART.sub("", signal))):
            places = [place]
        return f"{_shown(places[0][0])}:{places[0][1]}" if places else ""

    def _memory(self, name: str) -> tuple[str, int] | None:
        """Where a memory is declared, whose cells name no line, in the file of a net beside it."""
        while "." in name:
            name, _, inner = name.rpartition(".")
            for file, _ in self._known(self._declared.get(name, "")):
                for at, line in enumerate(self._lines(file), 1):
                    if re.search(rf"\breg\b[^;]*\s{re.escape(inner)}\s*\[", line):
                        return file, at
        return None

    def _known(self, source: str) -> list[tuple[str, int]]:
        """The places of an attribute `src` in the netlist's own files: first those of the thing
        itself, then those of the instances that it is in, which Yosys lists in any order."""
        places = [p for p in _places(source) if self._lines(p[0])]
        return sorted(places, key=lambda p: bool(INSTANCE.match(self._line(*p))))

    def _line(self, file: str, line: int) -> str:
        lines = self._lines(file)
        return lines[line - 1] if line <= len(lines) else ""

    def _innermost(self, source: str) -> str:
        known = self._known(source)
        return known[0][0] if known else ""

    def _text(self, file: str) -> str:
        return "\n".join(self._lines(file))

    @functools.lru_cache(maxsize=None)  # pylint: disable=method-cache-max-size-none
    def _lines(self, file: str) -> list[str]:
        path = self._verilog / pathlib.Path(file).name
        return path.read_text(encoding="utf-8").splitlines() if path.is_file() else []


def _places(source: str) -> list[tuple[str, int]]:
    """File and line of each part of an attribute `src`."""
    found = []
    for part in source.split("|"):
        file, colon, place = part.rpartition(":")
        if colon and (line := re.match(r"\d+", place)):
            found.append((file, int(line[0])))
    return found


def _shown(file: str) -> str:
    """A file as the project names it, wherever its text lay."""
    path = pathlib.Path(file)
    parts = path.parts
    if path.is_relative_to(project.ROOT):
        return path.relative_to(project.ROOT).as_posix()
    return "/".join(parts[parts.index("rtl") :]) if "rtl" in parts else path.name
