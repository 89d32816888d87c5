# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Which of hlsc's predictions an end of a placed path is to be held against: the ends of the units'
Verilog by their names, and those inside FIFOs, RAMs and delays by the port that the path enters."""

import pathlib
import re
from dataclasses import dataclass, field

from dynrt_tools.hardware import rtl_files
from dynrt_tools.project import Json

# A part of a unit that is a module of rtl/lib.
PART = re.compile(r"^(\w+_(?:fifo|ram|file)|delay_s\d+_s\d+)\.(.*)$")
# What is in it, past generate blocks.
INNER = re.compile(r"(?:.*\.)?(\w+)$")
RAM = re.compile(
    r"^  hls_ram_\w+ #\(.*?\) (\w+) \((.*?)\);$", re.MULTILINE | re.DOTALL
)  # in the join
PIN = re.compile(r"\.(\w+)_(en|addr|data)_i\((\w+?)__(\w+)_(?:en|addr|data)\)")

WRAPPED = re.compile(r"(?:in_q|out_q|fold_q)$")  # registers of the wrapper

READY = "*_ready_o"  # the latest of a unit's

# Why an end has no prediction.
WRAPPER = "the wrapper of scripts/place"
RESET = "a reset"
JOIN = "an arbiter, fork, repeater or buffer of the join"
TAKEN = "a FIFO whose token is taken by the join"
POINTERS = "a FIFO's pointers to themselves"
COUNTERS = "the counters"
UNKNOWN = "a signal that hlsc does not name"


@dataclass(frozen=True)
class Place:
    """A signal that hlsc names, in an instance of a unit."""

    unit: str
    signal: str


@dataclass
class Joined:
    """The units of what was placed, by instance, and the RAMs between them."""

    modules: dict[str, str]
    rams: dict[str, dict[str, Place]] = field(default_factory=dict)  # by instance and port

    @classmethod
    def of_core(cls, core: pathlib.Path) -> "Joined":
        """The units and RAMs of the file of the module dynrt_core."""
        rams = {
            name: {
                f"{access}_{port}": Place(unit, f"{stem}_{port}_o")
                for access, port, unit, stem in PIN.findall(pins)
            }
            for name, pins in RAM.findall(core.read_text(encoding="utf-8"))
        }
        return cls({i.name: i.module for i in rtl_files.instances(core)}, rams)


def places(end: Json, joined: Joined) -> list[Place] | str:
    """The predicted signals of which the latest is this end's, or why there are none."""
    if why := _no_unit(end, joined):
        return why
    unit, signal, port = end["unit"], end["signal"], end["port"]
    if unit in joined.rams:
        return _of_memory(signal, port, joined.rams[unit])
    part = PART.match(signal)
    if not part:
        return [Place(unit, signal)]
    stem, inner = part[1], part[2]
    if stem.endswith("_fifo"):
        return _of_fifo(end, stem, inner, joined)
    if stem.startswith("delay_"):
        return [Place(unit, f"{stem}.{'data_o' if inner == 'data_o' else 'data_i'}")]
    ports = {
        f"{access}_{what}": Place(unit, f"{stem}.{access}_{what}_i")
        for access in ("read", "write")
        for what in ("en", "addr", "data")
    }
    return _of_memory(inner, port, ports)


def _no_unit(end: Json, joined: Joined) -> str:
    """Why no unit predicts the end, or nothing."""
    unit = end["unit"]
    if end["port"] == "reset":
        return RESET
    if unit == "wrapper" or WRAPPED.match(end["signal"]):
        return WRAPPER
    if unit == rtl_files.COUNTERS_INSTANCE:
        return COUNTERS
    return "" if unit in joined.modules or unit in joined.rams else JOIN


def _of_memory(inner: str, port: str, ports: dict[str, Place]) -> list[Place] | str:
    """Of a memory's own cell by its port; of the register behind it by the read."""
    name = INNER.match(inner)
    if port:
        return [ports[port]] if port in ports else UNKNOWN
    if name and name[1] == "read_data_o":
        return [ports[p] for p in ("read_addr", "read_en") if p in ports]
    return list(ports.values())


def _of_fifo(end: Json, stem: str, inner: str, joined: Joined) -> list[Place] | str:
    """A path from the FIFO's own unit brings a token, one from another unit takes it."""
    unit, start, began = end["unit"], end["from"]["unit"], end["from"]["signal"]
    own = began.startswith(f"{stem}.")
    if start == unit and not own:
        holds_data = end["port"] == "write_data" or inner.startswith("data_q")
        return [Place(unit, f"{stem}.{'data_i' if holds_data else 'valid_i'}")]
    if own:
        return POINTERS
    if start in joined.modules:
        return [Place(start, READY)]
    return TAKEN
