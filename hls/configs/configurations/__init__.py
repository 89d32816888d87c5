# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The configurations of the core: their keys (keys.py) and what these ask of each other (rules.py),
read from JSON (reading.py) and written as C++ (cpp.py)."""

from configurations.gone import GONE
from configurations.keys import KEYS, Key
from configurations.reading import (
    LISTED,
    Configuration,
    Refused,
    checked,
    inherited,
    listed,
    parse,
    read,
    read_one,
)
from configurations.rules import RULES

__all__ = [
    "GONE",
    "KEYS",
    "LISTED",
    "RULES",
    "Configuration",
    "Key",
    "Refused",
    "checked",
    "inherited",
    "listed",
    "parse",
    "read",
    "read_one",
]
