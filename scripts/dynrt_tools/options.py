# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The kinds of numbers that flags of several commands take, and the flags that they share."""

import argparse
import math
import os


def positive(text: str) -> float:
    """A number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = 0
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number above 0")
    return value


def whole(text: str) -> int:
    """A whole number, 0 or above."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number")
    return int(text)


def count(text: str) -> int:
    """A whole number above 0."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number above 0")
    return int(text)


def add_jobs(parser: argparse.ArgumentParser, what: str) -> None:
    """The flag that says how many of something run at a time."""
    parser.add_argument(
        "--jobs",
        type=count,
        default=os.cpu_count() or 1,
        metavar="N",
        help=f"{what} at a time (default: the number of cores)",
    )
