# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A record of what scripts/place has placed, small enough for the repository: clocks and cells of each
row, the ends of paths that limit it, and what decides the placement.

docs/results/devices.md shows its figures, scripts/fit-delays fits delay models to its ends, and the
clock of a core goes from it to hls/configs/clocks.json. It has a hash of the Verilog, and the delay
model that hlsc scheduled the Verilog by, so that the schedule can be made again when the model has
changed."""

import hashlib
import pathlib
import re
import statistics
from collections.abc import Iterable, Sequence

from dynrt_tools import project
from dynrt_tools.hardware import (
    devices,
    model_file,
    place_row,
    place_table,
    placed_clocks,
    placed_ends,
    placers,
    placing,
    rtl_files,
    synthesis,
)
from dynrt_tools.project import Json, read_json

DATA = project.ROOT / "docs" / "results" / "data"
# An end limits if its path takes this share of the period.
LIMITS = 0.85
SEEDS_OF_A_MEDIAN = 3  # at least; the clocks of single seeds lie up to 12 % apart
SCHEDULED = re.compile(r"^// Scheduled for ([\d.]+) ns on", re.MULTILINE)
# As hlsc refuses a unit for a shorter one (hls/compiler/schedule/timing_messages.h).
LEAST = re.compile(r"give --clock-ns ([\d.]+), the least that this unit reaches")


def hash_of(module: str, files: Sequence[pathlib.Path]) -> str:
    """A hash of the Verilog that a module needs and of the headers beside it, without comments."""
    digest = hashlib.sha256()
    needed = synthesis.needed(module, list(files))
    for path in sorted([*needed, *synthesis.headers_beside(needed)], key=lambda p: p.name):
        digest.update(path.name.encode() + b"\0" + synthesis.meaning(path).encode() + b"\0")
    return digest.hexdigest()


def scheduled_for(files: Sequence[pathlib.Path]) -> float:
    """The period that hlsc scheduled the units among the files for, in ns: the longest."""
    clocks = [m[1] for f in files if (m := SCHEDULED.search(f.read_text(encoding="utf-8")))]
    if not clocks:
        raise project.Failed("no unit is among the files; their periods would be in their heads")
    return max(map(float, clocks))


def placed(row: place_row.Row, device: str) -> Json:
    """The figures of a row that was placed."""
    assert row.subject is not None  # or there would be no placement
    mhz, predicted = [p["mhz"] for p in row.data["placed"]], row.data.get("longest_path_ns")
    period, middle = 1000 / statistics.median(mhz), place_table.middle(row.data["placed"])
    files = synthesis.needed(row.subject.module, list(row.subject.files))
    return {
        "stages": row.data.get("stages"),
        "predicted, ns": predicted,
        "cells": middle["cells"],
        "ends too slow": middle["too_slow"],
        "MHz, median": round(statistics.median(mhz)),
        "range low": round(min(mhz)),
        "range high": round(max(mhz)),
        "placed, ns": round(period, 2),
        "of predicted": round(100 * period / predicted) if predicted else None,
        "mhz": mhz,
        "clock_ns": scheduled_for(files),
        "delay": row.data.get("delay") or devices.DEVICES[device]["delay"],
        "verilog": hash_of(row.subject.module, files),
    }


def limiting(
    row: str, by_seed: Sequence[dict[placed_ends.End, Json]], periods: Sequence[float]
) -> list[Json]:
    """The ends that limit a row in one placement or in the median, the worst first."""
    least = LIMITS * statistics.median(periods)
    found = []
    for end in {end for ends in by_seed for end in ends}:
        times = [ends[end]["ns"] if end in ends else None for ends in by_seed]
        # An end that is not slow enough to be listed in a placement counts as least there.
        middle = round(statistics.median(ns or 0.0 for ns in times), 3)
        in_one = any(ns and ns >= LIMITS * period for ns, period in zip(times, periods))
        if not in_one and middle < least:
            continue
        known = [ends[end] for ends in by_seed if end in ends]
        about = _nearest(known, middle)
        found.append(
            {
                "row": row,
                "unit": end.unit,
                "signal": end.signal,
                "port": end.port,
                "source": about["source"],
                "from": about["from"],
                "ns": times,
                "median": middle,
            }
        )
    return sorted(found, key=lambda e: (-e["median"], e["unit"], e["signal"], e["port"]))


def _nearest(ends: Sequence[Json], ns: float) -> Json:
    """The end whose time is nearest."""
    return min(ends, key=lambda end: abs(float(end["ns"]) - ns))


def ends_of(row: place_row.Row) -> list[Json]:
    """Of a row whose every seed was placed."""
    placements = row.data["placed"]
    by_seed = [placing.ends_of(p["run"]) for p in placements]
    return limiting(row.name, by_seed, [1000 / p["mhz"] for p in placements])


def missing(row: Json, device: str) -> Json:
    """Why a row was not placed, what it takes of the device, and the clock that hlsc asks for."""
    least = LEAST.search(place_row.reason(row))
    return {
        "reason": place_row.reason(row),
        "takes": row.get("resources"),
        "there are": devices.DEVICES[device]["has"],
        "least clock, ns": float(least[1]) if least else None,
    }


def of_rows(said: Json, rows: Sequence[place_row.Row], seeds: Sequence[int]) -> Json:
    """The record of a call; `said` is what it was for."""
    device = said["device"]
    there = [row for row in rows if row.data.get("placed")]
    found = {row.name: placed(row, device) for row in there}
    parts = [u["of predicted"] for u in found.values() if u["of predicted"]]
    units = [row.data for row in rows if row.name not in rtl_files.WHOLE]
    lowered = [row["stages"] for row in units if "stages" in row]
    models = dict.fromkeys(row["delay"] for row in found.values())
    return {
        **said,
        "date": project.today(),
        "placer": there[0].data["placed"][0]["placer"] if there else None,
        "tools": placing.tools(device) if there else None,
        "seeds": len(seeds),
        "seed": list(seeds),
        "units": found,
        "of predicted": {
            "mean": round(statistics.mean(parts)) if parts else None,
            "median": round(statistics.median(parts)) if parts else None,
        },
        "not placed": {
            row.name: missing(row.data, device) for row in rows if not row.data.get("placed")
        },
        "lowered": {"units": len(lowered), "of": len(units), "stages": sum(lowered)},
        "longest path by Yosys, ns": max(
            (row.data["logic_ns"] for row in rows if "logic_ns" in row.data), default=None
        ),
        "limits": LIMITS,
        "models": {model: model_file.constants(project.ROOT / model) for model in models},
        "ends": [end for row in there if not row.failures for end in ends_of(row)],
    }


def clock_of(record: Json) -> placed_clocks.PlacedClock:
    """The clock of the core of a record."""
    core, device = record["units"][rtl_files.CORE], record["device"]
    digits = placed_clocks.DIGITS
    return placed_clocks.PlacedClock(
        configuration=record["config"],
        device=device,
        part=devices.DEVICES[device]["name"],
        grade=record["grade"],
        mhz=round(statistics.median(core["mhz"]), digits),
        lowest_mhz=round(min(core["mhz"]), digits),
        highest_mhz=round(max(core["mhz"]), digits),
        seeds=record["seeds"],
        placer=f"{placers.PLACERS[device]['program']} {record['placer']}",
        date=record["date"],
        verilog=core["verilog"],
    )


def write(path: pathlib.Path, record: Json) -> None:
    project.write_rows(path, record, "ends")


def read(path: pathlib.Path) -> Json:
    """A record; throws project.Failed with the file and the correction."""
    try:
        record: Json = read_json(path)
        record["units"], record["models"], record["ends"]  # pylint: disable=pointless-statement
    except (OSError, ValueError, TypeError, KeyError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        raise project.Failed(
            f"{path}: is no record of placements ({why}); name a file that scripts/place --record "
            "wrote"
        ) from error
    return record


def for_a_fit(record: Json) -> Iterable[str]:
    """The rows of a record that hlsc predicts, no board, nor several cores, and that say enough: a seed
    or two do not, nor does a placer that reached its clock, as it leaves slack then."""
    for name in dict.fromkeys(end["row"] for end in record["ends"]):
        mhz = record["units"][name]["mhz"]
        says_enough = len(mhz) >= SEEDS_OF_A_MEDIAN and statistics.median(mhz) < record["asked_mhz"]
        if name != rtl_files.BOARD and record["copies"] == 1 and says_enough:
            yield name
