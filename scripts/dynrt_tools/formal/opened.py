# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A unit that hlsc lowered, with all that it remembers from one transaction to the next as ports.

A transaction never waits on its way through a unit, so that what it takes and gives at a port it
takes and gives a number of clocks after it began: the stage of the port.
"""

import re

from dynrt_tools.formal import flow
from dynrt_tools.project import searched

MEMORY = re.compile(
    r"^  hls_(ram_1r1w|register_file) #\(\.WIDTH\((\d+)\), \.ROWS\((\d+)\)[^\n]*\) "
    r"(\w+)_(?:ram|file) \((.*?)\);\n",
    re.MULTILINE | re.DOTALL,
)
STATE = re.compile(
    r"^  always @\(posedge clk_i\) begin\n    if \(!rst_ni\) (\w+_q) <= ([^;]*);\n"
    r"    else if \(([^;]*)\) \1 <= ([^;]*);\n  end\n",
    re.MULTILINE,
)
REGISTER = r"^  reg  (?:\[(\d+):0\] )?{};\n"
FIFO = re.compile(r"(\w+)_fifo \((.*?)\);\n", re.DOTALL)
PORT = re.compile(r"^  (input|output) +wire (?:\[(\d+):0\] )?(\w+),?$", re.MULTILINE)
STAGE = re.compile(r"_s(\d+)\b")


def pins(text: str) -> dict[str, str]:
    """The expression at each pin of an instance."""
    found = {}
    position = 0
    while match := re.compile(r"\.(\w+)\(").search(text, position):
        position, depth = match.end(), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(text[position], 0)
            position += 1
        found[match.group(1)] = text[match.end() : position - 1]
    return found


def opened(verilog: str) -> str:
    """The Verilog of a unit with its RAMs, register files and state made ports of it; what a port
    NAME_en_o enables is NAME_addr_o and NAME_data_o, as of the RAMs that lie elsewhere."""
    text = re.sub(r"^`ifdef HLS_ASSERT\n.*?^`endif\n", "", verilog, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^  wire unused = [^;]*;\n", "", text, flags=re.MULTILINE)
    ports = []

    def output(name: str, width: int, expression: str) -> str:
        ports.append(f"  output wire [{width - 1}:0] {name}")
        return f"  assign {name} = {expression};\n"

    def memory(match: re.Match[str]) -> str:
        kind, _, rows, name, instance = match.groups()
        width, bits, pin = int(match[2]), max((int(rows) - 1).bit_length(), 1), pins(instance)
        row = f"{name}_row_i"
        if kind == "register_file":  # its read has no enable: in every transaction
            row = f"{name}_word_i"
            pin["read_en_i"] = "valid_s" + searched(STAGE.pattern, pin["write_data_i"])[1]
        ports.append(f"  input wire [{width - 1}:0] {row}")
        return (
            f"  assign {pin['read_data_o']} = {row};\n"
            + output(f"{name}_write_en_o", 1, pin["write_en_i"])
            + output(f"{name}_write_addr_o", bits, pin["write_addr_i"])
            + output(f"{name}_write_data_o", width, pin["write_data_i"])
            + output(f"{name}_read_en_o", 1, pin["read_en_i"])
            + output(f"{name}_read_addr_o", bits, pin["read_addr_i"])
        )

    def state(match: re.Match[str]) -> str:
        name, start, enable, value = match.groups()
        high = searched(REGISTER.format(name), verilog)[1]
        width = int(high or 0) + 1
        ports.append(f"  input wire [{width - 1}:0] {name}")
        return (
            output(f"{name}_en_o", 1, enable)
            + output(f"{name}_data_o", width, value)
            + output(f"{name}_reset_o", width, start)
        )

    text = STATE.sub(state, MEMORY.sub(memory, text))
    text = re.sub(REGISTER.format(r"\w+_q"), "", text, flags=re.MULTILINE)
    if left := re.search(r"\bhls_(ram|register)\w+|\w+_q <=", text):
        raise flow.Broken(f"a unit remembers what is not made a port of it: {left[0]}")
    return text.replace("\n);\n", "".join(",\n" + port for port in ports) + "\n);\n", 1)


class Stages:
    """In which stage an opened unit takes and gives what."""

    def __init__(self, text: str) -> None:
        body = re.sub(r"//[^\n]*", "", text[text.index("\n);\n") :])
        # The end of a block of statements stands before the next one.
        self.statements = [re.sub(r"^(end\s+)+", "", s.strip()) for s in body.split(";")]
        self.meanings = dict(
            (m[1], m[2])
            for s in self.statements
            if (m := re.match(r"(?:wire|assign) (?:\[\d+:0\] )?(\w+) = (.*)$", s, re.DOTALL))
        )
        self.ports = {name: (way, int(high or 0) + 1) for way, high, name in PORT.findall(text)}
        self.fifos = {name: pins(instance)["valid_i"] for name, instance in FIFO.findall(text)}

    def of_expression(self, text: str) -> set[int]:
        stages = {int(n) for n in STAGE.findall(text)}
        if not stages:
            for name in re.findall(r"[A-Za-z]\w+", text):
                stages |= self.of_expression(self.meanings.get(name, ""))
        return stages

    def of_uses(self, name: str) -> set[int]:
        """The stages whose values anything is made of together with a signal."""
        stages = set()
        for statement in self.statements:
            target = re.match(r"(?:wire|assign) (?:\[\d+:0\] )?(\w+) = ", statement)
            if not re.search(rf"\b{name}\b", statement) or target and target[1] == name:
                continue
            register = re.search(r"_s(\d+) <= \w+$", statement)
            if register:
                stages.add(int(register[1]) - 1)
            elif target and target[1] in self.ports:
                stages.add(self.of(target[1]))
            elif STAGE.search(statement):
                stages |= {int(n) for n in STAGE.findall(statement)}
            elif target:
                stages |= self.of_uses(target[1])
        return stages

    def of(self, port: str) -> int:
        """The stage of a port, 0 of one that nobody reads; throws Broken."""
        way, _ = self.ports[port]
        carrier = re.sub(r"_(valid|en|addr|data)_o$", "", port)
        if way == "input":
            stages = self.of_uses(port) or {0}
        elif carrier in self.fifos:
            stages = self.of_expression(self.fifos[carrier])
        elif f"{carrier}_en_o" in self.ports:
            stages = self.of_expression(self.meanings[f"{carrier}_en_o"])
        else:
            stages = self.of_expression(self.meanings[port]) or {0}
        if len(stages) != 1:
            raise flow.Broken(f"{port} belongs to {len(stages)} stages of a unit, not to one")
        return stages.pop()
