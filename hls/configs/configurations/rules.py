# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the values of keys ask of another key."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol


Literal = Callable[[object], str]  # the C++ constant of a value


class Wants(Protocol):
    """The values of another key that a rule allows."""

    def allows(self, value: object) -> bool:
        """Whether this is one of them."""

    def condition(self, value: str, literal: Literal) -> str:
        """The C++ condition that an expression has one of them."""

    def __str__(self) -> str:
        """All of them, in words."""


class OneOf:
    """Some values."""

    def __init__(self, *values: object):
        self.values = values

    def allows(self, value: object) -> bool:
        return value in self.values

    def condition(self, value: str, literal: Literal) -> str:
        return " || ".join(f"{value} == {literal(one)}" for one in self.values)

    def __str__(self) -> str:
        return " or ".join(v if isinstance(v, str) else json.dumps(v) for v in self.values)


@dataclass(frozen=True)
class AtLeast:
    """Whole numbers from `low` on."""

    low: int

    def allows(self, value: object) -> bool:
        return isinstance(value, int) and value >= self.low

    def condition(self, value: str, literal: Literal) -> str:
        return f"{value} >= {literal(self.low)}"

    def __str__(self) -> str:
        return f"{self.low} or more"


@dataclass(frozen=True)
class AtMost:
    """Whole numbers up to `high`."""

    high: int

    def allows(self, value: object) -> bool:
        return isinstance(value, int) and value <= self.high

    def condition(self, value: str, literal: Literal) -> str:
        return f"{value} <= {literal(self.high)}"

    def __str__(self) -> str:
        return f"{self.high} at most"


@dataclass(frozen=True)
class Rule:
    """With these values of keys, another key must have one of some values."""

    given: Mapping[str, object]
    other: str
    wants: Wants
    why: str

    def __str__(self) -> str:
        """A sentence without its full stop."""
        given = " and ".join(f"{key} {json.dumps(value)}" for key, value in self.given.items())
        return f"with {given} the key '{self.other}' must be {self.wants}, as {self.why}"


FAST = {"datapath": "fast"}
WATERTIGHT = {"triangle_test": "watertight"}
IN_BANKS = {"memory": "banks"}
BEHIND_PORT = {"memory": "port"}
ONE_LEVEL = {"levels": 1}
MAIN_FIRST = {"main_first": True}
COMMON_ORIGIN = {"origins": "common"}
WORD_OF_PORT = "a word of the memory behind the port has 32 bits, 24 of them for a float"
RULES: tuple[Rule, ...] = (
    *(
        Rule(
            {"line_nodes": nodes},
            "lines",
            AtLeast(8 * nodes),
            "a line of list entries takes the place of twice as many, in each of up to four ways",
        )
        for nodes in (2, 4)
    ),
    *(
        Rule({"ways": ways}, "lines", AtLeast(ways), "a set has a line in each way")
        for ways in (2, 4)
    ),
    Rule(IN_BANKS, "second_level", OneOf(0), "the second level stands before the port"),
    Rule(IN_BANKS, "line_nodes", OneOf(1), "a bank gives one node in a clock"),
    Rule(IN_BANKS, "pixel_bits", OneOf(32), "a bank's word holds one pixel"),
    Rule(
        {"pixel_bits": 16},
        "scan_out",
        OneOf(False),
        "the VGA display takes a pixel of each word of a bank",
    ),
    Rule(
        BEHIND_PORT,
        "memory_clocks",
        OneOf(1),
        "it slows the banks; a memory behind the port has clocks of its own",
    ),
    Rule(BEHIND_PORT, "mantissa_bits", AtMost(16), WORD_OF_PORT),
    Rule(BEHIND_PORT, "exponent_bits", AtMost(7), WORD_OF_PORT),
    Rule(
        ONE_LEVEL,
        "triangle_test",
        OneOf("unit_triangle"),
        "a ray's map is made when it enters an object",
    ),
    Rule(
        MAIN_FIRST,
        "crossing",
        OneOf("none", "remember"),
        "the groups of a split packet would each begin with the main object",
    ),
    Rule(
        MAIN_FIRST,
        "datapath",
        OneOf("fast"),
        "rays start in the list of the main object, whose address only a pointer has",
    ),
    Rule(
        COMMON_ORIGIN,
        "datapath",
        OneOf("fast"),
        "a slice that divides subtracts the origin of its ray itself",
    ),
    Rule(
        COMMON_ORIGIN,
        "reflections",
        OneOf(0),
        "the reflected rays of a packet start at points of their own",
    ),
    Rule(
        FAST | WATERTIGHT,
        "origins",
        OneOf("common"),
        "the origin of a packet's rays is subtracted from a triangle's corners once",
    ),
    Rule(
        WATERTIGHT,
        "triangle_matrix",
        OneOf("normal_consistent"),
        "corners and normal take four columns",
    ),
    Rule(WATERTIGHT, "primitives", OneOf(["triangle"]), "only triangles are mapped to the ray"),
    Rule(WATERTIGHT, "epsilon", OneOf(0), "edges are decided exactly"),
    Rule(
        WATERTIGHT,
        "exponent_bits",
        OneOf(7, 8),
        "ordinary coordinates must not saturate, and the model holds a product, which takes two "
        "bits more, in a double",
    ),
)
FLOAT_BITS = 32  # of a float with its sign, at most: a hit record has a word for each
