# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the curves of a report say that the thesis's text says of its own: where the indices are best,
what the Morton curve gains over scanlines, what a slower memory costs and several pipelines bring."""

import operator

from dynrt_tools.hardware_report import figures, points
from dynrt_tools.hardware_report.figure import SCANLINE, WITHOUT_HITS, Point, is_behind_port
from dynrt_tools.project import Json

QUARTER = "lost at a quarter of the bandwidth"
HALF = "2 pipelines, by twice one at half the bandwidth"
MANY = 4  # pipelines that the thesis's text has at the most
SPEED_UPS = {number: f"speed-up of {number} pipelines" for number in (2, MANY)}
INDICES = ("QHW", "QGHW")
COLUMNS = (
    "best QHW",
    "QHW at packets",
    "best QGHW",
    "QGHW at packets",
    *(f"{cache} cache hits gained" for cache in figures.CACHES.values()),
    QUARTER,
    *SPEED_UPS.values(),
    HALF,
    *(f"{index} of {MANY} pipelines" for index in INDICES),
)
# The thesis's, of its scenes Gael and conference.
THESIS = {
    "best QHW": "about 9.5",
    "QHW at packets": "32",
    "QGHW at packets": "32",
    "list cache hits gained": "10 to 20",
    "matrix cache hits gained": "10 to 20",
    QUARTER: "about 20, conference far more",
    HALF: "more than 1",
}


def of(report: Json) -> list[Json]:
    """A row for each scene and configuration that has curves; what is missing is None."""
    return [
        {"scene": scene, "configuration": name, **row_of(report["runs"], scene, name, one)}
        for scene in report["scenes"]
        for name, one in report["configurations"].items()
        if one["curves"]
    ]


def slower(configuration: Json, times: int) -> Point:
    """The key of the core whose memory has this part of the bandwidth."""
    if is_behind_port(configuration):
        return {"port_bytes": points.own_value(configuration, "port_bytes") // times}
    return {"memory_clocks": times * points.own_value(configuration, "memory_clocks")}


def row_of(runs: list[Json], scene: str, name: str, configuration: Json) -> Json:
    mine = [r for r in runs if (r["scene"], r["configuration"]) == (scene, name)]
    own = points.own_point(configuration)

    def at(change: Point) -> Json | None:
        return next((r for r in mine if r["flags"] == {**own, **change}), None)

    found: Json = dict.fromkeys(COLUMNS)
    # The thesis's figures over packets are with all lines.
    along = [r for r in mine if r["flags"] == {**own, "packets": r["flags"].get("packets")}]
    for index in INDICES:
        known = [r for r in along if r.get(index) is not None]
        if len(known) > 1:
            best = max(known, key=operator.itemgetter(index))
            found[f"best {index}"] = best[index]
            found[f"{index} at packets"] = best["flags"]["packets"]
    if (morton := at({})) and (scanline := at(SCANLINE)):
        for key in (f"{cache} cache hits" for cache in figures.CACHES.values()):
            found[f"{key} gained"] = morton[key] - scanline[key]
    if not (one := at(WITHOUT_HITS)):
        return found
    if quarter := at({**WITHOUT_HITS, **slower(configuration, 4)}):
        found[QUARTER] = 100 * (1 - quarter[figures.RATE] / one[figures.RATE])
    two, half = (
        at({**WITHOUT_HITS, **change}) for change in ({"pipelines": 2}, slower(configuration, 2))
    )
    if two and half:
        found[HALF] = two[figures.RATE] / (2 * half[figures.RATE])
    for number, column in SPEED_UPS.items():
        if several := at({**WITHOUT_HITS, "pipelines": number}):
            found[column] = several[figures.RATE] / one[figures.RATE]
            for index in INDICES if number == MANY else ():
                found[f"{index} of {MANY} pipelines"] = several.get(index)
    return found
