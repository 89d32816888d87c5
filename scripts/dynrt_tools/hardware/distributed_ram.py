# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Takes constants off the pins of ECP5's distributed RAM. For nextpnr a constant is one net from one
source to all its ends across the chip, and a wire of it that is given up takes all behind it along. A
RAM of fewer than 16 rows has address bits of zero, and one that is written in each clock an enable of
one; that is most of what constants go to.

An address bit that is constant, in writing as in reading, becomes a copy of one that is not: other
rows, but as many, and each is read where it was written. An enable of one becomes the RAM's own."""

import pathlib
from collections import Counter
from typing import Any

from dynrt_tools import project

RAM = "TRELLIS_DPR16X4"
CONSTANTS = ("0", "1", "x")
PINS = ADDRESS, ENABLE = "address bit", "enable"


def version() -> str:
    """Of this file: what is made of a netlist depends on all of it."""
    return project.hash_of_files([pathlib.Path(__file__)])


def spare(design: Any) -> Counter[str]:
    """Changes a netlist of Yosys; gives how many pins of each kind have lost a constant."""
    spared: Counter[str] = Counter()
    for module in design["modules"].values():
        for cell in module["cells"].values():
            if cell["type"] == RAM:
                spared += _spare(cell)
    return spared


def _spare(cell: Any) -> Counter[str]:
    ends, parameters = cell["connections"], cell["parameters"]
    spared: Counter[str] = Counter()
    writes, reads = ends["WAD"], ends["RAD"]
    bits = list(enumerate(zip(writes, reads)))
    used = [i for i, both in bits if not set(both) & set(CONSTANTS)]
    # Rows that are there from the start lie where the constants put them.
    starts_empty = set(parameters.get("INITVAL", "0").strip()) <= {"0", "x"}
    for i, (write, read) in bits:
        if used and starts_empty and write == read and write in CONSTANTS:
            writes[i], reads[i] = writes[used[0]], reads[used[0]]
            spared[ADDRESS] += 2
    if ends["WRE"] == ["1"] and parameters.get("WREMUX", "WRE").strip() == "WRE":
        parameters["WREMUX"] = "1 "  # Yosys writes a string of digits with a blank behind it
        ends["WRE"] = []
        spared[ENABLE] += 1
    return spared
