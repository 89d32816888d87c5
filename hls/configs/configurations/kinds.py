# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The kinds of values that a key of a configuration may have.

Each kind says which JSON values it allows and in what words, how C++ writes one of them as a
constant, and of what type a CoreConfiguration holds it.
"""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol


def whole(value: object) -> object:
    """The same value; a number without a fraction as an integer, as CMake tells 0.0 from 0."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


class Kind(Protocol):
    """What every kind offers."""

    def allows(self, value: object) -> bool:
        """Whether the JSON value is one of this kind."""

    def wants(self) -> str:
        """The values that are allowed, in words."""

    def literal(self, value: object) -> str:
        """The C++ constant of an allowed value."""

    def held_as(self) -> str:
        """The C++ type that holds a value at run time."""


@dataclass(frozen=True)
class Whole:
    """A whole number."""

    low: int
    high: int
    power_of_two: bool = False
    or_zero: bool = False  # beside those from low on

    def allows(self, value: object) -> bool:
        return (
            isinstance(value, int)
            and not isinstance(value, bool)
            and (self.low <= value <= self.high or self.or_zero and value == 0)
            and not (self.power_of_two and value & (value - 1))
        )

    def wants(self) -> str:
        noun = "power of two" if self.power_of_two else "whole number"
        return f"{'0 or ' if self.or_zero else ''}a {noun} from {self.low} to {self.high}"

    def literal(self, value: object) -> str:
        return str(value)

    def held_as(self) -> str:
        return "unsigned"


@dataclass(frozen=True)
class Number:
    """A real number."""

    low: float
    high: float
    or_zero: bool = False  # beside those from low on

    def allows(self, value: object) -> bool:
        return (
            isinstance(value, (int, float))
            and not isinstance(value, bool)
            and math.isfinite(value)
            and (self.low <= value <= self.high or self.or_zero and value == 0)
        )

    def wants(self) -> str:
        return f"{'0 or ' if self.or_zero else ''}a number from {self.low:g} to {self.high:g}"

    def literal(self, value: object) -> str:
        assert isinstance(value, (int, float))
        return repr(float(value))

    def held_as(self) -> str:
        return "double"


@dataclass(frozen=True)
class Choice:
    """One of several names, each an enumerator of the C++ type `cpp`. With `about` that type is made
    from here, with what each name means; without it the type is declared elsewhere."""

    cpp: str
    enumerators: Mapping[str, str]
    about: str = ""
    meanings: Mapping[str, str] = field(default_factory=dict)

    def allows(self, value: object) -> bool:
        return isinstance(value, str) and value in self.enumerators

    def wants(self) -> str:
        return "one of " + ", ".join(self.enumerators)

    def literal(self, value: object) -> str:
        assert isinstance(value, str)
        return f"{self.cpp}::{self.enumerators[value]}"

    def held_as(self) -> str:
        return self.cpp


@dataclass(frozen=True)
class Subset:
    """At least one of several names, each a bool of the C++ struct `cpp`."""

    cpp: str
    members: tuple[str, ...]

    def allows(self, value: object) -> bool:
        return (
            isinstance(value, list)
            and len(value) > 0
            and len(set(map(str, value))) == len(value)
            and all(v in self.members for v in value)
        )

    def wants(self) -> str:
        return "a list of one or more of " + ", ".join(self.members)

    def literal(self, value: object) -> str:
        assert isinstance(value, list)
        states = (f".{m} = {'true' if m in value else 'false'}" for m in self.members)
        return f"{self.cpp}{{{', '.join(states)}}}"

    def held_as(self) -> str:
        return self.cpp


@dataclass(frozen=True)
class Flag:
    """True or false."""

    def allows(self, value: object) -> bool:
        return isinstance(value, bool)

    def wants(self) -> str:
        return "true or false"

    def literal(self, value: object) -> str:
        return "true" if value else "false"

    def held_as(self) -> str:
        return "bool"


@dataclass(frozen=True)
class Sentence:
    """A line of text."""

    def allows(self, value: object) -> bool:
        return isinstance(value, str) and value.strip() != "" and value.isprintable()

    def wants(self) -> str:
        return "a sentence"

    def literal(self, value: object) -> str:
        return json.dumps(value, ensure_ascii=False)

    def held_as(self) -> str:
        return "std::string"
