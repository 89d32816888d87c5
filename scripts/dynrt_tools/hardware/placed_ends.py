# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The ends of a placement's paths by the signals of the Verilog: the bits of one are one end, with
the time of its worst."""

import dataclasses
import pathlib
import re

from dynrt_tools import project
from dynrt_tools.hardware import source_names, timing_graph
from dynrt_tools.project import Json

# How much of the longest path an end takes that is looked at. An end that limits in one placement
# takes more than this in the others.
LEAST_SHARE = 0.6
RESET = re.compile(r"(?:reset|rst)_q$")

# The ports of a memory's cells: of LUT RAM and block RAM of ECP5, of block RAM of iCE40. Yosys
# writes by port A of a DP16KD and reads by port B.
MEMORY = {
    "write_data": re.compile(r"WD|DIA\d+|WDATA_\d+"),
    "write_addr": re.compile(r"WAD\d|ADA\d+|WADDR_\d+"),
    "write_en": re.compile(r"WRE|WEA|CEA|WE|WCLKE"),
    "read_addr": re.compile(r"ADB\d+|RADDR_\d+"),
    "read_en": re.compile(r"CEB|OCEB|RE|RCLKE"),
}
MEMORY_CELL = re.compile(r"\.rows$|\.rows\.")


@dataclasses.dataclass(frozen=True)
class End:
    """What the bits of one end have in common. `port` is that of a memory, "reset" where the path
    comes from the register of a reset, else empty."""

    unit: str
    signal: str
    port: str


def name_of(signal: str) -> str:
    """What the bits of a signal have in common."""
    return source_names.of_row(source_names.BIT.sub("", signal))


def port_of(signal: str, pin: str) -> str:
    """Of a memory's cell; empty for a flip-flop, whose inputs are one end."""
    if not MEMORY_CELL.search(signal):
        return ""
    return next((name for name, pins in MEMORY.items() if pins.fullmatch(pin)), "")


def ends_of(timing: timing_graph.Timing, names: source_names.Names) -> dict[End, Json]:
    """Every end that takes long, with its time, the start of its path and its line."""
    found: dict[End, Json] = {}
    endpoints = timing.endpoints()
    least = LEAST_SHARE * endpoints[0][0] if endpoints else 0
    for ns, pin in endpoints:
        if ns < least:
            break
        last = names.register(pin[0])
        first = timing.path(pin)[0]
        start = names.origin(first.cell, first.out)
        signal, began = name_of(last.signal), name_of(start.signal)
        port = "reset" if RESET.search(began) else port_of(signal, pin[1])
        found.setdefault(
            End(last.unit, signal, port),
            {
                "ns": round(ns, 3),
                "source": last.source,
                "from": {"unit": start.unit, "signal": began},
            },
        )
    return found


def write(path: pathlib.Path, ends: dict[End, Json]) -> None:
    rows = [{**dataclasses.asdict(end), **about} for end, about in ends.items()]
    project.write_json(path, rows)


def read(path: pathlib.Path) -> dict[End, Json]:
    """What write() left."""
    names = [field.name for field in dataclasses.fields(End)]
    rows = project.read_json(path)
    return {End(*(row.pop(name) for name in names)): row for row in rows}
