# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the value of a key asks of another key."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Rule:
    """What a key's value asks of another key."""

    key: str
    value: object
    other: str
    allows: Callable[[object], bool]  # of the other's value
    wants: str
    why: str


def at_least(low: int) -> Callable[[object], bool]:
    """Allows whole numbers from `low` on."""
    return lambda value: isinstance(value, int) and value >= low


def at_most(high: int) -> Callable[[object], bool]:
    """Allows whole numbers up to `high`."""
    return lambda value: isinstance(value, int) and value <= high


BOX_UNIT = ("object_box", "unit")
WORLD_BOX = ("object_box", "world")
WATERTIGHT = ("triangle_test", "watertight")
WATERTIGHT_COMMON = ("triangle_test", "watertight_common")
IN_BANKS = ("memory", "banks")
BEHIND_PORT = ("memory", "port")
HALF_PIXELS = ("pixel_bits", 16)
ONE_LEVEL = ("levels", 1)
MAIN_FIRST = ("main_first", True)
COMMON_ORIGIN = ("origins", "common")
OWN_ORIGINS = ("origins", "each")
# What either watertight test asks of another key.
OF_WATERTIGHT: tuple[tuple[str, Callable[[object], bool], str, str], ...] = (
    (
        "triangle_matrix",
        lambda v: v == "normal_consistent",
        "normal_consistent",
        "corners and normal take four columns",
    ),
    (
        "primitives",
        lambda v: v == ["triangle"],
        '["triangle"]',
        "only triangles are mapped to the ray",
    ),
    ("epsilon", lambda v: v == 0, "0", "edges are decided exactly"),
    (
        "exponent_bits",
        lambda v: v in (7, 8),
        "7 or 8",
        "ordinary coordinates must not saturate, and the model holds a product, which takes two "
        "bits more, in a double",
    ),
)
RULES: tuple[Rule, ...] = (
    *(
        Rule(
            "line_nodes",
            nodes,
            "lines",
            at_least(8 * nodes),
            f"{8 * nodes} or more",
            "a line of list entries takes the place of twice as many, in each of up to four ways",
        )
        for nodes in (2, 4, 8)
    ),
    Rule(
        "line_nodes",
        4,
        "second_line",
        at_least(32),
        "32",
        "a line of the node cache, 8 bytes for each node, lies in one of the second level",
    ),
    Rule(
        "line_nodes",
        8,
        "second_level",
        lambda v: v == 0,
        "0",
        "a line of the node cache, 8 bytes for each node, lies in one of the second level, which has "
        "32 at most",
    ),
    Rule(
        "line_nodes",
        8,
        "port_bytes",
        at_least(4),
        "4 or more",
        "a read has 16 beats at most",
    ),
    Rule("ways", 2, "lines", at_least(2), "2 or more", "a set has a line in each way"),
    Rule("ways", 4, "lines", at_least(4), "4 or more", "a set has a line in each way"),
    Rule(
        *IN_BANKS,
        "second_level",
        lambda v: v == 0,
        "0",
        "the second level stands before the port",
    ),
    Rule(
        *IN_BANKS,
        "line_nodes",
        lambda v: v == 1,
        "1",
        "a bank gives one node in a clock",
    ),
    Rule(
        *IN_BANKS,
        "pixel_bits",
        lambda v: v == 32,
        "32",
        "a bank's word holds one pixel",
    ),
    Rule(
        *HALF_PIXELS,
        "scan_out",
        lambda v: v is False,
        "false",
        "the VGA display takes a pixel of each word of a bank",
    ),
    Rule(
        "port_bytes",
        32,
        "second_line",
        at_least(32),
        "32",
        "a line of the second level takes at least a beat",
    ),
    Rule(
        *BEHIND_PORT,
        "memory_clocks",
        lambda v: v == 1,
        "1",
        "it slows the banks; a memory behind the port has clocks of its own",
    ),
    Rule(
        *BEHIND_PORT,
        "mantissa_bits",
        at_most(16),
        "16 at most",
        "a word of the memory behind the port has 32 bits, 24 of them for a float",
    ),
    Rule(
        *BEHIND_PORT,
        "exponent_bits",
        at_most(7),
        "7 at most",
        "a word of the memory behind the port has 32 bits, 24 of them for a float",
    ),
    Rule(*ONE_LEVEL, "object_box", lambda v: v == "nodes", "nodes", "no object is entered"),
    Rule(
        *ONE_LEVEL,
        "triangle_test",
        lambda v: v == "unit_triangle",
        "unit_triangle",
        "a ray's shear is made when it enters an object",
    ),
    Rule(
        *MAIN_FIRST,
        "crossing",
        lambda v: v != "split",
        "none or remember",
        "the groups of a split packet would each begin with the main object",
    ),
    Rule(
        *MAIN_FIRST,
        "leaves",
        lambda v: v == "pointers",
        "pointers",
        "rays start in the list of the main object, whose address only a pointer has",
    ),
    Rule(
        *MAIN_FIRST,
        "rays_sent",
        lambda v: v == "active",
        "active",
        "the list knows which rays go on to the other objects where it knows those in a leaf",
    ),
    Rule(
        *COMMON_ORIGIN,
        "reflections",
        lambda v: v == 0,
        "0",
        "the reflected rays of a packet start at points of their own",
    ),
    Rule(
        *OWN_ORIGINS,
        "stack_entries",
        lambda v: v == 64,
        "64",
        "a packet that starts again finds its way by the order of a node's children, which only "
        "rays of one origin share",
    ),
    Rule(
        *BOX_UNIT,
        "rays_sent",
        lambda v: v == "traced",
        "traced",
        "the unit that clips to a box waits for every ray of a packet",
    ),
    Rule(
        *WORLD_BOX,
        "origins",
        lambda v: v == "common",
        "common",
        "an object's box is stored as it lies from the point where all rays start",
    ),
    Rule(
        *WORLD_BOX,
        "rays_sent",
        lambda v: v == "active",
        "active",
        "rays that miss an object's box do not enter the object, but others of their packet do",
    ),
    Rule(
        *WORLD_BOX,
        "divider",
        lambda v: v == "three_reciprocals",
        "three_reciprocals",
        "a ray is tested with the reciprocals of its direction in the world, written all at once",
    ),
    Rule(
        *WATERTIGHT,
        "object_box",
        lambda v: v == "nodes",
        "nodes",
        "corners are rounded before an object's tree is built, not scaled after",
    ),
    Rule(
        *WATERTIGHT,
        "stack_entries",
        lambda v: v == 64,
        "64",
        "the widened distance of a plane depends on the hit so far, so a packet that starts again "
        "might take another way",
    ),
    Rule(
        *WATERTIGHT,
        "divider",
        lambda v: v == "quotient",
        "quotient",
        "a ray's shear is made of its direction, not of reciprocals",
    ),
    Rule(
        *WATERTIGHT,
        "camera",
        lambda v: v == "transformation",
        "transformation",
        "a triangle's corners come on the way of the other rays",
    ),
    Rule(
        *WATERTIGHT,
        "sums",
        lambda v: v == "rounded",
        "rounded",
        "a product of a triangle's corner is used without the others",
    ),
    Rule(
        *WATERTIGHT_COMMON,
        "origins",
        lambda v: v == "common",
        "common",
        "the origin of a packet's rays is subtracted from a triangle's corners once",
    ),
    Rule(
        *WATERTIGHT_COMMON,
        "divider",
        lambda v: v == "three_reciprocals",
        "three_reciprocals",
        "a ray's map is made of its direction and the reciprocals, where these are made",
    ),
    Rule(
        *WATERTIGHT_COMMON,
        "camera",
        lambda v: v == "own_unit",
        "own_unit",
        "the transformation gives mapped triangles to the intersection itself",
    ),
    Rule(
        *WATERTIGHT_COMMON,
        "object_box",
        lambda v: v != "unit",
        "nodes or world",
        "corners are rounded before an object's tree is built, not scaled after",
    ),
) + tuple(
    Rule(*test, other, allows, wants, why)
    for test in (WATERTIGHT, WATERTIGHT_COMMON)
    for other, allows, wants, why in OF_WATERTIGHT
)
FLOAT_BITS = 32  # of a float with its sign, at most: a hit record has a word for each
