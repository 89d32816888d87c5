# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The timing diagrams of the buses show what the bridges of rtl/bus do: Icarus runs these with the
inputs of a diagram and gives their outputs in each clock. What is `x` in a diagram is not compared.
"""

import pathlib
import re
import unittest
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from dynrt_tools import project, testing
from dynrt_tools.docs import bus_waves
from dynrt_tools.docs.waves import Diagram

Lanes = dict[str, list[str]]  # by the name the value in each clock: 0, 1, x or what it is called

RTL = project.ROOT / "rtl"
CORE = RTL / "generated" / "fast"  # board_registers.v reads how many registers a core has
LIBRARY = ["hls_buffer", "hls_fifo", "hls_ram_1r1w", "hls_ram_1r1w_comb"]
PORT = re.compile(
    r"^  (input|output) +(?:wire|reg) +(?:\[.+?\] +)?(\w+),?(?: *//.*)?$", re.MULTILINE
)
RESET_CLOCKS = 2
WIDEST = 512  # bits of an input
# What the diagrams call their values.
VALUES = {
    "A": 0x1000,
    "A+4": 0x1004,
    "B": 0x2000,
    "C": 0x1000010,
    "D": 0x1000020,
    "ID": 0x44595254,
}


@dataclass
class Bench:
    """The modules that run a diagram."""

    lanes_of: str  # what stands before the lanes in the names of the first module's ports
    modules: Mapping[str, str]  # by their files their parameters; outputs X_o go to inputs X_i
    hidden: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # inputs: wave and values


BENCHES = {
    "bus_axi": Bench(
        "m_axi_",
        {"bus/axi_memory": ""},
        {
            "read_valid_i": ("1.0.......",),
            "read_id_i": ("34x.......", "7 9"),
            "read_address_i": ("34x.......", "A B"),
            "beat_ready_i": ("1.........",),
            "write_valid_i": ("1.0.......",),
            "write_address_i": ("56x.......", "C D"),
            "write_data_i": ("56x.......", "c d"),
            "write_mask_i": ("56x.......", "0f ff"),
        },
    ),
    "bus_wishbone": Bench(
        "m_wb_",
        {"bus/wishbone_memory": "#(.BEAT_BYTES(4))"},
        {
            "read_valid_i": ("10.........",),
            "read_address_i": ("3x.........", "A"),
            "read_last_i": ("10.........",),
            "beat_ready_i": ("1..........",),
            "write_valid_i": ("0.10.......",),
            "write_address_i": ("x.5x.......", "C"),
            "write_data_i": ("x.5x.......", "c"),
            "write_mask_i": ("x.5x.......", "3"),
        },
    ),
    "bus_axi_lite": Bench("s_axil_", {"bus/axi_lite_registers": "", "board/board_registers": ""}),
    "bus_wishbone_registers": Bench(
        "s_wb_", {"bus/wishbone_registers": "", "board/board_registers": ""}
    ),
}


class Ports:
    """The ports of a module of rtl."""

    def __init__(self, path: str) -> None:
        text = (RTL / f"{path}.v").read_text(encoding="utf-8")
        found = PORT.findall(text.partition("\n);")[0])
        self.module = path.rpartition("/")[2]
        self.inputs = [name for way, name in found if way.startswith("input")]
        self.outputs = [name for way, name in found if way.startswith("output")]


def values(wave: str, called: str | list[str] = "") -> list[str]:
    """The value of a lane in each clock."""
    names = iter(called.split() if isinstance(called, str) else called)
    found: list[str] = []
    for clock in wave:
        shown = found[-1] if clock == "." else next(names) if clock in "3456" else clock
        found.append(shown)
    return found


def lanes(signals: list[Any]) -> Iterator[tuple[str, list[str]]]:
    """The lanes of a diagram and of its groups, without the clock."""
    for signal in signals:
        if isinstance(signal, list):
            yield from lanes(signal[1:])
        elif signal["name"] != bus_waves.CLOCK:
            yield signal["name"], values(signal["wave"], signal.get("data", []))


def number(value: str) -> int:
    if value == "x":
        return 0
    return VALUES[value] if value in VALUES else int(value, 16)


def instances(bench: Bench, driven: Lanes) -> Iterator[str]:
    """The modules. An input that nothing drives is 0."""
    found = [(Ports(path), parameters) for path, parameters in bench.modules.items()]
    outputs = {name: f"m{i}.{name}" for i, (m, _) in enumerate(found) for name in m.outputs}
    for i, (ports, parameters) in enumerate(found):
        pins = []
        for name in ports.inputs:
            source = outputs.get(f"{name.removesuffix('_i')}_o", "512'd0")
            own = name in driven or name in ("clk_i", "rst_ni")
            pins.append(f".{name}({name if own else source})")
        yield f"  {ports.module} {parameters} m{i} ({', '.join(pins)});"


def bench_text(bench: Bench, driven: Lanes, outputs: list[str], clocks: int) -> str:
    """The Verilog that runs the modules and prints outputs of the first in each clock."""
    lines = ["module bench;", "  reg clk_i, rst_ni;"]
    lines += [f"  reg [{WIDEST - 1}:0] {name};" for name in driven]
    lines += [*instances(bench, driven), "  initial begin"]
    text = " ".join(f"{name}=%h" for name in outputs)
    shown = ", ".join(f"m0.{name}" for name in outputs)
    for clock in range(-RESET_CLOCKS, clocks):
        lines.append(f"    clk_i = 0; rst_ni = {int(clock >= 0)};")
        for name, lane in driven.items():
            value = number(lane[clock]) if clock >= 0 else 0
            lines.append(f"    {name} = {WIDEST}'h{value:x};")
        if clock >= 0:
            lines.append(f'    #4 $display("{text}", {shown});')
        lines.append("    #1 clk_i = 1; #5;")
    return "\n".join([*lines, "  end", "endmodule", ""])


def simulate(text: str, folder: pathlib.Path) -> list[dict[str, str]]:
    """What the bench prints in each clock: values in hexadecimal by the output's name."""
    (folder / "bench.v").write_text(text, encoding="utf-8")
    command: list[testing.Word] = ["iverilog", "-g2005", "-s", "bench", "-o", folder / "bench.vvp"]
    command += [f"-y{RTL / part}" for part in ("lib", "bus", "board")]
    done = testing.run(*command, f"-I{CORE}", f"-I{RTL / 'board'}", folder / "bench.v")
    if not done.returncode:
        done = testing.run("vvp", folder / "bench.vvp")
    if done.returncode:
        raise project.Failed(done.stdout + done.stderr)
    return [dict(word.split("=") for word in line.split()) for line in done.stdout.splitlines()]


def differences(name: str, diagram: Diagram, folder: pathlib.Path) -> list[str]:
    """A sentence for each value of an output that the Verilog does not have."""
    bench = BENCHES[name]
    ports = Ports(next(iter(bench.modules)))
    shown = {bench.lanes_of + lane: found for lane, found in lanes(diagram["signal"])}
    clocks = len(diagram["signal"][0]["wave"])
    driven = {pin: lane for pin, lane in shown.items() if pin in ports.inputs}
    driven |= {pin: values(*wave) for pin, wave in bench.hidden.items()}
    outputs = [pin for pin in shown if pin in ports.outputs]
    assert all(len(lane) == clocks for lane in [*shown.values(), *driven.values()])
    assert len(outputs) + len(driven) == len(shown) + len(bench.hidden)
    found = simulate(bench_text(bench, driven, outputs, clocks), folder)
    assert len(found) == clocks
    return [
        f"{name}: {pin} in clock {clock} is {has[pin]} and not {shown[pin][clock]}"
        for pin in outputs
        for clock, has in enumerate(found)
        if shown[pin][clock] != "x"
        and (set(has[pin]) & set("xXzZ") or int(has[pin], 16) != number(shown[pin][clock]))
    ]


class BusWaves(testing.InFolder):
    def test_the_verilog_does_what_the_diagrams_show(self) -> None:
        diagrams = bus_waves.diagrams()
        self.assertEqual(diagrams.keys(), BENCHES.keys())
        for name, diagram in diagrams.items():
            with self.subTest(name):
                self.assertEqual(differences(name, diagram, self.folder), [])

    def test_a_difference_is_found(self) -> None:
        diagram = bus_waves.diagrams()["bus_axi_lite"]
        lane = next(lane for lane in diagram["signal"][3][1:] if lane["name"] == "bvalid")
        lane["wave"] = "0...10.........."
        self.assertEqual(
            differences("bus_axi_lite", diagram, self.folder),
            [
                "bus_axi_lite: s_axil_bvalid in clock 3 is 1 and not 0",
                "bus_axi_lite: s_axil_bvalid in clock 4 is 0 and not 1",
            ],
        )


if __name__ == "__main__":
    unittest.main()
