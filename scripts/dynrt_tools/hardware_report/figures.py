# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of the thesis's chapter 7.2 as data: what each shows, along what, and what the thesis's
text says. The frames that a report renders follow from them, and so do its curves: another figure is
another entry of FIGURES."""

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

from dynrt_tools.bench.scenes import THESIS as THESIS_RATES
from dynrt_tools.hardware.placed_clocks import THESIS_MHZ
from dynrt_tools.hardware_report.figure import (
    MORTON,
    SCANLINE,
    WITHOUT_HITS,
    Axis,
    Figure,
    Mark,
    Series,
)
from dynrt_tools.hardware_report.points import name_of, point_of
from dynrt_tools.project import Json

PACKETS = (1, 2, 4, 8, 16, 24, 32, 48, 64)
LINES = tuple(2**n for n in range(10))
CORES = (1, 2, 4, 8, 16)  # values of a key: each is a core of its own
PORTS = (2, 4, 8, 16, 32)  # bytes
OVER_PACKETS, OVER_LINES = Axis("packets", PACKETS), Axis("lines", LINES)
# At the thesis's clock: of three banks of 32 bits, each of which takes so many clocks for a word, and
# of a port of so many bytes a clock.
BANDWIDTH = 1020
MB_S = "MB/s of memory bandwidth"
OVER_BANKS = Axis("memory_clocks", CORES, MB_S, lambda clocks: BANDWIDTH / clocks)
OVER_PORTS = Axis("port_bytes", PORTS, MB_S, lambda width: float(width * THESIS_MHZ))
RATE = f"frames per second at {THESIS_MHZ} MHz"

UNITS = ("traversal", "list", "transformation", "intersection")
CACHES = {"traversal": "node", "list": "list", "transformation": "matrix"}

FIGURES = (
    Figure(
        "7.5 and 7.10",
        "Cache hit rate",
        OVER_LINES,
        "%",
        tuple(
            Series(
                f"{unit}{', scanline' if flags == SCANLINE else ''}", f"{cache} cache hits", flags
            )
            for flags in (MORTON, SCANLINE)
            for unit, cache in CACHES.items()
        )
        + (Series("second level", "second cache hits"),),
        limit=100,
        said="The Morton curve in place of scanlines raises the hit rate by about 10 to 20 %, most of "
        "all that of the list and of the transformation.",
    ),
    Figure(
        "7.6",
        "Hardware quality index QHW",
        OVER_PACKETS,
        "%",
        (Series("QHW", "QHW"),),
        said="The best is about 9.5 %, at 32 packets, in the scenes Gael and conference.",
        marks={scene: Mark(9.5, 9.5, 32) for scene in ("cistern", "conference")},
    ),
    Figure(
        "7.7",
        "Graphics hardware quality index QGHW",
        OVER_PACKETS,
        "rays a clock per million gates",
        (Series("QGHW", "QGHW"),),
        said="The best is at 32 packets too.",
    ),
    Figure(
        "7.8",
        "Use of units",
        OVER_PACKETS,
        "%",
        tuple(Series(unit, f"{unit} use") for unit in UNITS),
        limit=100,
        said="The use grows with the packets until that of one unit is near 100 %; those of the others "
        "keep their ratios to it.",
    ),
    Figure(
        "7.9",
        f"Frame rate at {THESIS_MHZ} MHz",
        OVER_PACKETS,
        "frames per second",
        (Series("frame rate", RATE),),
        said="Appendix A gives the typical frame rate of a scene; its Gael stands beside cistern.",
        marks={scene: Mark(*rates) for scene, rates in THESIS_RATES.items()},
    ),
    Figure(
        "7.11",
        f"Frame rate at {THESIS_MHZ} MHz",
        OVER_BANKS,
        "frames per second",
        (Series("frame rate without hit records", RATE, WITHOUT_HITS),),
        said="At a quarter of the bandwidth the frame rate of most scenes is only about 20 % lower; "
        "that of conference drops extremely.",
        behind_port=OVER_PORTS,
    ),
    Figure(
        "7.12",
        f"Frame rate at {THESIS_MHZ} MHz",
        Axis("pipelines", CORES),
        "frames per second",
        (Series("frame rate without hit records", RATE, WITHOUT_HITS),),
        said="In spite of the small caches 2 or 4 can be used at the one memory. Two at the whole "
        "bandwidth have more than twice the frame rate of one at half of it.",
    ),
)


def drawn_in(report: Json) -> list[Figure]:
    """The figures that a report was made for."""
    return [figure for figure in FIGURES if figure.name in report["figures"]]


@dataclass(frozen=True)
class Curve:
    configuration: str
    series: Series
    points: list[tuple[float, float]]  # the smallest x first

    @property
    def label(self) -> str:
        return f"{self.configuration}, {self.series.label}"


def curves(report: Json, figure: Figure, scene: str) -> Iterator[Curve]:
    """The curves of a figure for a scene, without points that are missing."""
    found = {
        (run["configuration"], name_of(run["flags"])): run
        for run in report["runs"]
        if run["scene"] == scene
    }
    names = [n for n, c in report["configurations"].items() if c["curves"]]
    for name, series in itertools.product(names, figure.series):
        configuration = report["configurations"][name]
        axis, values = figure.axis_of(configuration), []
        for value in axis.along_values(configuration):
            run = found.get((name, name_of(point_of(configuration, figure, series, value))))
            if run and run.get(series.value) is not None:
                values.append((axis.x_of(value), run[series.value]))
        if values:
            yield Curve(name, series, sorted(values))
