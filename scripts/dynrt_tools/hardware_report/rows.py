# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of a walk's mean frame, by the names that tables and curves have them under."""

from dynrt_tools.bench.run import rays, read_bytes, written_bytes
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.hardware_report import figures, indices
from dynrt_tools.hardware_report.figure import Point
from dynrt_tools.project import Json

# The thesis's four units, and which of ours does its one transaction a clock.
UNITS = {
    "traversal": "node_lookup",
    "list": "list_lookup",
    "transformation": "transformation",
    "intersection": "intersection",
}
PLACED = "frames per second, placed"
SLOWEST = f"slowest frame, per second at {placed_clocks.THESIS_MHZ} MHz"
# The columns of the table, in its order.
TABLE = (
    "packets",
    "lines",
    "clocks",
    PLACED,
    figures.RATE,
    SLOWEST,
    "thesis's frames per second",
    "rays per clock",
    "U_AU",
    "QHW",
    "QGHW",
    "bytes read per ray",
    "bytes written per ray",
    *(f"{cache} cache hits" for cache in figures.CACHES.values()),
    "C_AU + C_IM",
    "thesis's C_RTC",
)


def figures_of(frame: Json, gates: Json | None) -> Json:
    """Uses, hit rates and U_AU in percent; indices where the gates are known."""
    clocks, count = frame["cycles"], rays(frame)
    units = frame["units"]
    return {
        "clocks": clocks,
        figures.RATE: placed_clocks.frames_per_second(clocks, placed_clocks.THESIS_MHZ),
        SLOWEST: placed_clocks.frames_per_second(frame["most_cycles"], placed_clocks.THESIS_MHZ),
        "rays per clock": count / clocks,
        **{f"{n} use": 100 * units[u]["utilisation"] for n, u in UNITS.items() if u in units},
        **{f"{n} cache hits": 100 * c["hit_rate"] for n, c in frame["caches"].items()},
        "bytes read per ray": read_bytes(frame) / count,
        "bytes written per ray": written_bytes(frame) / count,
        **(indices.indices(gates, frame) if gates else {}),
    }


def row(scene: str, configuration: str, flags: Point, figures_: Json) -> Json:
    return {"scene": scene, "configuration": configuration, "flags": dict(flags), **figures_}
