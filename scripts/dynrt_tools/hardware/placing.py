# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place does with one unit: lower, wrap, place, read the reports."""

import pathlib
import re
import subprocess
from typing import TypedDict

from dynrt_tools import project
from dynrt_tools.hardware import devices, rtl_files, synthesis
from dynrt_tools.project import Json, read_json, searched

CONSTRAINTS = project.ROOT / "constraints"


class Tool(TypedDict):
    """The tool that places and routes for a device."""

    program: str
    cells: str
    where: str
    flags: list[str]


# How a device's tool is called; `cells` is the logic cell in its report. The speed grade of ECP5 is
# the slowest. The wrapper has four pins, so any package will do; that of ECP5 is the board's.
TOOLS: dict[str, Tool] = {
    "ice40-hx8k": {
        "program": "nextpnr-ice40",
        "cells": "ICESTORM_LC",
        "where": "Debian's package nextpnr-ice40 has it, and scripts/setup installs that",
        "flags": ["--hx8k", "--package", "ct256", "--pcf", str(CONSTRAINTS / "ice40_hx8k_evn.pcf")],
    },
    "ecp5-85": {
        "program": "nextpnr-ecp5",
        "cells": "TRELLIS_COMB",
        "where": "Debian 12 has no package of it; build it from the nextpnr project",
        "flags": [
            "--85k",
            "--package",
            "CABGA381",
            "--speed",
            "6",
            "--lpf",
            str(CONSTRAINTS / "ulx3s_85f.lpf"),
        ],
    },
}
PORT = re.compile(r"^\s*(input|output)\s+(?:wire|reg)?\s*(?:\[(\d+):0\])?\s*(\w+)", re.MULTILINE)
WRAPPER = "placed"


class DoesNotFit(project.Failed):
    """The tool's word that the design is too large."""


def find_build(named: pathlib.Path | None) -> pathlib.Path:
    folders = [named] if named else [project.ROOT / "build" / p for p in ("release", "dev")]
    for folder in folders:
        if (folder / "hls/compiler/hlsc").is_file() and (
            folder / "hls/units/list_units.txt"
        ).is_file():
            return folder
    raise project.Failed(
        f"no build with hlsc is in {' or '.join(map(str, folders))}; build the "
        "target hlsc, or name a build's folder with --build"
    )


def units(build: pathlib.Path, config: str = rtl_files.CHECKED_IN) -> dict[str, dict[str, str]]:
    """Module, header and type of the configuration's units, by module."""
    found = {}
    for line in (build / "hls/units/list_units.txt").read_text(encoding="utf-8").splitlines():
        name, module, header, kind = line.split("|")
        if name == config:
            found[module] = {"module": module, "header": header, "type": kind}
    return found


def lower(build: pathlib.Path, unit: dict[str, str], clock_ns: float, delay: str) -> pathlib.Path:
    """The folder with the unit's Verilog and hlsc's report for a delay model."""
    root, module = project.ROOT, unit["module"]
    include = build / "generated" / "include"
    hlsc = build / "hls" / "compiler" / "hlsc"
    header = f"{rtl_files.CHECKED_IN}/{module}.h"
    sources = sorted(
        p
        for folder in ("hls/lowered", "hls/include", "hls/units")
        for p in (root / folder).rglob("*.h")
    )

    def make(folder: pathlib.Path) -> None:
        includes = [
            f
            for path in (root / "hls/lowered", root / "hls/include", root / "hls", include)
            for f in ("-I", str(path))
        ]
        result = subprocess.run(
            [
                hlsc,
                "--unit",
                unit["type"],
                "--module",
                module,
                "--header",
                header,
                *includes,
                "--clock-ns",
                str(clock_ns),
                "--delay",
                root / delay,
                "-o",
                folder / f"{module}.v",
                "--report",
                folder / f"{module}.txt",
                "--binding",
                folder / "ports.h",
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        if result.returncode != 0:
            raise project.Failed(result.stderr.strip().splitlines()[-1])

    said = [
        unit,
        clock_ns,
        (root / delay).read_text(encoding="utf-8"),
        hlsc.stat().st_mtime_ns,
        (include / "configs" / f"{rtl_files.CHECKED_IN}.h").read_text(encoding="utf-8"),
    ]
    return synthesis.kept("lowered", said, sources, make)


def wrap(module: str, verilog: str) -> str:
    """A module with four pins that has registers before every input of a module, filled through a
    chain, and behind every output, folded into a chain that ends at a pin."""
    body = verilog[searched(rf"^module {module}\b", verilog).end() :]
    ports = [
        (way, int(high or 0) + 1, name)
        for way, high, name in PORT.findall(body[: body.index(");\n")])
    ]
    into = [p for p in ports if p[0] == "input" and p[2] not in ("clk_i", "rst_ni")]
    out = [p for p in ports if p[0] == "output"]
    inputs, outputs = sum(w for _, w, _ in into), sum(w for _, w, _ in out)
    lines, at = [], 0
    for _, width, name in into:
        lines.append(f".{name}(in_q[{at + width - 1}:{at}])")
        at += width
    at = 0
    for _, width, name in out:
        lines.append(f".{name}(out[{at + width - 1}:{at}])")
        at += width
    return f"""module {WRAPPER} (
  input  wire clk_i,
  input  wire rst_ni,
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
    rst_q <= rst_ni;
    in_q <= {{serial_i, in_q[{inputs}:1]}};
    out_q <= out;
    fold_q <= {{1'b0, fold_q[{outputs}:1]}} ^ {{out_q, 1'b0}};
  end
  {module} unit (
    .clk_i(clk_i), .rst_ni(rst_q),
    {", ".join(lines)});
endmodule
"""


def place(device: str, module: str, files: list[pathlib.Path], seed: int, mhz: float) -> Json:
    """Cells and clock of one placement; throws DoesNotFit."""
    tool = TOOLS[device]
    family = devices.FAMILIES[devices.DEVICES[device]["family"]]
    version = synthesis.tool_version(tool["program"], "--version", tool["program"])
    files = synthesis.needed(module, files)
    said = [synthesis.tool_version("yosys", "-V", "yosys"), family["synth"], module]

    def make_netlist(folder: pathlib.Path) -> None:
        wrapper = folder / f"{WRAPPER}.v"
        source = next(f for f in files if f.stem == module)
        wrapper.write_text(wrap(module, source.read_text(encoding="utf-8")), encoding="utf-8")
        synthesis.run_yosys(
            [
                *synthesis.read_commands([*files, wrapper]),
                family["synth"].format(top=WRAPPER),
                f"write_json {folder}/netlist.json",
            ],
            folder,
            module,
        )

    netlist = (
        synthesis.kept(
            "netlist", [*said, wrap("m", "module m (\n  input wire a\n);\n")], files, make_netlist
        )
        / "netlist.json"
    )

    def make_placement(folder: pathlib.Path) -> None:
        result = subprocess.run(
            [
                tool["program"],
                *tool["flags"],
                "--json",
                netlist,
                "--seed",
                str(seed),
                "--freq",
                f"{mhz:g}",
                "--timing-allow-fail",
                "--report",
                folder / "report.json",
                "-q",
                "-l",
                folder / "log",
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        report = folder / "report.json"
        if result.returncode != 0 or not report.exists():
            errors = [line for line in result.stderr.splitlines() if line.startswith("ERROR")]
            raise DoesNotFit(
                errors[-1].removeprefix("ERROR: ") if errors else f"{tool['program']} failed"
            )

    folder = synthesis.kept(
        "placed",
        [*said, version, tool["flags"], seed, mhz, netlist.parent.name],
        [],
        make_placement,
    )
    report = read_json(folder / "report.json")
    return {
        "seed": seed,
        "cells": report["utilization"][tool["cells"]]["used"],
        "mhz": min(c["achieved"] for c in report["fmax"].values()),
    }


ARRIVAL = re.compile(r"Latest arrival time in '[^']*' is (\d+)")


def logic_delay(module: str, files: list[pathlib.Path]) -> float:
    """The longest path in ns through the cells of 7-series, without the wires."""
    files = synthesis.needed(module, files)
    synth = devices.FAMILIES["xc7"]["synth"]

    def make(folder: pathlib.Path) -> None:
        synthesis.run_yosys(
            [
                *synthesis.read_commands(files),
                synth.format(top=module),
                f"tee -q -o {folder}/sta.txt sta",
            ],
            folder,
            module,
        )

    folder = synthesis.kept(
        "sta", [synthesis.tool_version("yosys", "-V", "yosys"), synth, module], files, make
    )
    found = ARRIVAL.search((folder / "sta.txt").read_text(encoding="utf-8"))
    if not found:
        raise project.Failed(f"{module}: Yosys's sta names no arrival time")
    return int(found[1]) / 1000
