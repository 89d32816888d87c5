# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The delays of a placed and routed design, read from the SDF file that the placer wrote, and the
longest path to every register."""

import gzip
import pathlib
import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TextIO

from dynrt_tools import project

Pin = tuple[str, str]  # cell and port

TIMES = r"\(([\d.eE+-]+):[\d.eE+-]+:([\d.eE+-]+)\)"
CELL_TYPE = re.compile(r'^\s*\(CELLTYPE "(.*)"\)')
INSTANCE = re.compile(r"^\s*\(INSTANCE (.*)\)")
WIRE = re.compile(rf"^\s*\(INTERCONNECT (\S+) (\S+) {TIMES} {TIMES}")
ARC = re.compile(rf"^\s*\(IOPATH (\S+) (\S+) {TIMES} {TIMES}")
SETUP = re.compile(rf"^\s*\(SETUPHOLD \(\w+ (\S+)\) \(\w+ (\S+)\) {TIMES}")


@dataclass(frozen=True)
class Hop:
    """A cell on a path and the wire behind it; the last cell has none."""

    cell: str
    into: str  # the port by which the path enters: the clock at its start
    out: str  # the port by which it leaves, empty at its end
    logic_ns: float
    wire_ns: float
    fanout: int


@dataclass
class Graph:
    """Delays in ns. Wires by the pin that they end at; the others by their cell's output pin."""

    types: dict[str, str] = field(default_factory=dict)
    wires: dict[Pin, tuple[Pin, float]] = field(default_factory=dict)
    arcs: dict[Pin, list[tuple[str, float]]] = field(default_factory=lambda: defaultdict(list))
    setups: dict[Pin, tuple[str, float]] = field(default_factory=dict)

    def fanouts(self) -> dict[Pin, int]:
        loads: dict[Pin, int] = defaultdict(int)
        for driver, _ in self.wires.values():
            loads[driver] += 1
        return loads

    def clock_pins(self) -> set[Pin]:
        """Those that a setup time refers to, and all on the same wires."""
        named = {(cell, clock) for (cell, _), (clock, _) in self.setups.items()}
        drivers = {self.wires[pin][0] for pin in named if pin in self.wires}
        return named | {pin for pin, (driver, _) in self.wires.items() if driver in drivers}


def _unescaped(name: str) -> str:
    return re.sub(r"\\(.)", r"\1", name)


def _pin(text: str) -> Pin:
    cell, _, port = _unescaped(text).rpartition("/")
    return cell, port


def _ns(*picoseconds: str) -> float:
    return max(map(float, picoseconds)) / 1000


def _opened(path: pathlib.Path) -> TextIO:
    if path.suffix == ".gz":
        return gzip.open(path, "rt", encoding="utf-8")
    return path.open(encoding="utf-8")


def read_sdf(path: pathlib.Path) -> Graph:
    """The graph of a file that nextpnr wrote, packed or not."""
    graph, cell, kind = Graph(), "", ""
    with _opened(path) as file:
        for line in file:
            if match := WIRE.match(line):
                driver, end, _, rise, _, fall = match.groups()
                graph.wires[_pin(end)] = (_pin(driver), _ns(rise, fall))
            elif match := ARC.match(line):
                start, out, _, rise, _, fall = map(_unescaped, match.groups())
                graph.arcs[cell, out].append((start, _ns(rise, fall)))
            elif match := SETUP.match(line):
                end, clock, _, setup = map(_unescaped, match.groups())
                graph.setups[cell, end] = (clock, _ns(setup))
            elif match := CELL_TYPE.match(line):
                kind = match[1]
            elif match := INSTANCE.match(line):
                cell = _unescaped(match[1])
                graph.types[cell] = kind
    if not graph.wires or not graph.setups:
        raise project.Failed("the SDF file names no wires or no set-up times")
    return graph


@dataclass(frozen=True)
class Arrival:
    """When a signal leaves a cell at the latest, and the port that it entered by."""

    ns: float
    into: str
    logic_ns: float
    starts: bool  # here, at a clock


class Timing:
    """The latest arrival at every pin of a graph. With `skew` the wires of the clock count, as they
    do for nextpnr 0.8 and later: a register that its clock reaches late starts late."""

    def __init__(self, graph: Graph, skew: bool = False) -> None:
        self.graph = graph
        self._skew = skew
        self.fanouts = graph.fanouts()
        self._clocks = graph.clock_pins()
        self._arrivals: dict[Pin, Arrival | None] = {}

    def _clock_ns(self, pin: Pin) -> float:
        wire = self.graph.wires.get(pin)
        return wire[1] if self._skew and wire else 0.0

    def _drivers(self, out: Pin) -> Iterator[Pin]:
        """The outputs whose arrival decides that of this one."""
        for port, _ in self.graph.arcs.get(out, ()):
            wire = self.graph.wires.get((out[0], port))
            if wire and (out[0], port) not in self._clocks:
                yield wire[0]

    def arrival(self, out: Pin) -> Arrival | None:
        """At an output; None where no path from a register reaches it."""
        todo, opened = [out], set()
        while todo:
            at = todo[-1]
            if at in self._arrivals:
                todo.pop()
                continue
            # What is open already closes a loop, which no path takes twice.
            missing = [p for p in self._drivers(at) if p not in self._arrivals and p not in opened]
            if missing and at not in opened:
                opened.add(at)
                todo += missing
                continue
            self._arrivals[at] = self._latest(at)
            todo.pop()
        return self._arrivals[out]

    def _latest(self, out: Pin) -> Arrival | None:
        latest = None
        for port, delay in self.graph.arcs.get(out, ()):
            pin = (out[0], port)
            if pin in self._clocks:
                here = Arrival(self._clock_ns(pin) + delay, port, delay, True)
            else:
                wire = self.graph.wires.get(pin)
                before = self._arrivals.get(wire[0]) if wire else None
                if wire is None or before is None:
                    continue
                here = Arrival(before.ns + wire[1] + delay, port, delay, False)
            if latest is None or here.ns > latest.ns:
                latest = here
        return latest

    def endpoints(self) -> list[tuple[float, Pin]]:
        """The time of the longest path to each register's input, the longest first."""
        found = []
        for end, (clock, setup) in self.graph.setups.items():
            wire = self.graph.wires.get(end)
            before = self.arrival(wire[0]) if wire else None
            if wire and before:
                late = self._clock_ns((end[0], clock))
                found.append((before.ns + wire[1] + setup - late, end))
        return sorted(found, reverse=True)

    def path(self, end: Pin) -> list[Hop]:
        """The longest path to a register's input, from its start."""
        hops = [Hop(end[0], end[1], "", self.graph.setups[end][1], 0, 0)]
        pin = end
        while True:
            out, wire_ns = self.graph.wires[pin]
            arrival = self.arrival(out)
            assert arrival is not None  # or the end would have none
            hops.append(
                Hop(out[0], arrival.into, out[1], arrival.logic_ns, wire_ns, self.fanouts[out])
            )
            if arrival.starts:
                return hops[::-1]
            pin = (out[0], arrival.into)
