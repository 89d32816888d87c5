# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""docs/results/gates.md: the counts of scripts/gates with the thesis's tables 7.3 to 7.5."""

import pathlib
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
THESIS_GATES = 2807671
PAGE = pathlib.Path(__file__).with_name("gates_page.md")

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


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    for row in rows:
        cells = (f"{c:,}" if isinstance(c, int) else str(c) for c in row)
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


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
    """The page: gates_page.md with its tables and figures."""
    base = counts[BASE]
    fits, fit_rows = fitted(counts)
    here, memory = all_gates(base)
    cells: Counter[str] = sum((c.cells for c in base.values()), Counter())
    others = {name: total(base, [name]) for name in NOT_COUNTED}
    rule = (
        ("full adder", gate_rule.FULL_ADDER),
        ("D flip-flop", gate_rule.FLIP_FLOP),
        ("D flip-flop with clock enable", gate_rule.FLIP_FLOP_ENABLED),
        ("4-input LUT, worst case", gate_rule.LUT["LUT4"]),
        ("3-input LUT, worst case", gate_rule.LUT["LUT3"]),
        ("memory bit", gate_rule.MEMORY_BIT),
        ("18-bit multiplier", gate_rule.MULTIPLIER),
    )
    return PAGE.read_text(encoding="utf-8").format(
        rule=table(("unit", "gates"), rule),
        complexity=table(
            ("unit", "add", "multiply", "divide", "compare", "memory, kB"), complexity(base)
        ),
        packets=PACKETS,
        units=table(headings("packet"), units_table(counts, PACKET_UNITS, "packet", PACKETS)),
        notes="\n".join(f"- `{name}`: {note}." for name, note in NOTES.items()),
        left_out="; ".join(
            f"{name.strip('()')} {logic:,} gates and {amount:,} bits"
            for name, (logic, amount) in others.items()
        ),
        lines=LINES,
        caches=table(headings("line"), units_table(counts, CACHE_UNITS, "line", LINES)),
        there=THESIS_GATES,
        here=here,
        share=100 * here / THESIS_GATES,
        in_memories=4 * memory,
        cells=", ".join(f"{n:,} x {kind}" for kind, n in sorted(cells.items())),
        gates_formula=formula("C_RTC(P, CL)   ", fits[0]),
        bits_formula=formula("Bits_RTC(P, CL)", fits[1]),
        gates_of_thesis=formula("C_RTC(P, CL)   ", (487020, 56028, 996)),
        bits_of_thesis=formula("Bits_RTC(P, CL)", (0, 14007, 249)),
        fits=table(
            (*"P,CL,gates,fitted,off,bits,fitted,off".split(","), "gates, thesis", "bits, thesis"),
            fit_rows,
        ),
        memories=table(("unit", "memory", "bits", "all bits"), memories_table(counts)),
    )


def headings(of: str) -> tuple[str, ...]:
    """Of tables 7.4 and 7.5."""
    return (
        *("unit", "logic gates, thesis", "ours", f"bits per {of}, thesis", "ours"),
        *("memory bits, thesis", "ours"),
    )
