# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How far nextpnr has come, from the log that it writes: a chip that is nearly full takes an hour or
more."""

import contextlib
import pathlib
import re
import threading
from collections.abc import Iterator

from dynrt_tools.project import Progress

PLACING = re.compile(r"^Info: +at iteration #(\d+), type ALL:", re.MULTILINE)
REFINING = "Running simulated annealing placer for refinement"
TO_ROUTE = re.compile(r"^Info: Routing (\d+) arcs", re.MULTILINE)
# Attempts, arcs routed with and without another's removal, both in this row, arcs that remain, seconds.
ROUTING = re.compile(r"^Info: +\d+ \| +\d+ +\d+ \| +\d+ +\d+ \| +(\d+)\|", re.MULTILINE)
# The second router gives nets the same wire, and fewer in each round.
NEGOTIATING = re.compile(r"^Info: +iter=(\d+) wires=\d+ overused=(\d+)", re.MULTILINE)
ROUTED = "Routing complete"


def stage(log: str) -> str:
    """What the tool does at the end of this log."""
    if ROUTED in log:
        return "checking the clocks"
    if arcs := TO_ROUTE.search(log):
        left = ROUTING.findall(log)
        return f"routing, {int(left[-1] if left else arcs[1]):,} of {int(arcs[1]):,} arcs left"
    if rounds := NEGOTIATING.findall(log):
        count, shared = rounds[-1]
        return f"routing, round {count}: {int(shared):,} wires are shared by several nets"
    if REFINING in log:
        return "refining the placement"
    if placed := PLACING.findall(log):
        return f"placing, round {placed[-1]}"
    return "reading the netlist"


@contextlib.contextmanager
def followed(log: pathlib.Path, progress: Progress, seconds: float = 2) -> Iterator[None]:
    """Shows the stage every so many seconds until the end of a with statement."""
    ended = threading.Event()

    def follow() -> None:
        while not ended.wait(seconds):
            if log.exists():
                progress(stage(log.read_text(encoding="utf-8", errors="replace")))

    follower = threading.Thread(target=follow)
    follower.start()
    try:
        yield
    finally:
        ended.set()
        follower.join()
        progress("")
