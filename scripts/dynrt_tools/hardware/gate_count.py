# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Counts the gates of a core's Verilog by the thesis's rule (gate_rule.py), instance by
instance."""

import concurrent.futures
import json
import pathlib
from collections.abc import Sequence
from typing import Any

from dynrt_tools.hardware import gate_rule, rtl_files, synthesis
from dynrt_tools.project import read_json

# Virtex-II, as devices.py synthesizes it, but memories stay what the source says: how many bits,
# with how many ports. -nosrl: a chain of flip-flops is flip-flops.
SYNTH = (
    "synth_xilinx -family xc2v -flatten -nowidelut -noiopad -noclkbuf -nosrl -top {top} -run {run}"
)


def count(
    top: str,
    parameters: dict[str, Any],
    files: list[pathlib.Path],
    blackboxes: Sequence[pathlib.Path] = (),
) -> gate_rule.Count:
    """The gates of a module, without those of the modules in the files `blackboxes`."""
    said = [
        synthesis.tool_version("yosys", "-V", "yosys"),
        top,
        SYNTH,
        parameters,
        [f.name for f in blackboxes],
    ]
    files = synthesis.needed(top, files)

    def make(folder: pathlib.Path) -> None:
        whole = folder / "whole.json"
        synthesis.run_yosys(
            [
                *synthesis.read_commands(files, blackboxes),
                *synthesis.chosen(top, parameters),
                SYNTH.format(top=top, run="begin:map_memory"),
                SYNTH.format(top=top, run="fine:check"),
                f"write_json {whole}",
            ],
            folder,
            top,
        )
        found = read_json(whole)["modules"]
        module = next(m for name, m in found.items() if "top" in m.get("attributes", {}))
        wanted = {
            name: {
                key: cell[key]
                for key in ("type", "parameters", "port_directions", "connections")
                if key in cell
            }
            for name, cell in module["cells"].items()
            if cell["type"] not in boxed
        }
        (folder / "cells.json").write_text(json.dumps(wanted), encoding="utf-8")
        whole.unlink()

    boxed = set(synthesis.modules(blackboxes))
    folder = synthesis.kept("gates", said, files, make)
    return gate_rule.count(read_json(folder / "cells.json"))


def count_core(
    unit_files: list[pathlib.Path], pool: concurrent.futures.Executor
) -> dict[str, gate_rule.Count]:
    """The gates of every instance, of the counters and of the join, by name."""
    files = rtl_files.hand_written() + unit_files
    core = next(f for f in unit_files if f.stem == rtl_files.CORE)
    apart = [f for f in files if f.stem == rtl_files.COUNTERS or (f in unit_files and f != core)]
    jobs = {"join": pool.submit(count, rtl_files.CORE, {}, files, tuple(apart))}
    jobs |= {
        part.name: pool.submit(count, part.module, part.parameters, files)
        for part in rtl_files.instances(core)
    }
    return {name: job.result() for name, job in jobs.items()}
