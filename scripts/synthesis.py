# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Synthesizes a module with Yosys and counts what it takes of a device."""

import json
import re
import subprocess
import time

import rtl_files

# How a device is synthesized, and which cells count as what. Without -nowidelut Yosys 0.23 takes
# the multiplexers behind the LUTs for free and builds 2 to 3 times the LUTs; -noiopad, because a
# unit's ports are not pins; flattened, since its stat -json is no JSON where there is a hierarchy.
DEVICES = {
    "ecp5": {
        "name": "Lattice ECP5",
        "synth": "synth_ecp5 -nowidelut -top {top}",
        "LUT": r"LUT4$",
        "carry": r"CCU2C$",
        "LUT RAM": r"TRELLIS_DPR16X4$",
        "FF": r"TRELLIS_FF$",
        "mult": r"MULT18X18D$",
        "BRAM": r"(DP16KD|PDPW16KD)$",
    },
    "xc2v": {
        "name": "Xilinx Virtex-II",
        "synth": "synth_xilinx -family xc2v -flatten -nowidelut -noiopad -top {top}",
        "LUT": r"(LUT[1-6]|INV)$",
        "carry": r"MUXCY$",
        "LUT RAM": r"(RAM\d+X\d+[SD]|SRL16E?)(_\d+)?$",
        "FF": r"(FD|LD)\w*$",
        "mult": r"MULT18X18S?$",
        "BRAM": r"RAMB16\w*$",
    },
}
COLUMNS = ("LUT", "carry", "LUT RAM", "FF", "mult", "BRAM")
MODULE = re.compile(r"^\s*module\s+(\w+)", re.MULTILINE)


def modules(files):
    return [m for f in files for m in MODULE.findall(f.read_text(encoding="utf-8"))]


class SynthesisFailed(Exception):
    """Why, in a sentence."""


def synthesize(device, top, files, folder):
    """Runs Yosys; returns the cells by column and the seconds it took."""
    folder.mkdir(parents=True, exist_ok=True)
    stat, log = folder / f"{top}.stat.json", folder / f"{top}.log"
    stat.unlink(missing_ok=True)
    script = [f"verilog_defaults -add -I{f}" for f in rtl_files.include_folders(files)]
    script += [f"read_verilog {f}" for f in files]
    script += [DEVICES[device]["synth"].format(top=top), "check -assert",
               f"tee -q -o {stat} stat -json"]
    start = time.monotonic()
    result = subprocess.run(["yosys", "-q", "-l", str(log), "-p", "; ".join(script)],
                            capture_output=True, text=True, check=False)
    if result.returncode != 0 or not stat.exists():
        last = (result.stderr or result.stdout).strip().splitlines()
        raise SynthesisFailed(f"{top} on {device}: {last[-1] if last else 'Yosys failed'}; "
                              f"the whole log is {log}")
    cells = json.loads(stat.read_text(encoding="utf-8"))["design"]["num_cells_by_type"]
    row = {c: sum(n for cell, n in cells.items() if re.match(DEVICES[device][c], cell))
           for c in COLUMNS}
    return row, time.monotonic() - start
