# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A unit beside the same unit lowered for another clock, both opened (opened.py).

Both take the same in the same transaction, one so many clocks later that nothing comes to the other
after it; then what they give is compared. What a RAM or a register holds is free, but the same for
both in the same transaction: it is read and written by the same transactions, at the same rows,
with the same data and in the same order, so it holds the same. That order is, of a register and a
register file, that of the transactions, since they are read and written in one stage; of a RAM
within the unit, the promise that HLS_ASSERT checks; of one elsewhere, what the join of the core
promises.
"""

import pathlib
import re

from dynrt_tools.formal import flow, opened

CLOCKED = ("clk_i", "rst_ni")


class Unit:
    def __init__(self, path: pathlib.Path) -> None:
        self.module = path.stem
        stages = opened.Stages(opened.opened(path.read_text(encoding="utf-8")))
        self.ports = stages.ports
        self.given = [name for name, (way, _) in self.ports.items() if way == "output"]
        taken = [name for name in self.ports if name not in (*self.given, *CLOCKED)]
        self.constant = [
            n for n in taken if not re.search(r"_(valid|ready|data|row|word)_i$|_q$", n)
        ]
        self.ready = [n for n in taken if n.endswith("_ready_i")]
        self.taken = [n for n in taken if n not in (*self.constant, *self.ready)]
        self.stage = {name: stages.of(name) for name in (*self.taken, *self.given)}
        self.last = max(self.stage.values())
        for name in self.taken:
            carrier = re.sub(r"_(data|row|word)_i$", "", name)
            if carrier == name and f"{name}_en_o" in self.ports:
                self.expect(name, f"{name}_en_o", 0)
            if name.endswith("_word_i"):
                self.expect(name, f"{carrier}_write_en_o", 0)
            if name.endswith("_row_i"):
                self.expect(name, f"{carrier}_read_en_o", 1)

    def after(self, name: str, other: str) -> int:
        return self.stage[name] - self.stage[other]

    def expect(self, name: str, other: str, clocks: int) -> None:
        if self.after(name, other) != clocks:
            raise flow.Broken(
                f"{self.module}: {name} is read {self.after(name, other)} clocks after "
                f"{other}, not {clocks}"
            )


def compared(first: Unit, second: Unit) -> tuple[str, int]:
    """The Verilog within the module pair, and the clocks from a transaction's begin to the last
    comparison; throws Broken."""
    if first.ports != second.ports:
        raise flow.Broken(f"{first.module} and {second.module} have different ports")
    for name in first.taken:
        enable = re.sub(r"_data_i$", "_en_o", name)
        if enable in first.given and first.after(name, enable) != second.after(name, enable):
            raise flow.Broken(
                f"{name} comes to {first.module} and {second.module} after different times"
            )
    begins = max(first.stage[name] - second.stage[name] for name in first.stage)
    later = {name: begins + second.stage[name] - first.stage[name] for name in first.stage}
    lines: list[str] = []
    pins: dict[str, list[str]] = {"first": [], "second": []}
    for name, (_, width) in first.ports.items():
        for side, unit in pins.items():
            of_both = name in CLOCKED or name in first.constant
            wire = name if of_both else f"{side}_{name}"
            unit.append(f".{name}(1'b1)" if name in first.ready else f".{name}({wire})")
        if name in first.constant:
            lines.append(f"  (* anyconst *) wire [{width - 1}:0] {name};")
        if name not in first.stage:
            continue
        past = f"past_{name}" if name in first.given else f"second_{name}"
        lines += [
            f"  {'' if name in first.given else '(* anyseq *) '}wire [{width - 1}:0] first_{name};",
            *(f"  wire [{width - 1}:0] {w};" for w in sorted({f"second_{name}", past})),
            f"  past #(.WIDTH({width}), .CLOCKS({later[name]})) of_{name} (.clk_i(clk_i), "
            f".rst_ni(rst_ni), .data_i(first_{name}), .data_o({past}));",
        ]
    lines += [
        f"  {first.module} first ({', '.join(pins['first'])});",
        f"  {second.module} second ({', '.join(pins['second'])});",
        "  reg was_reset_q = 1'b0;",
        "  always @(posedge clk_i) was_reset_q <= 1'b1;",
        "  always @* assume (rst_ni == was_reset_q);",
        "  wire past_reset;",
        "  wire begun = was_reset_q && past_reset;",
        f"  past #(.CLOCKS({max(later.values())})) of_reset (.clk_i(clk_i), .rst_ni(rst_ni), "
        ".data_i(was_reset_q), .data_o(past_reset));",
    ]
    for name in first.given:
        lines += checked(first, name)
    return "\n".join(lines) + "\n", begins + second.last + 1


def checked(unit: Unit, name: str) -> list[str]:
    """The properties of an output."""
    same = f"second_{name} == past_{name}"
    carrier = re.sub(r"_(addr|data)_o$", "", name)
    enables = [e for e in (f"{carrier}_en_o", f"{carrier}_valid_o") if e in unit.given]
    if carrier != name and enables:
        return [f"  always @* if (begun && past_{enables[0]}) {name}_what: assert ({same});"]
    lines = [f"  always @* if (begun) {name}_when: assert ({same});"]
    if name.endswith(("_valid_o", "_en_o")):
        lines += ["  always @* begin", f"    {name}_given: cover (begun && past_{name});", "  end"]
    return lines
