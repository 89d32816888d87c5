# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of scripts/place that docs/results/devices.md shows, out of its whole data."""

import re
import statistics

from dynrt_tools.hardware import devices, place_table, rtl_files
from dynrt_tools.project import Json

# As hlsc refuses a unit for a shorter one (hls/compiler/schedule/timing_messages.h).
LEAST = re.compile(r"give --clock-ns ([\d.]+), the least that this unit reaches")


def placed(row: Json) -> Json:
    """The columns of a row that was placed."""
    clocks = sorted(p["mhz"] for p in row["placed"])
    period, predicted = 1000 / statistics.median(clocks), row.get("longest_path_ns")
    middle = place_table.middle(row["placed"])
    return {
        "stages": row.get("stages"),
        "predicted, ns": predicted,
        "cells": middle["cells"],
        "ends too slow": middle["too_slow"],
        "MHz, median": round(statistics.median(clocks)),
        "range low": round(clocks[0]),
        "range high": round(clocks[-1]),
        "placed, ns": round(period, 2),
        "of predicted": round(100 * period / predicted) if predicted else None,
    }


def reason(row: Json) -> str:
    """Why a row has no placement."""
    return str(row.get("note") or "no seed was placed")


def missing(row: Json, device: str) -> Json:
    """Why a row was not placed, what it takes of the device, and the clock that hlsc asks for."""
    least = LEAST.search(reason(row))
    return {
        "reason": reason(row),
        "takes": row.get("resources"),
        "there are": devices.DEVICES[device]["has"],
        "least clock, ns": float(least[1]) if least else None,
    }


def summary(data: Json, seeds: int) -> Json:
    """What the page needs of the data that --json writes."""
    rows = data["units"]
    found = {row["unit"]: placed(row) for row in rows if row.get("placed")}
    parts = [u["of predicted"] for u in found.values() if u["of predicted"]]
    units = [row for row in rows if row["unit"] not in rtl_files.WHOLE]
    lowered = [row for row in units if "stages" in row]
    cells = [row["logic_ns"] for row in rows if "logic_ns" in row]
    device = data["device"]
    return {
        **{key: data[key] for key in ("config", "device", "grade", "clock_ns", "complete")},
        "placer": next((p["placer"] for row in rows for p in row.get("placed", ())), None),
        "seeds": seeds,
        "units": found,
        "of predicted": {
            "mean": round(statistics.mean(parts)) if parts else None,
            "median": round(statistics.median(parts)) if parts else None,
        },
        "not placed": {r["unit"]: missing(r, device) for r in rows if not r.get("placed")},
        "lowered": {
            "units": len(lowered),
            "of": len(units),
            "stages": sum(row["stages"] for row in lowered),
        },
        "longest path by Yosys, ns": max(cells, default=None),
    }
