# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of a frame by the names that tables, plots and documents have them under. Uses and
hit rates are in percent, shares are parts of one."""

from collections.abc import Sequence
from dataclasses import dataclass

from dynrt_tools.hardware.placed_clocks import THESIS_MHZ, frames_per_second
from dynrt_tools.project import Json

RATE = f"frames per second at {THESIS_MHZ} MHz"
SLOWEST = f"slowest frame, per second at {THESIS_MHZ} MHz"
# The thesis's four units, and which of ours does its one transaction a clock.
UNITS = {
    "traversal": "node_lookup",
    "list": "list_lookup",
    "transformation": "transformation",
    "intersection": "intersection",
}
BYTES = ("bytes_read", "pixel_bytes_written", "hit_bytes_written")
MEMORY = "memory_interface"
FULL = 0.9  # of the clocks: a unit that works more has next to nothing to wait for
STALLED = 0.01  # of the clocks: what is less is not worth a word
# The cores whose counters say how many triangles and objects packets meet: each of four rays goes
# through the transformation for every item, and a leaf is a node.
TELLING = ("thesis", "full")


def rays(frame: Json) -> int:
    return int(frame["width"] * frame["height"])


def busiest(units: Json) -> str:
    """The unit that works in most of the clocks. Those before and behind the transformation work as
    often as it does, and for it."""
    return max(units, key=lambda unit: (units[unit]["utilisation"], unit == "transformation"))


def figures_of(frame: Json) -> Json:
    """All that the report of a frame tells."""
    clocks, count = frame["cycles"], rays(frame)
    units, caches, memory = (frame[key] for key in ("units", "caches", "memory"))
    unit = busiest(units)
    found = {
        "clocks": clocks,
        "rays per clock": count / clocks,
        RATE: frames_per_second(clocks, THESIS_MHZ),
        "busiest unit": unit,
        "use": 100 * units[unit]["utilisation"],
        "port use": (
            100 * units["memory_gather"]["utilisation"] if "memory_gather" in units else None
        ),
        **{f"{n} use": 100 * units[u]["utilisation"] for n, u in UNITS.items() if u in units},
        **{f"{n} cache hits": 100 * cache["hit_rate"] for n, cache in caches.items()},
        "bytes read per ray": memory["bytes_read"] / count,
        "bytes written per ray": (memory["pixel_bytes_written"] + memory["hit_bytes_written"])
        / count,
    }
    if "most_cycles" in frame:
        found[SLOWEST] = frames_per_second(frame["most_cycles"], THESIS_MHZ)
    if "counters" in frame:
        found |= counted(frame) | {"waits": waits(frame)}
    return found


def counted(frame: Json) -> Json:
    """The work of a frame that its counters tell."""
    work, caches = Work.of(frame), frame["caches"]
    return {
        **{f"{n.replace('_', ' ')} per packet": work.per_packet(n) for n in Work.EACH},
        "clocks, bound": work.bound(),
        "nodes fetched": frame["counters"].get("node_fetch.transactions"),
        "columns asked for": caches["matrix"].get("lookups"),
        "columns read": caches["matrix"].get("misses"),
        "lines read": sum(cache.get("misses", 0) for cache in caches.values()),
    }


@dataclass
class Work:
    """The work of a frame, in tokens of the whole frame. What the counters of a core do not say is
    None."""

    EACH = ("nodes", "steps", "leaf_fetches", "list_entries", "triangles", "objects")

    packets: int
    nodes: int  # fetched, both levels
    list_entries: int  # entries read, both levels
    vectors: int  # through the transformation
    steps: int | None = None  # inner nodes fetched
    leaf_fetches: int | None = None  # leaves fetched by a packet with a living ray
    triangles: int | None = None  # packets transformed to a triangle, after the mailbox
    objects: int | None = None  # packets transformed to an object, after the mailbox

    @staticmethod
    def of(frame: Json) -> "Work":
        tokens = frame["counters"]
        packets = tokens.get("shade_job.tokens", 0)
        nodes = tokens.get("node_lookup.transactions", 0)
        entries = tokens.get("list_lookup.transactions", 0)
        vectors = tokens.get("transformation.transactions", 0)
        if frame["configuration"] not in TELLING:
            return Work(packets, nodes, entries, vectors)
        # Four candidates for every triangle, and four that reset the hits of a new packet.
        triangles = tokens["collect_hits.transactions"] // 4 - packets
        objects = tokens["transform_job.tokens"] - triangles - packets
        seen = entries - triangles - objects
        # The list gets a job for every leaf, entry already seen, triangle done and object done.
        leaves = tokens["list_job.tokens"] - seen - triangles - objects
        return Work(packets, nodes, entries, vectors, nodes - leaves, leaves, triangles, objects)

    def bound(self) -> int:
        """Clocks of the busiest unit alone: a node, a list entry or a vector a clock."""
        return max(self.nodes, self.vectors, self.list_entries)

    def per_packet(self, name: str) -> float | None:
        value = getattr(self, name)
        return None if value is None or not self.packets else float(value) / self.packets


def waits(frame: Json) -> str:
    """The bound of the speed in words: the work itself, or lines that come from memory."""
    units, name = frame["units"], busiest(frame["units"])
    share, packets = units[name]["utilisation"], Work.of(frame).packets
    text = f"{name} works in {100 * share:.1f} % of the clocks"
    if packets and "transactions" in units[name]:
        text += f", {units[name]['transactions'] / packets:.0f} times for each packet"
    if name == MEMORY:
        text += "; all others wait for lines that the caches do not hold"
    elif share >= FULL:
        text += "; it waits for nothing, so only less of that work, or more of it done a clock, "
        text += "would be faster"
    else:
        text += ", and otherwise waits for packets that are elsewhere"
        if MEMORY in units:
            missed = 100 * units[MEMORY]["utilisation"]
            text += f"; the memory serves cache misses in {missed:.1f} %"
    stalled = [
        f"{unit} {100 * one['stalled']:.1f} %"
        for unit, one in units.items()
        if one.get("stalled", 0) >= STALLED
    ]
    return text + (
        f"; held up for want of room behind them: {', '.join(stalled)}" if stalled else ""
    )


def mean(frames: Sequence[Json]) -> Json:
    """The frames of a walk as one. Clocks and bytes are means; a share of clocks or of lookups is
    one of those of all frames."""
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
