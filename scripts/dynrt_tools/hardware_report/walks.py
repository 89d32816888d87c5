# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The frames of a walk as one: the frame whose figures are their means."""

from collections.abc import Sequence

from dynrt_tools.project import Json

BYTES = ("bytes_read", "pixel_bytes_written", "hit_bytes_written")


def mean(frames: Sequence[Json]) -> Json:
    """Clocks and bytes are means; a share of clocks or of lookups is one of those of all frames."""
    first, count = frames[0], len(frames)
    clocks = sum(frame["cycles"] for frame in frames)
    return {
        **{key: first[key] for key in ("packets", "cache_lines", "width", "height")},
        "cycles": round(clocks / count),
        "most_cycles": max(frame["cycles"] for frame in frames),
        "memory": {key: round(sum(f["memory"][key] for f in frames) / count) for key in BYTES},
        "units": {name: {"utilisation": _use(frames, name) / clocks} for name in first["units"]},
        "caches": {name: {"hit_rate": _hit_rate(frames, name)} for name in first["caches"]},
    }


def _use(frames: Sequence[Json], unit: str) -> float:
    """The clocks in which a unit begins a transaction."""
    return sum(float(f["units"][unit]["utilisation"] * f["cycles"]) for f in frames)


def _hit_rate(frames: Sequence[Json], cache: str) -> float:
    lookups, misses = (
        sum(f["caches"][cache][key] for f in frames) for key in ("lookups", "misses")
    )
    return 1 - float(misses / lookups) if lookups else 0.0
