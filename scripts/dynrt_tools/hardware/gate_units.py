# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The thesis's tables 7.3 to 7.5, and which of our units and RAMs do what each of its units
does."""

import re
from dataclasses import dataclass

PACKETS, LINES = 32, 512  # of tables 7.4 and 7.5
PIPELINE = re.compile(r"^p\d+_")


@dataclass(frozen=True)
class Unit:
    """A row of table 7.4 or 7.5. `modules` are our instances; `rams` the beginnings of the names of
    RAMs of the join that it owns."""

    name: str
    logic: int
    bits: int  # per packet, or per cache line
    modules: tuple[str, ...] = ()
    rams: tuple[str, ...] = ()


SLICES = tuple(
    Unit(f"TraversalSlice{i}", 43107, 2352, (f"slice_{i}",), (f"ray_{i}_ram", f"distance_{i}_ram"))
    for i in range(4)
)
# Table 7.4, in its order. What its unit Traversal does beside those below it, our units do
# themselves.
PACKET_UNITS = (
    Unit("DynamicRTC", 21338, 0, ("startup",), ()),  # and all of the join that nobody owns
    Unit("Traversal", 8470, 0),
    Unit("TraversalMemoryInterface", 5060, 1292, ("node_fetch",)),
    Unit("TraversalStackPointer", 2568, 12),
    *SLICES,
    Unit("PacketTraversalDecision", 309, 0, ("packet_decision",), ("packet_decision__step_in",)),
    Unit("CollectHits", 4155, 688, ("collect_hits",), ("hit_record_ram",)),
    Unit("List", 2743, 76, ("list",), ("last_entry_ram",)),
    Unit("Mailbox", 7108, 136, ("mailbox",)),
    Unit(
        "LoadObject", 4557, 19, ("matrix_fetch", "matrix_store"), ("job_record_ram", "object_ram")
    ),
    Unit("SendPacket", 2262, 1152, ("send_packet",), ("ray_vectors_ram",)),
    Unit("PacketEncoder", 1316, 0),
    Unit("Transformation", 148040, 1152, ("transformation",), ("column_",)),
    Unit("PacketDecoder", 694, 72, ("packet_decoder",)),
    Unit("Intersection", 105972, 0, ("intersection",)),
)
# Table 7.5.
CACHE_UNITS = (
    Unit("MemoryInterface", 4323, 0, ("memory_interface",)),
    Unit(
        "NodeCache",
        4152,
        83,
        ("node_lookup", "node_fill"),
        ("node_lines_", "node_waiting_ram", "node_use_ram"),
    ),
    Unit(
        "ListCache",
        3704,
        51,
        ("list_lookup", "list_fill"),
        ("list_lines_", "list_waiting_ram", "list_use_ram"),
    ),
    Unit(
        "MatrixCache",
        5624,
        115,
        ("matrix_lookup", "matrix_fill"),
        ("matrix_lines_", "matrix_waiting_ram", "matrix_use_ram"),
    ),
)
# Of a core whose memory is behind a port: they do what a memory interface and a cache do, so they count
# with those of table 7.5.
PORT_UNITS = (
    Unit(
        "(memory port)",
        0,
        0,
        ("memory_lookup", "memory_gather", "memory_fill", "memory_answer", "memory_write"),
        ("in_flight_ram",),
    ),
    Unit("(second level)", 0, 0, (), ("second_rows", "last_miss_ram")),
)
# Ours alone: the thesis counts neither shading nor the making of rays.
OTHER_UNITS = (
    Unit("(ray generation)", 0, 0, ("ray_generation",), ("pixel_position_ram",)),
    Unit("(shading)", 0, 0, ("shading", "frame_writer")),
    *PORT_UNITS,
)
# Notes of rows whose halves differ in what they do.
NOTES = {
    "DynamicRTC": "in ours, the join of the units (arbiters, forks, queues) and `startup`",
    "Traversal": "in ours, part of `node_fetch`",
    "TraversalStackPointer": "in ours, part of `node_fetch`",
    "PacketEncoder": "in ours, part of `send_packet`",
}

# Table 7.3: floating-point units for addition, multiplication, division and comparison, and kB.
COMPLEXITY = {
    "Traversal": (4, 0, 4, 13, 44.5),
    "List": (0, 0, 0, 0, 0.8),
    "Transformation": (9, 9, 0, 0, 9.3),
    "Intersection": (3, 2, 1, 3, 0.0),
    "Cache (with index structure)": (0, 0, 0, 0, 15.6),
}
# The same of ours, by the operators of Float in the units' sources: a slice subtracts, divides and
# compares three times (plane and near, far and plane, hit and near), the collection compares a hit
# with the closest; component() of the transformation has three products and three sums.
OPERATORS = {
    "Traversal": (4, 0, 4, 13),
    "List": (0, 0, 0, 0),
    "Transformation": (9, 9, 0, 0),
    "Intersection": (3, 2, 1, 3),
    "Cache (with index structure)": (0, 0, 0, 0),
}
# How the names of our instances begin that have such operators, those of other configurations among
# them: a camera unit, a box test and the reciprocals do what a transformation or a slice did. The
# subtractions of matrix_store, which few configurations have, are left out: its name is that of a
# store.
ARITHMETIC = (
    "slice_",
    "plane_offset",
    "ray_reciprocal",
    "world_box",
    "transformation",
    "camera_rays",
    "intersection",
    "collect_hits",
)
# Which rows of tables 7.4 and 7.5 a row of table 7.3 stands for.
COMPLEXITY_ROWS = {
    "Traversal": (
        "Traversal",
        "TraversalMemoryInterface",
        "TraversalStackPointer",
        *(u.name for u in SLICES),
        "PacketTraversalDecision",
        "CollectHits",
    ),
    "List": ("List", "Mailbox"),
    "Transformation": (
        "LoadObject",
        "SendPacket",
        "PacketEncoder",
        "Transformation",
        "PacketDecoder",
    ),
    "Intersection": ("Intersection",),
    "Cache (with index structure)": tuple(u.name for u in CACHE_UNITS),
}


def gates(packets: int, lines: int) -> int:
    """The thesis's C_RTC(P, CL)."""
    return 487020 + 56028 * packets + 996 * lines


def bits(packets: int, lines: int) -> int:
    """The thesis's Bits_RTC(P, CL)."""
    return 14007 * packets + 249 * lines


def plain_name(name: str) -> str:
    """That of an instance or RAM without its pipeline, with which it begins where there are several."""
    return PIPELINE.sub("", name)


def owner(name: str) -> str | None:
    """The unit that owns a RAM of the join; None for a RAM that only joins units."""
    for unit in (*PACKET_UNITS, *CACHE_UNITS, *OTHER_UNITS):
        if plain_name(name).startswith(unit.rams) and unit.rams:
            return unit.name
    return None
