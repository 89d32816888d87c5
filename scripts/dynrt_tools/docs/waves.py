# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The timing diagrams of the units: three transactions in a row, by the checked-in schedules.

A diagram is WaveDrom's JSON. A picture carries the digest of its diagram, so that nobody needs
WaveDrom to know whether a picture is current.
"""

import hashlib
import json
import pathlib
import re
import subprocess
from collections.abc import Mapping
from typing import Any

from dynrt_tools import project

GENERATED = project.ROOT / "rtl" / "generated" / "thesis"
DRAW = pathlib.Path(__file__).with_name("draw_waves.js")
WAVEDROM = "wavedrom@3.7.0"
DIGEST = re.compile(r"<!-- diagram ([0-9a-f]{16}) -->")
PORT = re.compile(r"^  (?:input  wire|output wire) (?:\[\d+:0\] )?(\w+)_(i|o),?$", re.MULTILINE)
HEAD = re.compile(r"^module |^\);", re.MULTILINE)
TOKENS = ["A", "B", "C"]
FIRST = 1  # the clock in which the first transaction starts

Diagram = dict[str, Any]


def ports(verilog: str) -> dict[str, set[str]]:
    """By the port's name the signals that it consists of, such as valid and en."""
    found: dict[str, set[str]] = {}
    for name, way in PORT.findall(HEAD.split(verilog)[1]):
        port, _, signal = name.rpartition("_")
        if port:
            found.setdefault(port, set()).add(f"{signal}_{way}")
    return found


def lane(name: str, begin: int, clocks: int, kind: str) -> Diagram:
    """A signal that holds the three transactions from clock `begin` on."""
    after = clocks - begin - len(TOKENS)
    if kind == "bit":
        return {"name": name, "wave": "0" + "." * (begin - 1) + "1..0" + "." * (after - 1)}
    wave = "x" + "." * (begin - 1) + "345x" + "." * (after - 1)
    return {"name": name, "wave": wave, "data": TOKENS}


def channel(port: str, begin: int, clocks: int) -> list[Diagram]:
    """The tokens of a channel from clock `begin` on."""
    return [
        lane(f"{port}_valid", begin, clocks, "bit"),
        lane(f"{port}_data", begin, clocks, "data"),
    ]


def diagram(schedule: Mapping[str, Any], verilog: str) -> Diagram:
    """What the unit does in each clock."""
    stages = schedule["stages"]
    clocks = FIRST + stages + len(TOKENS) + 1
    signal: list[Any] = [{"name": "clk_i", "wave": "p" + "." * (clocks - 1)}]
    outputs: list[Any] = []
    for port, signals in ports(verilog).items():
        if "valid_i" in signals:
            signal += channel(port, FIRST, clocks)
        elif "valid_o" in signals:
            outputs += channel(port, FIRST + stages, clocks)
        elif "addr_o" in signals and port in schedule["ram_stages"]:
            begin = FIRST + schedule["ram_stages"][port]
            signal.append(lane(f"{port}_addr", begin, clocks, "data"))
    foot = {"tick": -FIRST}
    return {"signal": signal + outputs, "foot": foot}


def diagrams() -> dict[str, Diagram]:
    """The diagram of every unit of `thesis`."""
    found = {}
    for path in sorted(GENERATED.glob("*.json")):
        schedule = project.read_json(path)
        if "stages" in schedule:
            verilog = path.with_suffix(".v").read_text(encoding="utf-8")
            found[schedule["module"]] = diagram(schedule, verilog)
    return found


def digest(drawn: Diagram) -> str:
    text = json.dumps(drawn, sort_keys=True) + WAVEDROM + DRAW.read_text(encoding="utf-8")
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def stale(drawn: Mapping[str, Diagram], folder: pathlib.Path) -> list[str]:
    """The units whose pictures are missing or old."""
    old = []
    for name, picture in drawn.items():
        path = folder / f"{name}.svg"
        found = DIGEST.search(path.read_text(encoding="utf-8")) if path.exists() else None
        if not found or found[1] != digest(picture):
            old.append(name)
    return old


def renew(
    drawn: Mapping[str, Diagram], folder: pathlib.Path, tools: pathlib.Path
) -> list[pathlib.Path]:
    """Draws the pictures that are missing or old, with WaveDrom from npm; gives their files."""
    old = {name: drawn[name] for name in stale(drawn, folder)}
    if not old:
        return []
    project.require_tool("node", "nodejs")
    if not (tools / "node_modules" / "wavedrom").is_dir():
        install(tools)
    done = subprocess.run(
        ["node", DRAW, tools], input=json.dumps(old), text=True, stdout=subprocess.PIPE, check=True
    )
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, picture in json.loads(done.stdout).items():
        path = folder / f"{name}.svg"
        path.write_text(f"{picture}\n<!-- diagram {digest(old[name])} -->\n", encoding="utf-8")
        paths.append(path)
    return paths


def install(tools: pathlib.Path) -> None:
    """Gets WaveDrom from npm."""
    project.require_tool("npm", "npm")
    tools.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(
        ["npm", "install", "--no-save", "--prefix", tools, WAVEDROM],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if done.returncode:
        raise project.Failed(f"npm could not install {WAVEDROM}: {done.stdout.strip()}")


def page() -> str:
    """The page with every diagram."""
    lines = [
        "# Timing of the units",
        "",
        "Three transactions, A, B and C, start in clocks 0, 1 and 2, one in every clock. A token "
        "waits at its input until the transaction takes it (`valid` and `ready` are high). The "
        "output, after its FIFO, has the result as many clocks later as the unit has stages. "
        "`addr` of a RAM outside the unit is valid in the stage that reads or writes it. The "
        "diagrams come from the schedules in `rtl/generated/thesis` and show outputs as if each "
        "transaction wrote all of them; a unit may write none. [Units](units.md) has the widths "
        "and the other ends.",
        "",
        "Stages never stall, so the FIFO of an output must take every token in flight. "
        "There are two ways to ensure that:",
        "",
        "- **Space.** A transaction starts only while the FIFO holds fewer tokens than its "
        "*space*: its depth `X_DEPTH` less its `MARGIN`, the tokens that later stages may "
        "still send. Each section states the space of the FIFO that hlsc chooses.",
        "- **Bound.** The join may promise that a channel never holds more "
        "than so many tokens, such as one for each packet. The Verilog top then gives the FIFO "
        "this depth and sets `X_BOUNDED` to 1, and no transaction waits for that output.",
    ]
    for name, drawn in diagrams().items():
        schedule = project.read_json(GENERATED / f"{name}.json")
        stages = schedule["stages"]
        assert drawn
        lines += [
            "",
            f"## {name}",
            "",
            f"{stages} stage{'' if stages == 1 else 's'} of {schedule['clock_ns']:g} ns "
            f"({schedule['device']}). A transaction starts only while the FIFO of each output "
            f"holds fewer than {schedule['room']} tokens, except for an output with a bound.",
            "",
            f"![Timing of {name}](waves/{name}.svg)",
        ]
    return "\n".join(lines) + "\n"
