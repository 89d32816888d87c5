# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/place prints of a unit, the core or the board: a row, and its worst paths."""

import statistics

from dynrt_tools.project import Json

HEAD = (
    "unit",
    "stages",
    "predicted ns",
    "cells",
    "MHz, median",
    "range",
    "placed ns",
    "of predicted",
)


def line(cells: tuple[object, ...]) -> str:
    return "".join(f"{c:<19}" if i == 0 else f"{c:>14}" for i, c in enumerate(cells)).rstrip()


def middle(placed: list[Json]) -> Json:
    """The placement with the median clock, the slower of two."""
    clock = statistics.median_low(p["mhz"] for p in placed)
    return next(p for p in placed if p["mhz"] == clock)


def cells_of(row: Json) -> tuple[object, ...]:
    """What stands in the columns of a row."""
    placed, predicted = row.get("placed"), row.get("longest_path_ns")
    stated = (row["unit"], row.get("stages", ""), f"{predicted:.2f}" if predicted else "")
    if not placed:
        note = row.get("note") or "no seed was placed"
        if "logic_ns" in row:
            note += f"; cells alone {row['logic_ns']:.2f} ns on 7-series"
        return (*stated, "", "", "", "", f"  {note}")
    clocks = sorted(p["mhz"] for p in placed)
    median = statistics.median(clocks)
    digits = 1 if median < 100 else 0
    return (
        *stated,
        middle(placed)["cells"],
        f"{median:.{digits}f}",
        f"{clocks[0]:.{digits}f} to {clocks[-1]:.{digits}f}",
        f"{1000 / median:.2f}",
        f"{100 * 1000 / median / predicted:.0f} %" if predicted else "",
    )


def _end(end: Json) -> str:
    source = f" ({end['source']})" if end["source"] else ""
    return f"{end['unit']}: {end['signal']}{source}"


def paths_of(row: Json, most: int) -> list[str]:
    """A line for each of the worst paths of the median placement."""
    if not row.get("placed"):
        return []
    return [
        f"  {p['ns']:6.2f} ns = {p['logic_ns']:.2f} logic + {p['wire_ns']:.2f} wires, "
        f"{p['levels']} levels, {p['endpoints']} ends; from {_end(p['from'])} "
        f"to {_end(p['to'])}, pin {p['to']['pin']}"
        for p in middle(row["placed"])["paths"][:most]
    ]
