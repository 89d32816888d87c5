# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""docs/results/gates.md: the counts of scripts/gates with the thesis's tables 7.3 to 7.5."""

# pylint: disable=line-too-long  # the lines of the page
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from dynrt_tools.hardware import gate_rule
from dynrt_tools.hardware.gate_units import (
    CACHE_UNITS,
    COMPLEXITY,
    COMPLEXITY_ROWS,
    LINES,
    NOTES,
    OPERATORS,
    OTHER_UNITS,
    PORT_UNITS,
    PACKET_UNITS,
    PACKETS,
    Unit,
    bits,
    gates,
    owner,
    plain_name,
)

TABULATED = (*PACKET_UNITS, *CACHE_UNITS)
NOT_COUNTED = ("(ray generation)", "(shading)", "(counters)")
BASE = (PACKETS, LINES)

CoreCounts = dict[str, gate_rule.Count]  # by instance
Point = tuple[int, int]  # packets and lines
Counts = dict[Point, CoreCounts]
Place = tuple[str, str]  # a memory: its instance and its name
Memories = list[tuple[str, gate_rule.Memory]]


@dataclass
class Row:
    """The gates and bits of a row of the tables."""

    logic: int
    memories: Memories


def by_row(counts: CoreCounts) -> dict[str, Row]:
    """Logic gates and memories of every row, from those of the instances and of the join."""
    names = [u.name for u in (*TABULATED, *OTHER_UNITS)] + ["(counters)"]
    rows = {name: Row(0, []) for name in names}
    of_instance = {name: u.name for u in (*TABULATED, *OTHER_UNITS) for name in u.modules}
    of_instance["counters"] = "(counters)"
    for instance, count in counts.items():
        unit = plain_name(instance)
        for memory in count.memories:
            name = owner(memory.name) if instance == "join" else of_instance.get(unit)
            rows[name or "DynamicRTC"].memories.append((instance, memory))
        rows[of_instance.get(unit, "DynamicRTC")].logic += count.logic
    return rows


def row_bits(row: Row) -> int:
    return sum(memory.bits for _, memory in row.memories)


def total(counts: CoreCounts, names: Iterable[str]) -> tuple[int, int]:
    rows = by_row(counts)
    return (sum(rows[n].logic for n in names), sum(row_bits(rows[n]) for n in names))


def all_gates(counts: CoreCounts) -> tuple[int, int]:
    """What the thesis's C_RTC and Bits_RTC are of: all that its tables have, and the port of a memory
    that has one, with its second level of cache."""
    logic, memory = total(counts, [u.name for u in (*TABULATED, *PORT_UNITS)])
    return logic + gate_rule.MEMORY_BIT * memory, memory


def summary(counts: CoreCounts) -> dict[str, int]:
    """The figures of the document that --check compares: logic gates and memory bits by row."""
    rows = by_row(counts)
    return {
        f"{u.name} {what}": figure
        for u in TABULATED
        for what, figure in (("gates", rows[u.name].logic), ("bits", row_bits(rows[u.name])))
    }


ROW = re.compile(
    r"^\| `([^`]+)` \| [^|]* \| ([\d,]+) \| [^|]* \| [^|]* \| [^|]* \| ([\d,]+) \|", re.MULTILINE
)


def figures(text: str) -> dict[str, int]:
    """The figures of a document, as summary() gives them."""
    found = {}
    for name, logic, memory in ROW.findall(text):
        found[f"{name} gates"] = int(logic.replace(",", ""))
        found[f"{name} bits"] = int(memory.replace(",", ""))
    return found


def kinds(counts: Counts) -> dict[Place, str]:
    """The number that the rows of every memory follow: of packets, of lines, or none."""

    def rows_of(point: Point) -> dict[Place, int]:
        return {
            (instance, m.name): m.rows
            for instance, count in counts[point].items()
            for m in count.memories
        }

    base, found = rows_of(BASE), {}
    for point, axis, kind in (((64, 512), 0, "packet"), ((32, 64), 1, "line")):
        if point in counts:
            other = rows_of(point)
            for key, rows in base.items():
                if other.get(key, rows) * BASE[axis] == rows * point[axis] and rows != 1:
                    found[key] = kind
    return found


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> Iterator[str]:
    yield "| " + " | ".join(head) + " |"
    yield "|---|" + "---:|" * (len(head) - 1)
    for row in rows:
        yield "| " + " | ".join(f"{c:,}" if isinstance(c, int) else str(c) for c in row) + " |"


def per(memories: Memories, kind: str, following: dict[Place, str], number: int) -> int:
    return sum(m.bits for i, m in memories if following.get((i, m.name)) == kind) // number


def units_table(
    counts: Counts, units: Sequence[Unit], kind: str, number: int
) -> Iterator[Sequence[object]]:
    following = kinds(counts)
    rows = by_row(counts[BASE])
    for unit in units:
        row = rows[unit.name]
        each = per(row.memories, kind, following, number)
        ours = row_bits(rows[unit.name])
        yield (f"`{unit.name}`", unit.logic, row.logic, unit.bits, each, unit.bits * number, ours)
    sums = [
        sum(u.logic for u in units),
        sum(rows[u.name].logic for u in units),
        sum(u.bits for u in units),
        sum(per(rows[u.name].memories, kind, following, number) for u in units),
        sum(u.bits for u in units) * number,
        sum(row_bits(rows[u.name]) for u in units),
    ]
    yield ("**all**", *sums)


def complexity(counts: CoreCounts) -> Iterator[Sequence[object]]:
    rows = by_row(counts)
    for name, (add, mul, div, comp, memory) in COMPLEXITY.items():
        ours = sum(row_bits(rows[n]) for n in COMPLEXITY_ROWS[name]) / 8 / 1024
        yield (
            name,
            *(f"{a} / {b}" for a, b in zip((add, mul, div, comp), OPERATORS[name])),
            f"{memory} / {ours:.1f}",
        )
    sums = [
        f"{sum(c[i] for c in COMPLEXITY.values())} / {sum(o[i] for o in OPERATORS.values())}"
        for i in range(4)
    ]
    ours = sum(row_bits(rows[n]) for names in COMPLEXITY_ROWS.values() for n in names) / 8 / 1024
    yield ("**all**", *sums, f"{sum(c[4] for c in COMPLEXITY.values()):.1f} / {ours:.1f}")


def formula(name: str, terms: Sequence[float]) -> str:
    first, packets, lines = (round(t) for t in terms)
    return f"{name} = {first:,} + {packets:,} P + {lines:,} CL"


def fitted(counts: Counts) -> tuple[list[tuple[float, ...]], Iterator[Sequence[object]]]:
    points = list(counts)
    found = {point: all_gates(counts[point]) for point in points}
    fits = [gate_rule.fit(points, [found[p][i] for p in points]) for i in (0, 1)]

    def rows() -> Iterator[Sequence[object]]:
        for packets, lines in sorted(points):
            cells: list[object] = [packets, lines]
            for i in (0, 1):
                said = fits[i][0] + fits[i][1] * packets + fits[i][2] * lines
                got = found[packets, lines][i]
                cells += [got, round(said), f"{100 * (said - got) / got:+.1f} %"]
            yield (*cells, gates(packets, lines), bits(packets, lines))

    return fits, rows()


def memories_table(counts: Counts) -> Iterator[Sequence[object]]:
    """Every RAM and register file; FIFOs and delays of a row in one line each."""
    following = kinds(counts)
    for name, row in by_row(counts[BASE]).items():
        grouped: dict[tuple[str, str], list[int]] = {}
        single = []
        for instance, memory in row.memories:
            kind = following.get((instance, memory.name), "")
            sort = next(
                (
                    s
                    for s, ending in (("FIFOs", ("_fifo", "_queue")), ("delays", None))
                    if (
                        memory.name.endswith(ending) if ending else memory.name.startswith("delay_")
                    )
                ),
                None,
            )
            if sort:
                group = grouped.setdefault((sort, kind), [0, 0])
                group[0] += 1
                group[1] += memory.bits
            else:
                single.append((memory, kind))
        for memory, kind in single:
            number = {"packet": PACKETS, "line": LINES}.get(kind)
            each = (
                f"{memory.rows / number:g} x {memory.width} x {memory.ports} = "
                f"{memory.bits / number:g} a {kind}"
                if number
                else f"{memory.rows} x {memory.width} x {memory.ports}, whatever P and CL"
            )
            yield (f"`{name}`", f"`{memory.name}`", each, memory.bits)
        for (sort, kind), (number, amount) in grouped.items():
            rows = {"packet": PACKETS, "line": LINES}.get(kind)
            yield (
                f"`{name}`",
                f"{number} {sort if number > 1 else sort[:-1]}",
                f"{amount / rows:g} a {kind}" if rows else "whatever P and CL",
                amount,
            )


def document(counts: Counts) -> str:
    base = counts[BASE]
    fits, fit_rows = fitted(counts)
    here, memory = all_gates(base)
    there = 2807671
    others = {n: total(base, [n]) for n in NOT_COUNTED}
    cells: Counter[str] = sum((c.cells for c in base.values()), Counter())
    head = (
        "unit",
        "logic gates, thesis",
        "ours",
        "bits per packet, thesis",
        "ours",
        "memory bits, thesis",
        "ours",
    )
    lines = [
        "# Gates by the thesis's rule",
        "",
        "Written by `scripts/gates`; a test holds it against the checked-in Verilog. Thesis: Sven "
        "Woop,",
        '"A Ray Tracing Hardware Architecture for Dynamic Scenes", 2004, chapter 7.',
        "",
        "## The rule (table 7.2)",
        "",
        *table(
            ("unit", "gates"),
            (
                ("full adder", gate_rule.FULL_ADDER),
                ("D flip-flop", gate_rule.FLIP_FLOP),
                ("D flip-flop with clock enable", gate_rule.FLIP_FLOP_ENABLED),
                ("4-input LUT, worst case", gate_rule.LUT["LUT4"]),
                ("3-input LUT, worst case", gate_rule.LUT["LUT3"]),
                ("memory bit", gate_rule.MEMORY_BIT),
                ("18-bit multiplier", gate_rule.MULTIPLIER),
            ),
        ),
        "",
        *[f"{line}" for line in RULE],
        "",
        "## Floating-point units of one pipeline (table 7.3)",
        "",
        "Each entry is thesis / ours. The last column has kB, with a dual-port bit as two bits.",
        "",
        *table(("unit", "add", "multiply", "divide", "compare", "memory, kB"), complexity(base)),
        "",
        f"## Unit by unit, {PACKETS} packets (table 7.4)",
        "",
        *table(head, units_table(counts, PACKET_UNITS, "packet", PACKETS)),
        "",
        *(f"- `{name}`: {note}." for name, note in NOTES.items()),
        "- Our bits per packet count the memories whose rows grow with the packets. Memory bits "
        "count all memories.",
        "- The thesis's table and our sums leave these out: "
        + "; ".join(
            f"{n.strip('()')} {logic:,} gates and {amount:,} bits"
            for n, (logic, amount) in others.items()
        )
        + ".",
        "",
        f"## Memory interface and caches, {LINES} lines (table 7.5)",
        "",
        *table(
            [h.replace("packet", "line") for h in head],
            units_table(counts, CACHE_UNITS, "line", LINES),
        ),
        "",
        f"Total gates: thesis {there:,}, ours {here:,} "
        f"({100 * here / there:.0f} %), of them {4 * memory:,} in memories.",
        "",
        "The logic of the whole core consists of "
        + ", ".join(f"{n:,} x {kind}" for kind, n in sorted(cells.items()))
        + ".",
        "",
        "## By packets and lines",
        "",
        "    thesis   " + formula("C_RTC(P, CL)   ", (487020, 56028, 996)),
        "    ours     " + formula("C_RTC(P, CL)   ", fits[0]),
        "    thesis   " + formula("Bits_RTC(P, CL)", (0, 14007, 249)),
        "    ours     " + formula("Bits_RTC(P, CL)", fits[1]),
        "",
        "Our formulas are a fit by least squares over the cores of this table, each lowered and "
        "counted. The",
        "thesis's C_RTC leaves out the 17,803 logic gates of its table 7.5.",
        "",
        *table(
            (
                "P",
                "CL",
                "gates",
                "fitted",
                "off",
                "bits",
                "fitted",
                "off",
                "gates, thesis",
                "bits, thesis",
            ),
            fit_rows,
        ),
        "",
        *FIT,
        "",
        "## The bits of each memory",
        "",
        "The column *bits* has the rows of a packet (or a line), times the bits of a row, times the ports. It is for 32 packets and 512 lines.",
        "",
        *table(("unit", "memory", "bits", "all bits"), memories_table(counts)),
        "",
        *WHY,
        "",
    ]
    return "\n".join(lines)


RULE = (
    "The table leaves some things open. We count them in this way: a place of a carry chain is a full adder,",
    "together with a LUT of one or two inputs that feeds it alone. A LUT of two inputs counts as a LUT of three,",
    "an inverter as one gate. A flip-flop with a synchronous set or reset counts as one with an enable, and a",
    "dual-port bit as two memory bits. As in the thesis, gates that address memories do not count. The netlist is",
    "Yosys's for Virtex-II. Each unit has the FIFO depths of the core, and memories count as the source has them.",
)
FIT = (
    "The fit is not exact, because every token holds a packet number, so widths grow with log2 P, and because",
    "rows of RAM are powers of two.",
)
WHY = (
    "Why a packet takes so many bits:",
    "",
    "- The far stack of a ray has 64 rows a packet: 32 for each level, of which 31 are used, so that the address",
    "  is level, packet and depth, without an adder. A second port doubles it. The thesis's 2,352 bits are 24 x",
    "  (62 + 2 x 18): a single-port stack and 18 dual-port words.",
    "- Most FIFOs on a loop of packets hold all packets, so that no loop can deadlock and no pipeline needs an",
    "  enable. The thesis's tables have no FIFOs.",
    "- The core keeps rays twice: by axis for each slice, and as vectors for `send_packet`. It keeps a packet's",
    "  matrix once; the thesis perhaps keeps it for both levels (1,152 bits are 12 x 24, two levels, two ports).",
    "- A line of a cache is its data, its address and, in ours, a bit that says whether it is valid: one bit more",
    "  than in the thesis. Our lines are dual-port, since lookups go on while lines arrive. The thesis counts its",
    "  lines once.",
)
