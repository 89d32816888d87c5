# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What Verilator says of a design."""

import re

# Of files, memory and time: releases from 5.024 on print it for every run, lint too.
REPORT = re.compile(r"^- .*\n?", re.MULTILINE)


def remarks(output: str) -> str:
    """Its warnings and errors; nothing if the design is clean."""
    return REPORT.sub("", output)
