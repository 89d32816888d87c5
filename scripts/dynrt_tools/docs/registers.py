# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of the registers and the memory's formats, from the headers that define them."""

import itertools
import re
from collections.abc import Iterator, Mapping

from dynrt_tools import project
from dynrt_tools.docs import limits
from dynrt_tools.hardware import rtl_files
from dynrt_tools.project import Json, read_json

FRAME = "hls/units/frame.h"
MEMORY = "hls/units/memory_format.h"
GENERATED = "rtl/generated"
THESIS = "thesis"
BOARD = "rtl/board/dynrt_registers.vh"
SCAN = "hls/units/scan_out.h"
FIELD = re.compile(r"(?:hls::uint<32>|hls::OptionalField<([^;]*?), hls::uint<32>>)\s+(\w+);")
PLACE = re.compile(r"^`define DYNRT_CORE_FRAME_(\w+) (\d+)$", re.MULTILINE)
REGISTER = re.compile(r"^localparam (?:\[\S+\] )?(\w+) = (\S+?);(?: *// *(.*))?$", re.MULTILINE)
HEX = "'h"
SCANNED = re.compile(r"uint<32> (\w+);(?: *///< *(.*))?")
CONSTANT = re.compile(
    r"((?:^///[^\n]*\n)+^template[^\n]*\n)?^inline constexpr unsigned (\w+)\s*=\s*([^;]+);"
    r"(?:\s*///<\s*(.*))?$",
    re.MULTILINE,
)
OF_PORT = "kPortAddressBits"  # the first constant of a memory behind the port
# Each part of that memory: its content, its first byte, its size and the bytes of an item.
PORT_ITEMS = (
    ("nodes", "0", "kMaxNodes * kNodeBytes", "kNodeBytes"),
    ("list entries", "kEntriesAt", "kMaxListEntries * kEntryBytes", "kEntryBytes"),
    (
        "matrix columns, and boxes of objects",
        "kColumnsAt",
        "(1u << kAddressBits) * kColumnBytes",
        "kColumnBytes",
    ),
    ("pixels of 32 bits", "kPixelsAt", "kBankWords * 4", "4"),
    ("pixels of 16 bits", "kPixelsAt", "kBankWords * 2", "2"),
    ("hit records", "kHitsAt", "2 * kBankWords * 4", "2 * kHitWords * 4"),
)
STRUCT = re.compile(
    r"((?:^///[^\n]*\n)*)(?:^template[^\n]*\n)?^struct (\w+) \{\n(.*?)^\};", re.M | re.S
)


def source(name: str) -> str:
    return (project.ROOT / name).read_text(encoding="utf-8")


def link(name: str) -> str:
    return f"[{name}](../../{name})"


def links_to(configurations_: list[str], suffix: str) -> str:
    """A link to a file of each of these cores."""
    return ", ".join(f"[`{c}`](../../{generated(c, suffix)})" for c in configurations_)


def frame_fields(text: str) -> Iterator[tuple[str, str, str]]:
    """Name, condition and meaning of each register of a frame."""
    struct = text.partition("struct FrameRegisters {")[2].partition("HLS_FIELDS")[0]
    above = ""
    pending = ""
    for line in struct.splitlines():
        stripped = line.strip()
        if stripped.startswith("///") and not stripped.startswith("///<"):
            above = stripped[3:].strip()
            continue
        pending = f"{pending} {stripped}".strip()
        found = FIELD.search(pending)
        if not found:
            continue
        meaning = pending.partition("///<")[2].strip() or above
        yield found[2], (found[1] or "").replace("C::", "").replace("<C>", ""), meaning
        above = pending = ""


def configurations() -> list[str]:
    """Those whose core is checked in, that of the thesis first."""
    return sorted(rtl_files.all_checked_in(), key=lambda name: name != THESIS)


def generated(configuration: str, suffix: str) -> str:
    """A file of a core that is checked in."""
    return f"{GENERATED}/{configuration}/dynrt_core.{suffix}"


def places(text: str) -> dict[str, int]:
    """By the register's name its number in a core, from its dynrt_core.vh."""
    return {name.lower(): int(bit) // 32 for name, bit in PLACE.findall(text)}


def frame_columns(cores: Mapping[str, str]) -> list[tuple[str, dict[str, int]]]:
    """Heading and numbers of each column, of which cores with the same registers share one; the cores
    by their names, as their dynrt_core.vh."""
    shared: dict[tuple[tuple[str, int], ...], list[str]] = {}
    for name, text in cores.items():
        shared.setdefault(tuple(places(text).items()), []).append(f"`{name}`")
    return [(", ".join(names), dict(found)) for found, names in shared.items()]


def frame_table(cores: Mapping[str, str]) -> list[str]:
    columns = frame_columns(cores)
    first = int(register("REG_FRAME"), 16)
    headings = ["register", *[heading for heading, _ in columns], "meaning", "only if"]
    lines = [f"| {' | '.join(headings)} |", "|---" * len(headings) + "|"]
    for name, condition, meaning in frame_fields(source(FRAME)):
        addresses = [
            f"`0x{first + 4 * found[name]:03x}`" if name in found else "-" for _, found in columns
        ]
        only = f"`{condition}`" if condition else ""
        lines.append(f"| {' | '.join([f'`{name}`', *addresses, meaning, only])} |")
    return lines


def comment_of(text: str) -> str:
    """The description at the head of a file, without the licence."""
    head = itertools.takewhile(lambda line: line.startswith("//"), text.splitlines())
    return "\n".join([line[2:].strip() for line in head][3:])


def board_table(text: str) -> list[str]:
    """The constants of the board's map; one without a comment of its own has that above it."""
    lines = ["| name | value | meaning |", "|---|---|---|"]
    above = ""
    for line in text.splitlines():
        found = REGISTER.match(line)
        if not found:
            above = line.removeprefix("//").strip()
            continue
        name, value, meaning = found.groups()
        shown = f"0x{value.rpartition(HEX)[2]}" if HEX in value else value
        lines.append(f"| `{name}` | `{shown}` | {meaning or above} |")
    return lines


def scan_table(text: str) -> list[str]:
    """The registers of the scan-out, from the struct that it reads them as."""
    struct = text.partition("struct ScanConfig {")[2].partition("HLS_FIELDS")[0]
    first = int(register("REG_SCAN"), 16)
    lines = ["| register | address | meaning |", "|---|---|---|"]
    for place, (name, meaning) in enumerate(SCANNED.findall(struct)):
        lines.append(f"| `{name}` | `0x{first + 4 * place:03x}` | {meaning} |")
    return lines


def register(name: str) -> str:
    """The address of a register of the board, in hexadecimal."""
    values = {n: str(v).rpartition(HEX)[2] for n, v, _ in REGISTER.findall(source(BOARD))}
    return values[name]


def counters_table(join: Json) -> list[str]:
    lines = ["| number | counter |", "|---|---|"]
    for number, counter in enumerate(join["counters"]):
        lines.append(f"| {number} | `{counter['name']}` |")
    return lines


def constants_table(text: str) -> list[str]:
    """The constants of the memory; of a template the meaning stands above it."""
    lines = ["| constant | value | meaning |", "|---|---|---|"]
    for above, name, value, meaning in CONSTANT.findall(re.sub(r"=\s*1u\s*<<", "= 1u <<", text)):
        said = meaning or uncommented(above.partition("template")[0]).replace("\n", " ")
        lines.append(f"| `{name}` | `{' '.join(value.split())}` | {said} |")
    return lines


def uncommented(comment: str) -> str:
    """What a comment of lines that begin with /// says."""
    return "\n".join(line.removeprefix("///").removeprefix(" ") for line in comment.splitlines())


def port_comment(text: str) -> str:
    """What the header says of a memory behind the port."""
    found = project.searched(
        rf"((?:^///[^\n]*\n)+)inline constexpr unsigned {OF_PORT} ", text, re.M
    )
    return uncommented(found[1])


def port_table(memory: dict[str, int]) -> list[str]:
    """The parts of a memory behind the port."""
    lines = ["| from byte | to | size | an item | holds |", "|---|---|---:|---:|---|"]
    for holds, *expressions in PORT_ITEMS:
        numbers = [limits.value(expression, memory) for expression in expressions]
        first, size, item = [number for number in numbers if number is not None]
        lines.append(
            f"| `0x{first:07x}` | `0x{first + size - 1:07x}` | {size >> 20} MB | {item} bytes | "
            f"{holds} |"
        )
    return lines


def structs(text: str) -> list[str]:
    """Each struct of the memory: its comment and its fields, lowest bit first."""
    lines = []
    for comment, name, body in STRUCT.findall(text):
        order = re.search(r"HLS_FIELDS\(([^)]*)\)", body)
        if not order:
            continue
        said = uncommented(comment)
        lines += ["", f"### {name}", "", said, "", "| field | type | meaning |", "|---|---|---|"]
        for field in order[1].replace("\n", " ").split(","):
            found = re.search(
                rf"^  ([\w:<>, ]+?) {field.strip()}(?: = [^;]+)?;(?:\s*///<\s*(.*))?$", body, re.M
            )
            assert found, f"{name}.{field}"
            lines.append(f"| `{field.strip()}` | `{found[1]}` | {found[2] or ''} |")
    return lines


def page() -> str:
    """The whole page."""
    memory = source(MEMORY)
    cores = configurations()
    lines = [
        "# Registers and memory",
        "",
        "## Registers of a frame",
        "",
        f"{link(FRAME)} defines them. Each is one register of 32 bits, in this order; a core has "
        "no register for a part that it lacks, and the registers behind it move up.",
        "",
        *frame_table({name: source(generated(name, "vh")) for name in cores}),
        "",
        "An address is that of the register's lowest byte on the bus of the board, in each "
        "configuration whose Verilog is checked in; `-` if its core has no such register. The macros "
        "`DYNRT_CORE_FRAME_` of a core have the register's lowest bit in its input `frame_i`, eight "
        f"times the bytes from `REG_FRAME` on: {links_to(cores, 'vh')}.",
        "",
        "## Registers of the board",
        "",
        f"{link(BOARD)} defines them. `R`: the host reads it, `W`: it writes it. A value that begins "
        "with 0x is the byte address of a register, or what one holds; the others are numbers of "
        "bits and sizes. [Another board](../how-to/board.md#the-bus-of-the-host) describes the bus "
        "over which the host reaches them.",
        "",
        *board_table(source(BOARD)),
        "",
        comment_of(source(BOARD)).partition("\n\n")[2],
        "",
        "## Registers of the display",
        "",
        f"{link(SCAN)} defines them. The timing is that of a VGA display, in pixels and lines: "
        "what is seen ends at `hdisplay`, the pulse lasts from `hsync_start` to `hsync_end`, and "
        "the line ends at `htotal`; the same for lines.",
        "",
        *scan_table(source(SCAN)),
        "",
        "## Counters",
        "",
        "The host writes a number to `REG_COUNTER_ADDRESS` and reads the count from "
        f"`REG_COUNTER_DATA`. These are the numbers in `{THESIS}` ({link(generated(THESIS, 'json'))}). "
        f"{links_to(cores[1:], 'json')} has its in the list `counters`, and a build has those of any "
        "other configuration in `generated/CONFIG/dynrt_core.json`. `tokens` counts "
        "the tokens of a channel, `transactions` those that a unit has started, and `stalls` the "
        "clocks in which a unit had its tokens but an output had no space.",
        "",
        *counters_table(read_json(project.ROOT / generated(THESIS, "json"))),
        "",
        "## Memory",
        "",
        f"{link(MEMORY)} is the one description. The core unpacks with it and the host packs with "
        "it.",
        "",
        "### In six banks",
        "",
        comment_of(memory).partition("\n\n")[2],
        "",
        "### Behind a port",
        "",
        port_comment(memory),
        "",
        *port_table(limits.memory_constants()),
        "",
        "### Constants",
        "",
        *constants_table(memory),
        "",
        "## Formats",
        "",
        "Fields stand in their order from the lowest bit on. `R` is the float of the "
        "configuration.",
        *structs(memory),
    ]
    return "\n".join(lines) + "\n"
