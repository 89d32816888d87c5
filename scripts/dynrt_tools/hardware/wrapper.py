# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A module with four pins around a unit, the core or the board's top, so that each of them can be
placed alone in any package, and be timed from register to register."""

import pathlib
from collections.abc import Sequence
from dataclasses import dataclass

from dynrt_tools.hardware import synthesis
from dynrt_tools.project import read_json

WRAPPER = "placed"
RESET = "rst_ni"


@dataclass(frozen=True)
class Port:
    """A port of a module, with the width that its parameters' defaults give it."""

    name: str
    direction: str
    width: int

    def is_clock(self) -> bool:
        return self.direction == "input" and (self.name == "clk_i" or self.name.endswith("_clk_i"))


def ports(module: str, files: Sequence[pathlib.Path], folder: pathlib.Path) -> list[Port]:
    """The module's ports as Yosys reads them; it works in an existing folder."""
    found = folder / "ports.json"
    synthesis.run_yosys(
        [
            *synthesis.read_commands(files),
            f"hierarchy -top {module}",
            f"delete {module}/p:* {module}/c:* {module}/m:*",
            f"json -o {found} {module}",
        ],
        folder,
        module,
    )
    described = read_json(found)["modules"][module]["ports"]
    return [Port(name, p["direction"], len(p["bits"])) for name, p in described.items()]


def wrap(module: str, of_module: Sequence[Port], copies: int = 1) -> str:
    """Registers before every input of each copy, filled through a chain, and behind every output,
    folded into a chain that ends at a pin. All clocks of the module are the wrapper's one: on a
    device without a clock gate the board's two are one net, and so no path between them is lost."""
    clocks = [p for p in of_module if p.is_clock()]
    resets = [p for p in of_module if p.name == RESET]
    into = [p for p in of_module if p.direction == "input" and p not in clocks and p not in resets]
    out = [p for p in of_module if p.direction == "output"]
    inputs = copies * sum(p.width for p in into)
    outputs = copies * sum(p.width for p in out)
    instances, in_at, out_at = [], 0, 0
    for copy in range(copies):
        pins = [f".{p.name}(clk_i)" for p in clocks] + [f".{p.name}(rst_q)" for p in resets]
        for port in into:
            pins.append(f".{port.name}(in_q[{in_at + port.width - 1}:{in_at}])")
            in_at += port.width
        for port in out:
            pins.append(f".{port.name}(out[{out_at + port.width - 1}:{out_at}])")
            out_at += port.width
        instances.append(f"  {module} {instance(copy, copies)} (\n    {', '.join(pins)});\n")
    return f"""module {WRAPPER} (
  input  wire clk_i,
  input  wire {RESET},
  input  wire serial_i,
  output wire serial_o
);
  reg rst_q;
  reg [{inputs}:0] in_q;
  wire [{outputs - 1}:0] out;
  reg [{outputs - 1}:0] out_q;
  reg [{outputs}:0] fold_q;
  assign serial_o = fold_q[0];
  always @(posedge clk_i) begin
    rst_q <= {RESET};
    in_q <= {{serial_i, in_q[{inputs}:1]}};
    out_q <= out;
    fold_q <= {{1'b0, fold_q[{outputs}:1]}} ^ {{out_q, 1'b0}};
  end
{"".join(instances)}endmodule
"""


def instance(copy: int, copies: int) -> str:
    """The name of a copy's instance in the wrapper."""
    return "unit" if copies == 1 else f"copy_{copy}"
