# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The thesis's quality indices of a core (7.2.1, 7.2.2), and how this project reads them."""

from dynrt_tools.hardware.gate_units import gates as thesis_gates
from dynrt_tools.project import Json

READING = (
    "QHW = U_AU C_AU / (C_AU + C_IM) · 100 and QGHW = rays per clock / (C_AU + C_IM) · 1,000,000 "
    "(7.2.1, 7.2.2).",
    "C_AU: the logic gates of Tables 7.4 and 7.5. C_IM: the gates of their memories. Both by the "
    "thesis's rule, so that their sum is C_RTC(P, CL). Ray generation, shading and counters are left "
    "out as in the thesis's tables; units that this project added are counted, among them a memory's "
    "port and the second level of cache before it.",
    "U_AU: the mean use of the arithmetic units, each weighted with its logic gates. The thesis does "
    "not name the units. Here they are those with floating-point operators (Table 7.3): slices, "
    "collection of hits, transformation and intersection, and of our own the units for reciprocals, "
    "camera rays, distances of planes and boxes; not the subtractions that matrix_store makes in "
    "cores with a watertight test for packets from one origin. The use of a unit is the share of "
    "clocks in which it begins a transaction.",
    "A unit that several pipelines have counts with the gates of all and with their mean use. The "
    "thesis's C_RTC then is that of as many of its cores.",
    "Between the cores that were counted, C_AU and C_IM are a fixed part, a part per packet and a part "
    "per line.",
)


def costs(gates: Json, packets: int, lines: int) -> tuple[float, float] | None:
    """C_AU and C_IM with these packets and lines; None if the cores that were counted do not tell."""
    if (packets, lines) == (gates["packets"], gates["lines"]):
        return gates["logic"], gates["memory"]
    if not (split := gates["split"]):
        return None
    logic, memory = (
        split["fixed"][cost] + split["packet"][cost] * packets + split["line"][cost] * lines
        for cost in ("logic", "memory")
    )
    return logic, memory


def mean_use(arithmetic: dict[str, int], units: Json) -> float:
    """U_AU, in units of 1."""
    working = sum(n * float(units[name]["utilisation"]) for name, n in arithmetic.items())
    return working / sum(arithmetic.values())


def indices(gates: Json, frame: Json) -> Json:
    """QHW and QGHW of a frame; empty where the gates are not known."""
    cost = costs(gates, frame["packets"], frame["cache_lines"])
    if cost is None:
        return {}
    use, whole = mean_use(gates["arithmetic"], frame["units"]), sum(cost)
    rays = frame["width"] * frame["height"] / frame["cycles"]
    return {
        "C_AU + C_IM": whole,
        "thesis's C_RTC": gates["pipelines"] * thesis_gates(frame["packets"], frame["cache_lines"]),
        "QGHW": 1e6 * rays / whole,
        "U_AU": 100 * use,
        "QHW": 100 * use * cost[0] / whole,
    }
