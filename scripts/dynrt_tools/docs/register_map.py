# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The board's register map for other languages: a C header and SystemRDL, of the one description in
rtl/board/dynrt_registers.vh. Its Markdown is the page of the registers (registers.py)."""

import re
from dataclasses import dataclass

from dynrt_tools import project

SOURCE = "rtl/board/dynrt_registers.vh"
CONSTANT = re.compile(
    r"^localparam (?:\[\S+\] )?(\w+) = (?:\d+'h([0-9a-f]+)|(\d+));(?: *// *(.*))?$", re.MULTILINE
)
ACCESS = re.compile(r"(RW|R|W) +(.*)")
PART = re.compile(r"([a-z ]+) in (?:bits )?(\d+):(\d+)")  # of a register, as its comment names it
# Registers of which single bits have a name, a constant that begins with that of the register.
OF_BITS = ("CONTROL", "STATUS", "MEMORY_ERROR")
WIDE = {"MEMORY_ERROR_RESPONSE": 2}  # bits of a field that has more than one
NARROW = ("IRQ_ENABLE", "IRQ_PENDING")  # registers of one bit
READ_ONLY = ("MEMORY_ERROR_WRITE", "MEMORY_ERROR_RESPONSE")  # fields, however their register is
# Registers that the board never changes by itself.
OF_SOFTWARE = ("IRQ_ENABLE", "FRAME", "SCAN", "SCAN_CLOCKS", "MEMORY_BASE_LOW", "MEMORY_BASE_HIGH")
CLEARED_BY_ONE = ("IRQ_PENDING", "MEMORY_ERROR_SEEN")
ROWS = {"FRAME": 64, "SCAN": 16}  # registers that follow one another
SOFTWARE = {"R": "sw = r; hw = w;", "W": "sw = w; hw = r;", "RW": "sw = rw; hw = rw;"}


@dataclass(frozen=True)
class Constant:
    name: str
    value: int
    written: str  # as C has it
    meaning: str


def constants(text: str) -> list[Constant]:
    """Every constant of the map, in its order."""
    return [
        Constant(
            name, int(hexadecimal or number, 16 if hexadecimal else 10), written, meaning or ""
        )
        for name, hexadecimal, number, meaning in CONSTANT.findall(text)
        for written in [f"0x{hexadecimal}u" if hexadecimal else f"{number}u"]
    ]


def read() -> list[Constant]:
    return constants((project.ROOT / SOURCE).read_text(encoding="utf-8"))


def c_header(found: list[Constant]) -> str:
    """The constants with the prefix DYNRT_; those of registers are byte addresses."""
    lines = [
        "/* Copyright the dynrt authors.",
        " * SPDX-License-Identifier: Apache-2.0",
        " *",
        f" * Made by scripts/docs --renew of {SOURCE}; do not edit. DYNRT_REG_ is the byte",
        " * address of a register of 32 bits, R read, W write; the others are values and numbers of",
        " * bits.",
        " */",
        "#ifndef DYNRT_REGISTERS_H",
        "#define DYNRT_REGISTERS_H",
        "",
    ]
    for constant in found:
        comment = f" /* {constant.meaning} */" if constant.meaning else ""
        lines.append(f"#define DYNRT_{constant.name} {constant.written}{comment}")
    return "\n".join([*lines, "", "#endif", ""])


def _field(name: str, access: str, bits: str, meaning: str, full_name: str) -> str:
    clears = " onwrite = woclr;" if full_name in CLEARED_BY_ONE else ""
    described = f' desc = "{_quoted(meaning)}";' if meaning else ""
    accesses = SOFTWARE["R" if full_name in READ_ONLY else access]
    if full_name in OF_SOFTWARE:
        accesses = "sw = rw; hw = r;"
    return f"    field {{ {accesses}{clears}{described} }} {name}[{bits}];"


def _quoted(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')


def _register(constant: Constant, bits: list[Constant]) -> list[str]:
    name = constant.name.removeprefix("REG_")
    found = ACCESS.fullmatch(constant.meaning)
    if not found:
        raise project.Failed(
            f"{SOURCE}: the comment of {constant.name} is '{constant.meaning}'; it should begin "
            "with R, W or RW"
        )
    access, meaning = found.groups()
    lines = ["  reg {", f'    desc = "{_quoted(meaning)}";']
    for bit in bits:
        last = bit.value + WIDE.get(bit.name, 1) - 1
        field = bit.name.removeprefix(f"{name}_")
        lines.append(_field(field, access, f"{last}:{bit.value}", bit.meaning, bit.name))
    parts = PART.findall(meaning)
    for part, last, first in parts:
        field = part.strip().replace(" ", "_").upper()
        lines.append(_field(field, access, f"{last}:{first}", "", f"{name}_{field}"))
    if not bits and not parts:
        lines.append(_field("VALUE", access, "0:0" if name in NARROW else "31:0", "", name))
    rows = f"[{ROWS[name]}]" if name in ROWS else ""
    return [*lines, f"  }} {name}{rows} @ 0x{constant.value:03x};"]


def system_rdl(found: list[Constant]) -> str:
    """The registers as an address map of SystemRDL 2.0."""
    lines = [
        "// Copyright the dynrt authors.",
        "// SPDX-License-Identifier: Apache-2.0",
        "//",
        f"// Made by scripts/docs --renew of {SOURCE}; do not edit.",
        "addrmap dynrt {",
        '  name = "dynrt";',
        '  desc = "Registers of a ray tracing core for dynamic scenes";',
        "  default regwidth = 32;",
    ]
    for constant in found:
        if not constant.name.startswith("REG_"):
            continue
        name = constant.name.removeprefix("REG_")
        bits = [c for c in found if name in OF_BITS and c.name.startswith(f"{name}_")]
        lines += _register(constant, bits)
    return "\n".join([*lines, "};", ""])


def files() -> dict[str, str]:
    """Both, by their files below docs."""
    found = read()
    return {
        "reference/dynrt_registers.h": c_header(found),
        "reference/dynrt_registers.rdl": system_rdl(found),
    }
