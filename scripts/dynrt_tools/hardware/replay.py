# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Records a frame of the native model and renders it again in Icarus Verilog, from the core's
Verilog: every word that the core writes must be the model's. Icarus must read it without a warning.

With --netlist, Icarus also renders it with the core's netlist for ECP5, cell by cell, which must take
the same clocks. Registers are in its blocks as scripts/place has it, and its distributed RAMs are
without constants as scripts/bitstream has it. The cells are the models that Yosys ships and those of
ecp5_cells.v."""

import argparse
import pathlib
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable
from typing import Any

from dynrt_tools import project
from dynrt_tools.hardware import block_registers, devices, distributed_ram, rtl_files, synthesis

HERE = project.ROOT / "verif" / "netlist"


def run(command: list[Any], silent: bool = False) -> str:
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    output = (result.stdout + result.stderr).strip()
    if result.returncode != 0 or (silent and output):
        sys.exit(f"replay: {pathlib.Path(command[0]).name} failed or complained:\n{output}")
    return output


def for_icarus(top: str) -> list[str]:
    """Commands that make of a netlist one that Icarus reads in seconds."""
    return [
        # Yosys has a black box DP16KD, so the model has another name. What starts as zero in the
        # device starts as unknown in it.
        *(f"setparam -unset INITVAL_{i:02X} t:DP16KD" for i in range(64)),
        "chtype -set ecp5_block_ram t:DP16KD",
        # A bit that changes is no reason to look at all that reads its neighbours.
        "splitnets",
        # Flip-flops become part of the core: for their generate blocks Icarus 11 takes time by the
        # square of their number, and then for each clock the way into each of them.
        "read_verilog -overwrite +/ecp5/cells_sim.v",
        f"delete =* ={top} %d =TRELLIS_FF %d",
        f"hierarchy -top {top}",
        "proc",
        "flatten",
        "opt_expr",
        "opt_clean -purge",
    ]


def packed(
    folder: pathlib.Path, top: str, design: list[str], then: list[str], verilog: str
) -> Counter[str]:
    """Writes a file of Verilog for Icarus: the netlist that the commands `design` make, with registers
    moved into blocks and constants taken off distributed RAM; gives how many, by the block's type and
    the kind of pin."""
    netlist_file, what = folder / "netlist.json", f"the netlist of {top}"
    synthesis.run_yosys([*design, f"write_json {netlist_file}"], folder, what)
    moved = block_registers.pack(netlist_file)
    packed_design = project.read_json(netlist_file)
    spared = distributed_ram.spare(packed_design)
    project.write_json(netlist_file, packed_design)
    synthesis.run_yosys(
        [
            f"read_json {netlist_file}",
            *for_icarus(top),
            *then,
            f"write_verilog -noattr {folder / verilog}",
        ],
        folder,
        what,
    )
    netlist_file.unlink()
    return moved + spared


def shipped_cells() -> pathlib.Path:
    """The folder of Yosys's own models."""
    return pathlib.Path(shutil.which("yosys") or "").resolve().parent.parent / "share/yosys/ecp5"


def icarus(
    args: argparse.Namespace, name: str, sources: Iterable[str | pathlib.Path], warnings: list[str]
) -> str:
    """What the bench prints of these sources; ends unless it saw that all is the same."""
    program = args.work / f"{name}.vvp"
    run(
        [
            "iverilog",
            "-g2005",
            *warnings,
            "-o",
            program,
            "-s",
            "core_bench",
            f"-I{args.work}",
            f"-I{args.verilog}",
            *sources,
            HERE / "core_bench.v",
        ],
        silent=True,
    )
    lines = run(["vvp", program, f"+folder={args.work}"]).splitlines()
    print(f"{name}:", *lines, sep="\n", flush=True)
    if len(lines) < 2 or lines[-1] != "the same":
        sys.exit(f"replay: the {name} rendered something else")
    return lines[-2]


def netlist(sources: list[pathlib.Path]) -> list[str | pathlib.Path]:
    """The files of the core as scripts/place gives it to the placer, with its cells."""
    synth = devices.FAMILIES["ecp5"]["synth"]

    def make(folder: pathlib.Path) -> None:
        design = [
            *synthesis.read_commands(files),
            synth.format(top=rtl_files.CORE),
            "check -assert",
        ]
        changed = packed(folder, rtl_files.CORE, design, [], "netlist.v")
        for kind in (block_registers.MULTIPLIER, block_registers.BLOCK_RAM, *distributed_ram.PINS):
            if not changed[kind]:
                raise project.Failed(f"{rtl_files.CORE}: the netlist's {kind} is left as it was")

    try:
        version = synthesis.tool_version("yosys", "-V", "yosys")
        files = synthesis.needed(rtl_files.CORE, sources)
        passes = [block_registers.version(), distributed_ram.version()]
        said = [version, synth, *passes, for_icarus(rtl_files.CORE)]
        folder = synthesis.kept("netlist", said, files, make)
    except project.Failed as error:
        sys.exit(f"replay: {error}")
    cells = shipped_cells()
    return [f"-I{cells}", folder / "netlist.v", cells / "cells_sim.v", HERE / "ecp5_cells.v"]


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--record", required=True, metavar="PROGRAM", help="record_frame")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--size", required=True, metavar="WxH")
    parser.add_argument("--config", default="thesis")
    parser.add_argument(
        "--verilog",
        type=pathlib.Path,
        metavar="FOLDER",
        default=rtl_files.GENERATED,
        help="the Verilog of the configuration",
    )
    parser.add_argument("--work", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument(
        "--netlist", action="store_true", help="render it with the netlist for ECP5 too"
    )
    args = parser.parse_args()

    args.work.mkdir(parents=True, exist_ok=True)
    print(run([args.record, args.scene, args.config, args.size, args.work]))
    sources = rtl_files.core_files(args.verilog)
    rtl = icarus(args, "Verilog", sources, ["-Wall"])
    if args.netlist:
        gates = icarus(args, "netlist", netlist(sources), [])
        if rtl != gates:
            sys.exit(f"replay: the Verilog says '{rtl}', its netlist '{gates}'")
