# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How many nodes of a tree lie together in a line of the node cache. A core behind a memory port
reads a line at once, and the host puts subtrees into it; the number that suits a scene and its
memory best is measured."""

from collections.abc import Callable, Iterable

from dynrt_tools.specialise.analyst import FrameCosts
from dynrt_tools.specialise.curve import by_percent
from dynrt_tools.specialise.decisions import Measured

Layouts = dict[int, FrameCosts]  # by nodes of a line
AS_FAST = 2  # percent more clocks than the fewest: no slower, so that the bytes decide


def keys(nodes: int, why: str) -> Measured:
    """With so many nodes in a line."""
    return {"line_nodes": (nodes, why)}


def being_measured(nodes: int) -> Measured:
    """Of the core that is measured; its counters tell what it reads and cost no clock."""
    return keys(nodes, "being measured") | {"counters": (True, "being measured")}


def measured(frame_of: Callable[[int], FrameCosts], numbers: Iterable[int]) -> Layouts:
    """From the fewest nodes up to a number that is both slower and reads more than one before."""
    found: Layouts = {}
    for nodes in sorted(numbers):
        found[nodes] = frame_of(nodes)
        if any(_is_worse(found[nodes], other) for other in found.values()):
            break
    return found


def _is_worse(costs: FrameCosts, other: FrameCosts) -> bool:
    return costs.clocks > other.clocks and (costs.bytes_per_ray or 0) > (other.bytes_per_ray or 0)


def best(layouts: Layouts) -> int:
    """The one that reads the fewest bytes among those that are as fast as the fastest."""
    fewest = min(costs.clocks for costs in layouts.values())
    fast = [n for n, costs in layouts.items() if costs.clocks <= fewest * (1 + AS_FAST / 100)]
    return min(fast, key=lambda n: (layouts[n].bytes_per_ray or 0, n))


def reason(layouts: Layouts, chosen: int, frame: str) -> str:
    """Why this number, beside all others that were measured."""
    base = layouts[chosen]

    def words(nodes: int) -> str:
        costs = layouts[nodes]
        read = "" if costs.bytes_per_ray is None else f" and {costs.bytes_per_ray:.2f} bytes a ray"
        if nodes == chosen:
            return f"with {nodes} {frame} takes {costs.clocks:,} clocks{read}"
        more = by_percent(100 * (costs.clocks / base.clocks - 1), "fewer", "more")
        return f"with {nodes} {more}{read}"

    others = [nodes for nodes in layouts if nodes != chosen]
    return ", ".join(map(words, [chosen, *others]))
