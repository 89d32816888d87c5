# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""FPGA families, how Yosys synthesizes for them, and devices with their resources."""

import re
from typing import TypedDict

from dynrt_tools.project import Failed

Takes = list[tuple[str, dict[str, float]]]


class Family(TypedDict):
    """How a family is synthesized, and the kinds of its cells."""

    name: str
    synth: str
    cells: dict[str, str]
    takes: Takes


class Device(TypedDict):
    """The resources of a device; `delay` is empty where hlsc has no model of its timing."""

    name: str
    family: str
    delay: str
    has: dict[str, int]
    source: str


# How a family is synthesized and which of its cells count as what.
#   synth    Yosys's command. Without -nowidelut Yosys 0.23 takes the multiplexers behind the LUTs for
#            free and builds 2 to 3 times the LUTs; -noiopad, because a unit's ports are not pins;
#            flattened, since its stat -json is no JSON where there is a hierarchy.
#            iCE40 has no RAM of LUTs, and Yosys refuses a memory that asks for one.
#   cells    the columns of the table, each a pattern of cells
#   takes    what a cell takes of the device's resources, the first pattern that fits:
#            ECP5: a CCU2C takes both LUTs of a slice; a TRELLIS_DPR16X4 the four of two slices, and
#            of a third, which drives its write port, the two inputs' worth that nextpnr-ecp5 calls
#            RAMW (ECP5 Family Data Sheet FPGA-DS-02012, 2.2.2.3).
#            Virtex-II and 7-series: a LUT RAM takes a LUT for each 16 or 64 bits and port (DS031,
#            UG474); a carry multiplexer stands beside the LUT that feeds it and takes none.
#            iCE40: a carry cell stands in the logic cell of its LUT; logic cells have one LUT and
#            one flip-flop.
FAMILIES: dict[str, Family] = {
    "ecp5": {
        "name": "Lattice ECP5",
        "synth": "synth_ecp5 -nowidelut -top {top}",
        "cells": {
            "LUT": r"LUT4$",
            "carry": r"CCU2C$",
            "LUT RAM": r"TRELLIS_DPR16X4$",
            "FF": r"TRELLIS_FF$",
            "mult": r"MULT18X18D$",
            "BRAM": r"(DP16KD|PDPW16KD)$",
        },
        "takes": [
            (r"LUT4$", {"LUT4": 1}),
            (r"CCU2C$", {"LUT4": 2}),
            (r"TRELLIS_DPR16X4$", {"LUT4": 6}),
            (r"TRELLIS_FF$", {"FF": 1}),
            (r"(DP16KD|PDPW16KD)$", {"block RAM": 1}),
            (r"MULT18X18D$", {"multiplier": 1}),
        ],
    },
    "ice40": {
        "name": "Lattice iCE40",
        "synth": "hierarchy -top {top}; setattr -unset ram_style m:*; synth_ice40 -top {top}",
        "cells": {
            "LUT": r"SB_LUT4$",
            "carry": r"SB_CARRY$",
            "LUT RAM": r"\b\B",
            "FF": r"SB_DFF\w*$",
            "mult": r"SB_MAC16$",
            "BRAM": r"SB_RAM40_4K\w*$",
        },
        "takes": [
            (r"SB_LUT4$", {"LUT4": 1}),
            (r"SB_DFF\w*$", {"FF": 1}),
            (r"SB_RAM40_4K\w*$", {"block RAM": 1}),
        ],
    },
    "xc7": {
        "name": "Xilinx 7-series",
        "synth": "synth_xilinx -family xc7 -flatten -noiopad -top {top}",
        "cells": {
            "LUT": r"(LUT[1-6]|INV)$",
            "carry": r"CARRY4$",
            "LUT RAM": r"(RAM\d+(M|X\d+[SD])|SRL\w+)(_\d+)?$",
            "FF": r"(FD|LD)\w*$",
            "mult": r"DSP48E1$",
            "BRAM": r"RAMB\w*$",
        },
        "takes": [
            (r"(LUT[1-6]|INV|SRL\w+|RAM32X1S|RAM64X1S)$", {"LUT6": 1}),
            (r"(RAM32X1D|RAM64X1D)$", {"LUT6": 2}),
            (r"(RAM32M|RAM64M|RAM128X1D|RAM256X1S)$", {"LUT6": 4}),
            (r"(FD|LD)\w*$", {"FF": 1}),
            (r"RAMB36\w*$", {"block RAM": 1}),
            (r"RAMB18\w*$", {"block RAM": 0.5}),
            (r"DSP48E1$", {"multiplier": 1}),
        ],
    },
    "xc2v": {
        "name": "Xilinx Virtex-II",
        "synth": "synth_xilinx -family xc2v -flatten -nowidelut -noiopad -top {top}",
        "cells": {
            "LUT": r"(LUT[1-6]|INV)$",
            "carry": r"MUXCY$",
            "LUT RAM": r"(RAM\d+X\d+[SD]|SRL16E?)(_\d+)?$",
            "FF": r"(FD|LD)\w*$",
            "mult": r"MULT18X18S?$",
            "BRAM": r"RAMB16\w*$",
        },
        "takes": [
            (r"(LUT[1-4]|INV|SRL16|SRL16E|RAM16X1S)(_\d+)?$", {"LUT4": 1}),
            (r"(RAM16X1D|RAM32X1S)(_\d+)?$", {"LUT4": 2}),
            (r"(RAM32X1D|RAM64X1S)(_\d+)?$", {"LUT4": 4}),
            (r"(RAM64X1D|RAM128X1S)(_\d+)?$", {"LUT4": 8}),
            (r"(FD|LD)\w*$", {"FF": 1}),
            (r"RAMB16\w*$", {"block RAM": 1}),
            (r"MULT18X18S?$", {"multiplier": 1}),
        ],
    },
}
COLUMNS = ("LUT", "carry", "LUT RAM", "FF", "mult", "BRAM")

# The resources of devices. `source` is where the figures are from, `delay` hlsc's model of its timing.
DEVICES: dict[str, Device] = {
    "ecp5-85": {
        "name": "Lattice LFE5U-85F",
        "family": "ecp5",
        "delay": "hls/compiler/delay/ecp5.json",
        "has": {"LUT4": 83640, "FF": 83640, "block RAM": 208, "multiplier": 156},
        "source": "ECP5 and ECP5-5G Family Data Sheet FPGA-DS-02012, table 1.1; LUTs and flip-flops "
        "as nextpnr-ecp5 counts them",
    },
    "ice40-hx8k": {
        "name": "Lattice iCE40HX8K",
        "family": "ice40",
        "delay": "hls/compiler/delay/ice40-hx.json",
        "has": {"LUT4": 7680, "FF": 7680, "block RAM": 32, "multiplier": 0},
        "source": "iCE40 LP/HX Family Data Sheet FPGA-DS-02029, table 1.1; block RAMs of 4 kbit",
    },
    "artix7-100": {
        "name": "Xilinx XC7A100T",
        "family": "xc7",
        "delay": "",
        "has": {"LUT6": 63400, "FF": 126800, "block RAM": 135, "multiplier": 240},
        "source": "7 Series FPGAs Data Sheet: Overview DS180; block RAMs of 36 kbit",
    },
    "artix7-200": {
        "name": "Xilinx XC7A200T",
        "family": "xc7",
        "delay": "",
        "has": {"LUT6": 134600, "FF": 269200, "block RAM": 365, "multiplier": 740},
        "source": "7 Series FPGAs Data Sheet: Overview DS180; block RAMs of 36 kbit",
    },
    "virtex2-6000": {
        "name": "Xilinx XC2V6000, the thesis's",
        "family": "xc2v",
        "delay": "",
        "has": {"LUT4": 67584, "FF": 67584, "block RAM": 144, "multiplier": 144},
        "source": "Virtex-II Platform FPGAs Data Sheet DS031, module 1; block RAMs of 18 kbit",
    },
}


class Unknown(Failed):
    """A device that there is not, in a sentence."""


def family_of(name: str) -> str:
    """The family of a device, or a family's own name."""
    if name in DEVICES:
        return DEVICES[name]["family"]
    if name in FAMILIES:
        return name
    raise Unknown(
        f"there is no device '{name}'; the devices are {', '.join(DEVICES)}, "
        f"the families, of which only areas are known, {', '.join(FAMILIES)}"
    )


def area(family: str, cells: dict[str, int]) -> dict[str, int]:
    """The columns of the table: how many cells of each kind."""
    return {
        column: sum(
            n for cell, n in cells.items() if re.match(FAMILIES[family]["cells"][column], cell)
        )
        for column in COLUMNS
    }


def resources(family: str, cells: dict[str, int]) -> dict[str, float]:
    """The resources of a device of the family that the cells take."""
    takes = FAMILIES[family]["takes"]
    taken: dict[str, float] = dict.fromkeys((n for _, amounts in takes for n in amounts), 0)
    for cell, count in cells.items():
        amounts = (amounts for pattern, amounts in takes if re.match(pattern, cell))
        for resource, amount in next(amounts, {}).items():
            taken[resource] += amount * count
    return taken


def _cells_of(pattern: str) -> str:
    """The types of cells that a pattern of `cells` or `takes` means, in a reader's words."""
    names = pattern.replace(r"(_\d+)?", "").rstrip("$")
    return re.sub(r"\\w[*+]", "*", names).strip("()").replace("|", ", ")


def formula(family: str) -> str:
    """How many LUTs of a device the cells take, as a sum over the types of cells: what `resources`
    computes of them."""
    takes = FAMILIES[family]["takes"]
    lut = next(iter(takes[0][1]))
    terms = []
    for pattern, amounts in takes:
        if amount := amounts.get(lut):
            cells = _cells_of(pattern)
            cells = f"({cells})" if "," in cells else cells
            terms.append(cells if amount == 1 else f"{amount:g} x {cells}")
    return f"{lut} of the device = {' + '.join(terms)}"


def shortages(device: str, taken: dict[str, float]) -> list[str]:
    """A phrase for each resource that a device lacks."""
    has = DEVICES[device]["has"]
    return [
        f"{amount:,.0f} {resource}{'s' if amount != 1 and resource != 'FF' else ''} of "
        f"{has.get(resource, 0):,}, {amount - has.get(resource, 0):,.0f} too many"
        for resource, amount in taken.items()
        if amount > has.get(resource, 0)
    ]
