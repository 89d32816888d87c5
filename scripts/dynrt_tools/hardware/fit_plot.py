# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Draws predicted against placed times of limiting ends as SVG."""

import pathlib

from dynrt_tools.project import Json


def draw(path: pathlib.Path, data: Json) -> None:
    # It takes long to load, and only those who draw need it.
    import matplotlib  # pylint: disable=import-outside-toplevel
    from matplotlib import pyplot  # pylint: disable=import-outside-toplevel

    pyplot.switch_backend("svg")  # no window
    matplotlib.rcParams["svg.hashsalt"] = path.name  # the same data, the same file
    figure, axes = pyplot.subplots(figsize=(6, 5), layout="constrained")
    times = [t for end in data["ends"] for t in (end["placed"], end["predicted"])] or [0.0, 1.0]
    low, high = 0.95 * min(times), 1.05 * max(times)
    axes.fill_between([low, high], [0.9 * low, 0.9 * high], [1.1 * low, 1.1 * high], alpha=0.15)
    axes.plot([low, high], [low, high], linewidth=0.8)
    for kind in dict.fromkeys(end["kind"] for end in data["ends"]):
        ends = [end for end in data["ends"] if end["kind"] == kind]
        axes.scatter(
            [end["placed"] for end in ends], [end["predicted"] for end in ends], s=12, label=kind
        )
    axes.set(
        title=f"{pathlib.Path(data['model']).name}: ends that limit; the band is 10 %",
        xlabel="placed, ns (median of the seeds)",
        ylabel="predicted, ns",
        xlim=(low, high),
        ylim=(low, high),
    )
    axes.grid(alpha=0.3)
    if data["ends"]:
        axes.legend()
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)
