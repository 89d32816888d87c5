# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes a netlist of what is placed, lets the placer run once for each seed, and keeps what it
gives under a key of all that it was made of."""

import functools
import gzip
import hashlib
import pathlib
import re
import shutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from dynrt_tools import project
from dynrt_tools.hardware import (
    block_registers,
    devices,
    placed_ends,
    placers,
    source_names,
    synthesis,
    timing_graph,
    worst_paths,
    wrapper,
)
from dynrt_tools.project import Json, read_json, searched

# How far the longest path of the SDF file may be from the period in the placer's report.
SAME_PERIOD = 0.03
ENDS = "ends.json"  # of the paths, beside the other figures of a placement
SOURCE = re.compile(r'"src": "[^"]*"')


@dataclass(frozen=True)
class Target:
    """What a module is placed on, and what the placer is asked for."""

    device: str
    grade: str
    mhz: float
    timeout: float  # seconds

    def said(self, seed: int) -> list[object]:
        """All of it that decides the result beside the netlist."""
        placer = placers.PLACERS[self.device]
        return [
            placer_version(self.device),
            placer["flags"],
            placers.constraints_text(self.device),
            self.grade,
            f"{self.mhz:.4f}",
            seed,
        ]


@dataclass(frozen=True)
class Subject:
    """A module that is placed, with the files that it may need."""

    module: str
    files: Sequence[pathlib.Path]
    copies: int = 1
    joins: bool = False  # units, each of which has a name in the report


def placer_version(device: str) -> str:
    program = placers.PLACERS[device]["program"]
    return synthesis.tool_version(program, "--version", program)


def netlist(device: str, subject: Subject) -> pathlib.Path:
    """The folder with the netlist of a module in its wrapper, and with the Verilog that it is of."""
    name = devices.DEVICES[device]["family"]
    family = devices.FAMILIES[name]
    packs = name == "ecp5"
    files = synthesis.needed(subject.module, list(subject.files))
    # A wrapper of one port stands for the text of all.
    form = wrapper.wrap("m", [wrapper.Port("a_i", "input", 1), wrapper.Port("b_o", "output", 1)])
    said = [
        synthesis.tool_version("yosys", "-V", "yosys"),
        family["synth"],
        subject.module,
        subject.copies,
        form,
        block_registers.version() if packs else "",
    ]

    def make(folder: pathlib.Path) -> None:
        ports = wrapper.ports(subject.module, files, folder)
        (folder / "verilog").mkdir()
        outer = folder / "verilog" / f"{wrapper.WRAPPER}.v"
        outer.write_text(wrapper.wrap(subject.module, ports, subject.copies), encoding="utf-8")
        synthesis.run_yosys(
            [
                *synthesis.read_commands([*files, outer]),
                family["synth"].format(top=wrapper.WRAPPER),
                f"write_json {folder}/netlist.json",
            ],
            folder,
            subject.module,
        )
        if packs:
            block_registers.pack(folder / "netlist.json")
        for file in files:
            shutil.copyfile(file, folder / "verilog" / file.name)

    return synthesis.kept("netlist", said, files, make)


def place(
    target: Target,
    subject: Subject,
    seed: int,
    started: Callable[[], None] = lambda: None,
) -> Json:
    """Cells, clock and worst paths of one placement; throws project.Failed. `started` is called where
    the placement is not kept from before."""
    made_of = netlist(target.device, subject)

    def route(folder: pathlib.Path) -> None:
        started()
        try:
            _route(target, seed, made_of, folder)
        except placers.DoesNotFit:
            raise  # what the tool says is all, and results keep it, so it names no file
        except placers.PlacerFailed as error:
            log = folder / "log"
            if not log.exists():
                raise
            kept = failed_log(target, subject, seed)
            shutil.copyfile(log, kept)
            raise placers.PlacerFailed(f"{error}; its log is {kept}") from error

    # Verilog that synthesis makes the same netlist of is placed the same.
    routed = synthesis.kept("routed", [*target.said(seed), netlist_hash(made_of)], [], route)

    def read(folder: pathlib.Path) -> None:
        about, ends = _read(target, subject, made_of, routed)
        project.write_json(folder / "placement.json", {"seed": seed, **about})
        placed_ends.write(folder / ENDS, ends)

    folder = synthesis.kept("timed", [routed.name, made_of.name, readers()], [], read)
    return {"run": folder.name, **read_json(folder / "placement.json")}


def readers() -> str:
    """Of the modules that read what a placer leaves."""
    modules = (placed_ends, source_names, timing_graph, worst_paths)
    return project.hash_of_files([pathlib.Path(str(m.__file__)) for m in modules])


def tools(device: str) -> Json:
    """What decides a placement beside the Verilog, the clock asked for and the seed."""
    packs = devices.DEVICES[device]["family"] == "ecp5"
    return {
        "yosys": synthesis.tool_version("yosys", "-V", "yosys").split(" (")[0],
        "packer": block_registers.version()[:16] if packs else "",
        "flags": placers.PLACERS[device]["flags"],
    }


def ends_of(run: str) -> dict[placed_ends.End, Json]:
    """The ends of the paths of a placement that place() has made."""
    return placed_ends.read(synthesis.KEPT / run / ENDS)


@functools.lru_cache(maxsize=None)  # the folder's name is a key of what it holds
def netlist_hash(made_of: pathlib.Path) -> str:
    """Of a netlist apart from the places in the source that its parts come from."""
    text = (made_of / "netlist.json").read_text(encoding="utf-8")
    return hashlib.sha256(SOURCE.sub("", text).encode()).hexdigest()


def failed_log(target: Target, subject: Subject, seed: int) -> pathlib.Path:
    """Where the log of a placement that failed is kept."""
    return synthesis.KEPT / f"failed-{subject.module}-{target.device}-{seed}.log"


def _route(target: Target, seed: int, made_of: pathlib.Path, folder: pathlib.Path) -> None:
    """Places and routes, and leaves report.json and timing.sdf.gz."""
    program = placers.PLACERS[target.device]["program"]
    report, sdf = folder / "report.json", folder / "timing.sdf"
    placers.run(
        [
            program,
            *placers.flags(target.device, target.grade),
            *("--json", str(made_of / "netlist.json")),
            *("--seed", str(seed)),
            *("--freq", f"{target.mhz:.4f}"),
            "--timing-allow-fail",
            *("--report", str(report)),
            *("--sdf", str(sdf)),
            *("-q", "-l", str(folder / "log")),
        ],
        program,
        target.timeout,
    )
    placers.read_report(report, target.device, target.mhz)
    with sdf.open("rb") as plain, gzip.open(folder / "timing.sdf.gz", "wb") as packed:
        shutil.copyfileobj(plain, packed)
    sdf.unlink()


def _read(
    target: Target, subject: Subject, made_of: pathlib.Path, routed: pathlib.Path
) -> tuple[Json, dict[placed_ends.End, Json]]:
    """Clock, cells and worst paths of what the placer left, and the ends of all long paths."""
    report = placers.read_report(routed / "report.json", target.device, target.mhz)
    timing = _timing(routed / "timing.sdf.gz", target, report)
    names = source_names.Names(
        made_of / "netlist.json", made_of / "verilog", subject.module, subject.joins
    )
    about = {
        "cells": report.cells,
        "utilization": report.utilization,
        "mhz": round(report.mhz, 2),
        "asked_mhz": round(target.mhz, 2),
        "placer": version_number(placer_version(target.device)),
        "netlist": made_of.name,
        "routed": routed.name,
        **worst_paths.worst(timing, names, 1000 / target.mhz),
    }
    return about, placed_ends.ends_of(timing, names)


def _timing(sdf: pathlib.Path, target: Target, report: placers.Report) -> timing_graph.Timing:
    """The delays of a packed SDF file that agree with the report."""
    program = placers.PLACERS[target.device]["program"]
    try:
        graph = timing_graph.read_sdf(sdf)
    except (OSError, project.Failed) as error:
        raise placers.PlacerFailed(f"what {program} wrote cannot be read: {error}") from error
    timing, longest = _agreeing(graph, report.mhz)
    if timing is None:
        raise placers.PlacerFailed(
            f"the longest path in the SDF file of {program} takes {longest:.2f} ns, "
            f"and its report says {1000 / report.mhz:.2f}; this version writes them otherwise"
        )
    return timing


def _agreeing(graph: timing_graph.Graph, mhz: float) -> tuple[timing_graph.Timing | None, float]:
    """The timing, without the clock's skew or with it, that has the period of this clock, and the
    longest path."""
    longest = 0.0
    for skew in (False, True):
        timing = timing_graph.Timing(graph, skew)
        longest = max((period for period, _ in timing.endpoints()), default=0.0)
        if abs(longest * mhz / 1000 - 1) <= SAME_PERIOD:
            return timing, longest
    return None, longest


def version_number(said: str) -> str:
    """Out of a tool's sentence about its version."""
    return searched(r"Version ([^)\s]+)", said)[1] if "Version" in said else said


ARRIVAL = r"Latest arrival time in '[^']*' is (\d+)"


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

    said: list[Any] = [synthesis.tool_version("yosys", "-V", "yosys"), synth, module]
    folder = synthesis.kept("sta", said, files, make)
    text = (folder / "sta.txt").read_text(encoding="utf-8")
    return int(searched(ARRIVAL, text)[1]) / 1000
