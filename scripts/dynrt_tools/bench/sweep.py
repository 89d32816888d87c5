# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The thesis's figures 7.8 to 7.10 from our RTL: how busy the units are with more and more packets,
the frame rate that follows, and how often the caches hit with more and more lines. Each as a CSV
and as an SVG."""

import csv
import os
import pathlib
from collections.abc import Sequence

from matplotlib import pyplot

from dynrt_tools.bench.run import Dynrt
from dynrt_tools.command import Pool
from dynrt_tools.hardware import placed_clocks
from dynrt_tools.project import Json, Progress

PACKETS = (1, 2, 4, 8, 16, 24, 32, 48, 64)
LINES = tuple(2**n for n in range(10))
# The thesis's four units, and which of ours does its one transaction a clock.
UNITS = {
    "traversal": "node_lookup",
    "list": "list_lookup",
    "transformation": "transformation",
    "intersection": "intersection",
}


def rates(cycles: float, config: str) -> dict[str, float]:
    """Frames per second at the placed clock and at the thesis's."""
    clocks = placed_clocks.of(config).mhz, placed_clocks.THESIS_MHZ
    return {
        f"frames per second at {mhz:g} MHz": placed_clocks.frames_per_second(cycles, mhz)
        for mhz in clocks
    }


def columns(frame: Json, config: str) -> dict[str, float]:
    """A row of either table but for what was varied."""
    usage = {f"{name} usage": frame["units"][unit]["utilisation"] for name, unit in UNITS.items()}
    hits = {f"{name} cache hits": cache["hit_rate"] for name, cache in frame["caches"].items()}
    return {
        "clocks": frame["cycles"],
        **rates(frame["cycles"], config),
        **usage,
        **hits,
    }


def measure(
    dynrt: Dynrt,
    scene: str,
    config: str,
    size: str,
    flag: str,
    values: Sequence[int],
    progress: Progress,
) -> list[dict[str, float]]:
    """One frame for each value, as many at a time as there are cores, which the clocks of the core
    do not depend on."""

    def row(value: int) -> dict[str, float]:
        return {
            flag: value,
            **columns(
                dynrt.render(scene, "rtl", config, size, f"--{flag}", str(value)).frame, config
            ),
        }

    rows = []
    with Pool(os.cpu_count()) as pool:
        for result in pool.map(row, values):
            rows.append(result)
            progress(f"{flag}: {len(rows)} of {len(values)}")
    return rows


def write_csv(path: pathlib.Path, rows: list[dict[str, float]]) -> None:
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def plot(
    path: pathlib.Path,
    title: str,
    rows: list[dict[str, float]],
    along: str,
    names: list[str],
    factor: float,
    unit: str,
    limit: float | None,
) -> None:
    pyplot.switch_backend("svg")  # no window
    figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
    for name in names:
        axes.plot(
            [row[along] for row in rows],
            [factor * row[name] for row in rows],
            marker="o",
            markersize=3,
            label=name,
        )
    axes.set(title=title, xlabel=along, ylabel=unit, xlim=(0, None), ylim=(0, limit))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(path)
    pyplot.close(figure)


def run(
    dynrt: Dynrt,
    scene: str,
    config: str,
    core: Json,
    size: str,
    folder: pathlib.Path,
    progress: Progress,
) -> None:
    """`core` holds the keys of the configuration."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    numbers = [number for number in PACKETS if number <= core["packets"]]
    each = [number for number in LINES if number <= core["lines"]]
    about = f"{pathlib.Path(scene).stem}, {size}"
    packets = measure(dynrt, scene, config, size, "packets", numbers, progress)
    write_csv(folder / "packets.csv", packets)
    plot(
        folder / "usage.svg",
        f"Usage of units, {about}, {each[-1]} lines",
        packets,
        "packets",
        [f"{name} usage" for name in UNITS],
        100,
        "%",
        100,
    )
    plot(
        folder / "frame_rate.svg",
        f"Frame rate, {about}, {each[-1]} lines",
        packets,
        "packets",
        [name for name in packets[0] if name.startswith("frames per second")],
        1,
        "frames per second",
        None,
    )
    lines = measure(dynrt, scene, config, size, "lines", each, progress)
    write_csv(folder / "lines.csv", lines)
    plot(
        folder / "hit_rate.svg",
        f"Cache hit rate, {about}, {numbers[-1]} packets",
        lines,
        "lines",
        [name for name in lines[0] if name.endswith("cache hits")],
        100,
        "%",
        100,
    )
    progress("")
    print(f"Frames per second are {placed_clocks.of(config).of_core(config)}.")
    print(
        "\n".join(
            str(folder / name)
            for name in ("packets.csv", "usage.svg", "frame_rate.svg", "lines.csv", "hit_rate.svg")
        )
    )
