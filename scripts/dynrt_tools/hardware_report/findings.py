# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the curves of a report say that the thesis's text says of its own: where the indices are best,
what the Morton curve gains over scanlines, what a slower memory costs and several pipelines bring."""

import operator

from dynrt_tools.hardware_report import figures, points
from dynrt_tools.hardware_report.figure import SCANLINE, WITHOUT_HITS, Point, is_behind_port
from dynrt_tools.project import Json

QUARTER = "lost at a quarter of the bandwidth"
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
}


def of(report: Json) -> list[Json]:
    """A row for each scene and configuration that has curves; what is missing is None."""
    return [
        {"scene": scene, "configuration": name, **row_of(report["runs"], scene, name, one)}
        for scene in report["scenes"]
        for name, one in report["configurations"].items()
        if one["curves"]
    ]


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
    slow = {"memory_clocks": 4 * points.own_value(configuration, "memory_clocks")}
    if is_behind_port(configuration):
        slow = {"port_bytes": points.own_value(configuration, "port_bytes") // 4}
    if quarter := at({**WITHOUT_HITS, **slow}):
        found[QUARTER] = 100 * (1 - quarter[figures.RATE] / one[figures.RATE])
    for number, column in SPEED_UPS.items():
        if several := at({**WITHOUT_HITS, "pipelines": number}):
            found[column] = several[figures.RATE] / one[figures.RATE]
            for index in INDICES if number == MANY else ():
                found[f"{index} of {MANY} pipelines"] = several.get(index)
    return found
