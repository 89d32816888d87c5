# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A kept placement: what is known of one thing that was placed from several seeds, in a file that is
small enough for the repository.

It has the clocks, the ends of paths that limit them, the placer, and a hash of the Verilog, by which
a test knows whether the placement is of the present one. It also has the delay model that hlsc
scheduled the Verilog by, so that the schedule can be made again when the model has changed."""

import hashlib
import pathlib
import re
import statistics
from collections.abc import Sequence

from dynrt_tools import project
from dynrt_tools.hardware import (
    devices,
    model_file,
    place_record,
    placed_ends,
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
HAS = (
    *(
        "unit",
        "config",
        "device",
        "grade",
        "copies",
        "placer",
        "seeds",
        "mhz",
        "asked_mhz",
        "clock_ns",
    ),
    *("verilog", "model", "limits", "ends"),
)


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


def limiting(
    by_seed: Sequence[dict[placed_ends.End, Json]], periods: Sequence[float]
) -> list[Json]:
    """The ends that limit in one placement or in the median, the worst first."""
    least = LIMITS * statistics.median(periods)
    found = []
    for end in {end for ends in by_seed for end in ends}:
        times = [ends[end]["ns"] if end in ends else None for ends in by_seed]
        middle = median(times)
        in_one = any(ns and ns >= LIMITS * period for ns, period in zip(times, periods))
        if not in_one and middle < least:
            continue
        known = [ends[end] for ends in by_seed if end in ends]
        about = _nearest(known, middle)
        found.append(
            {
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


def median(times: Sequence[float | None]) -> float:
    """Of the placements; one in which the end is not slow enough to be listed counts as least."""
    return round(statistics.median(ns or 0.0 for ns in times), 3)


def of_row(row: Json, subject: placing.Subject, said: Json) -> Json:
    """What is kept of a row of scripts/place; `said` is what the whole call was for."""
    placements = row["placed"]
    model = row.get("delay") or devices.DEVICES[said["device"]]["delay"]
    by_seed = [placing.ends_of(p["run"]) for p in placements]
    return {
        "unit": row["unit"],
        **{key: said[key] for key in ("config", "device", "grade", "copies")},
        "placer": placements[0]["placer"],
        "tools": placing.tools(said["device"]),
        "clock_ns": scheduled_for(synthesis.needed(subject.module, list(subject.files))),
        "asked_mhz": placements[0]["asked_mhz"],
        "seeds": len(placements),
        "mhz": [p["mhz"] for p in placements],
        "units": {row["unit"]: place_record.placed(row)},
        "verilog": hash_of(subject.module, subject.files),
        "model": model_file.constants(project.ROOT / model),
        "limits": LIMITS,
        "ends": limiting(by_seed, [1000 / p["mhz"] for p in placements]),
    }


def write(path: pathlib.Path, kept: Json) -> None:
    project.write_rows(path, kept, "ends")


def read(path: pathlib.Path) -> Json:
    """A kept placement; throws project.Failed with the file and the correction."""
    try:
        kept: Json = read_json(path)
        missing = [key for key in HAS if key not in kept]
    except (OSError, ValueError, TypeError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        raise project.Failed(
            f"{path}: cannot be read ({why}); name a file that scripts/place --keep wrote"
        ) from error
    if missing:
        raise project.Failed(
            f"{path}: is no kept placement, as it has no '{missing[0]}'; name a file that "
            "scripts/place --keep wrote"
        )
    return kept


def file_of(name: str) -> pathlib.Path:
    """The kept placement of this name in docs/results/data."""
    path = DATA / f"{name}.json"
    return path if path.exists() else DATA / "placed" / path.name


def is_for_a_fit(path: pathlib.Path) -> bool:
    """Whether a file of the results is a kept placement, and no other record of scripts/place, of
    what hlsc predicts: no board, nor several cores. A seed or two say too little."""
    try:
        record = read_json(path)
    except ValueError as error:
        raise project.Failed(f"{path}: cannot be read ({error}); make it again") from error
    if "ends" not in record:
        return False
    kept = read(path)
    return bool(
        kept["unit"] != rtl_files.BOARD
        and kept["copies"] == 1
        and len(kept["mhz"]) >= SEEDS_OF_A_MEDIAN
    )


def period(kept: Json) -> float:
    """The median of its seeds, in ns."""
    return 1000 / float(statistics.median(kept["mhz"]))


def that_limit(kept: Json) -> list[Json]:
    """The ends that limit the median, which a delay model is judged by."""
    least = kept["limits"] * period(kept)
    return [end for end in kept["ends"] if end["median"] >= least]


def of_checked_in(kept: Json) -> bool:
    """Whether it is of the checked-in Verilog, so that no build is needed to compare."""
    return kept["unit"] in rtl_files.WHOLE and rtl_files.checked_in(kept["config"]) is not None


def is_current(kept: Json, folder: pathlib.Path | None = None) -> bool:
    """Whether the core whose generated Verilog is in the folder (default: that which is checked in)
    is still that which was placed."""
    files = rtl_files.core_files(folder or rtl_files.GENERATED.parent / kept["config"])
    files += rtl_files.board() if kept["unit"] == rtl_files.BOARD else []
    return bool(kept["verilog"] == hash_of(kept["unit"], files))


def is_earlier(kept: Json) -> bool:
    """Whether it is of checked-in Verilog that is another by now; of others only a build tells."""
    return of_checked_in(kept) and not is_current(kept)
