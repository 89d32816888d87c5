# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page that `dynrt specialise` prints: the parts left out with their reasons, the savings, and
the curves."""

import textwrap
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from dynrt_tools.project import Json
from dynrt_tools.specialise.costs import COSTS
from dynrt_tools.specialise.curve import by_percent

WIDTH = 112


def aligned(rows: Sequence[Sequence[str]], right: Iterable[int] = ()) -> Iterator[str]:
    """Rows of text under one another; columns `right` end flush."""
    widths = [max(len(row[i]) for row in rows if i < len(row)) for i in range(len(rows[0]))]
    for row in rows:
        cells = (
            cell.rjust(w) if i in right else cell.ljust(w)
            for i, (cell, w) in enumerate(zip(row, widths))
        )
        yield "  " + "  ".join(cells).rstrip()


def value(of: Any) -> str:
    if isinstance(of, list):
        return ", ".join(of)
    if isinstance(of, bool):
        return "yes" if of else "no"
    return str(of)


def keys_table(
    special: str, general: str, decided: Json, base: Json, changed: list[str]
) -> Iterator[str]:
    """The keys that differ, each with its reason beside it, wrapped."""
    rows = [("key", general, special, "because")]
    first = [(name, value(base[name]), value(decided[name]["value"])) for name in changed]
    left = 2 * 4 + sum(max(len(row[i]) for row in [*first, rows[0]]) for i in range(3))
    for name, before, now in first:
        because = textwrap.wrap(decided[name]["reason"], max(40, WIDTH - left))
        rows.append((name, before, now, because[0]))
        rows += [("", "", "", line) for line in because[1:]]
    yield from aligned(rows)


def kept_text(general: str, decided: Json, changed: list[str]) -> Iterator[str]:
    kept = ", ".join(
        f"{name} {value(one['value'])}" for name, one in decided.items() if name not in changed
    )
    yield from textwrap.wrap(
        f"as in {general}: {kept}", WIDTH, initial_indent="  ", subsequent_indent="  "
    )


def number(of: float) -> str:
    return f"{of:,.1f}" if isinstance(of, float) and of % 1 else f"{of:,.0f}"


def number_or_dash(of: float | None) -> str:
    return "-" if of is None else f"{of:.2f}"


def costs_table(special: str, general: str, costs: Json) -> Iterator[str]:
    rows = [("takes", general, special, "less by")]
    for name, about in COSTS.items():
        if name in costs["general"] and name in costs["special"]:
            before, now = costs["general"][name], costs["special"][name]
            less = by_percent(100 * (1 - now / before), "more") if before else "-"
            rows.append((about, number(before), number(now), less))
    yield from aligned(rows, (1, 2, 3))


def curve_table(curves: dict[str, dict[int, int]]) -> Iterator[str]:
    for name, curve in curves.items():
        rows = [
            (name, *(f"{n}" for n in curve)),
            ("clocks", *(f"{clocks:,}" for clocks in curve.values())),
            (
                "more by",
                *(
                    by_percent(100 * (clocks / max(1, curve[max(curve)]) - 1), "fewer")
                    for clocks in curve.values()
                ),
            ),
        ]
        yield from aligned(rows, range(1, len(rows[0])))


def layout_table(layouts: dict[int, Json]) -> Iterator[str]:
    """What was measured of the nodes of a line."""
    rows = [
        ("line_nodes", *map(str, layouts)),
        ("clocks", *(f"{costs['clocks']:,}" for costs in layouts.values())),
        ("bytes a ray", *(number_or_dash(costs["bytes_per_ray"]) for costs in layouts.values())),
    ]
    yield from aligned(rows, range(1, len(rows[0])))


def page(scene: str, general: str, base: Json, result: Json) -> str:
    """All of it, as one text."""
    decided, changed = result["configuration"], result["left_out"]
    lines = [
        f"scene       {scene}",
        f"core        from {general}, without the parts that the scene does not need",
        "",
        *keys_table("here", general, decided, base, changed),
        "",
        *kept_text(general, decided, changed),
        "",
        *costs_table("here", general, result["costs"]),
        "",
    ]
    if result["layouts"]:
        lines += [*layout_table(result["layouts"]), ""]
    for curve in ("packets", "lines"):
        lines += [*curve_table({curve: result["curves"][curve]}), ""]
    return "\n".join(lines)
