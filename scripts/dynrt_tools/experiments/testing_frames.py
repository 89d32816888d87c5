# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of experiments share: frames and gates whose figures are easy to compute by
hand."""

from collections.abc import Mapping

from dynrt_tools.experiments import figures
from dynrt_tools.project import Json

PIXELS = (32, 24)
ARITHMETIC = {"slice_0": 300, "intersection": 100}


def gates(packets: int, lines: int, pipelines: int = 1) -> Json:
    """In each pipeline: logic 1,000 gates and 10 a packet; memories 200 a packet and 30 a line."""
    return {
        "logic": pipelines * (1000 + 10 * packets),
        "memory": pipelines * (200 * packets + 30 * lines),
        "arithmetic": {name: pipelines * count for name, count in ARITHMETIC.items()},
    }


def gates_of(keys: Mapping[str, int]) -> Json:
    return gates(keys["packets"], keys["lines"], keys.get("pipelines", 1))


def frame(packets: int, lines: int, scanline: bool = False, keys: Json | None = None) -> Json:
    """The slice works in packets / 10 of the clocks, the intersection in half as many. With
    scanlines and with fewer lines the caches miss more. Each clock more of the memory makes a frame
    an eighth longer."""
    found = keys or {}
    wait, _, pipelines = (int(found.get(key, own)) for key, own in figures.KEYS.items())
    use = packets / 10
    misses = {"node": 400 // lines, "list": 100 // lines, "matrix": 200 // lines}
    units = {"slice_0": use, "node_lookup": use, "list_lookup": use / 4, "transformation": use / 2}
    units["intersection"] = use / 2
    return {
        "packets": packets,
        "cache_lines": lines,
        "width": PIXELS[0],
        "height": PIXELS[1],
        "cycles": 76800 // packets * (7 + wait) // (8 * pipelines),
        "memory": {
            "bytes_read": 8 * misses["node"] + 4 * misses["list"] + 12 * misses["matrix"],
            "pixel_bytes_written": 4 * PIXELS[0] * PIXELS[1],
            "hit_bytes_written": 24 * PIXELS[0] * PIXELS[1],
        },
        "units": {name: {"utilisation": value} for name, value in units.items()},
        "caches": {
            name: {
                "lookups": 500,
                "misses": count + 50 * scanline,
                "hit_rate": 1 - (count + 50 * scanline) / 500,
            }
            for name, count in misses.items()
        },
    }


def walk(packets: int, lines: int, scanline: bool = False, keys: Json | None = None) -> Json:
    """Three frames of which that is the mean: each takes two clocks more than the one before."""
    mean = frame(packets, lines, scanline, keys)
    frames = [{**mean, "cycles": mean["cycles"] + 2 * i - 2} for i in range(3)]
    return {"walk": {"frames": [{"figures": one} for one in frames]}}
