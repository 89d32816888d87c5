# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The four kinds of scene that the thesis measures, on our RTL, beside its frame rates."""

import dataclasses
import os

from dynrt_tools.bench.run import Dynrt, Work, busiest, rays, read_bytes, written_bytes
from dynrt_tools.command import Pool
from dynrt_tools.hardware.placed_clocks import THESIS_MHZ, frames_per_second, of, rate_text
from dynrt_tools.project import Json, Progress

# The thesis's typical frame rates at 512x384 and THESIS_MHZ (chapter 10) of scenes like these; for its
# Gael, a game level, stands `cistern`.
THESIS = {"office": (20, 30), "cistern": (17, 25), "conference": (17, 20), "trees4000": (8, 14)}

# The largest core that the thesis simulates, and the fastest of this project.
RUNS = tuple((scene, config) for scene in THESIS for config in ("full", "fast"))

MEMORY = "memory_interface"
FULL = 0.9  # of the clocks: a unit that works more has next to nothing to wait for
STALLED = 0.01  # of the clocks: what is less is not worth a word


@dataclasses.dataclass
class Measured:
    scene: str
    config: str
    frame: Json
    compared: bool  # the size and so the frame rate are the thesis's

    @property
    def beside_thesis(self) -> float:
        """Frames per second at the thesis's clock."""
        return frames_per_second(self.frame["cycles"], THESIS_MHZ)

    @property
    def placed(self) -> str:
        """Frames per second at the placed clock; in brackets if it is that of another core."""
        return rate_text(self.frame["cycles"], self.config, ".2f")

    @property
    def verdict(self) -> str:
        low, high = THESIS[self.scene]
        if not self.compared:
            return "-"
        return (
            "above"
            if self.beside_thesis > high
            else "within"
            if self.beside_thesis >= low
            else "below"
        )

    def figures(self) -> Json:
        """The rows of the table, as numbers that can be kept as data."""
        work, (name, transactions) = Work.of(self.frame), busiest(self.frame)
        low, high = THESIS[self.scene]
        rows = {
            "clocks per frame": self.frame["cycles"],
            "clocks per frame, bound": work.bound(),
            "frames per second, placed": self.placed,
            f"frames per second at {THESIS_MHZ} MHz": round(self.beside_thesis, 2),
            "thesis": f"{low} to {high}",
            "beside the thesis": self.verdict,
            "rays per clock": round(rays(self.frame) / self.frame["cycles"], 4),
            "busiest unit": name,
            "works, % of the clocks": round(100 * transactions / self.frame["cycles"], 1),
        }
        for figure in ("nodes", "list_entries", "objects", "triangles"):
            each = work.per_packet(figure)
            rows[f"{figure.replace('_', ' ')} per packet"] = "-" if each is None else round(each, 2)
        for cache, counts in self.frame["caches"].items():
            rows[f"{cache} cache hits, %"] = round(100 * counts["hit_rate"], 2)
        rows["bytes read per ray"] = round(read_bytes(self.frame) / rays(self.frame), 2)
        rows["bytes written per ray"] = round(written_bytes(self.frame) / rays(self.frame), 2)
        return rows

    def waits(self) -> str:
        """The bound of the speed: the work itself, or lines that come from memory."""
        units = self.frame["units"]
        (name, transactions), work = busiest(self.frame), Work.of(self.frame)
        share = transactions / self.frame["cycles"]
        text = (
            f"{name} works in {100 * share:.1f} % of the clocks, "
            f"{transactions / work.packets:.0f} times for each packet"
        )
        if name == MEMORY:
            text += (
                "; all others wait for lines that the caches do not hold, which larger ones or rays "
                "closer together would mend"
            )
        elif share >= FULL:
            text += (
                "; it waits for nothing, so only less of that work, or more of it done a "
                "clock, would be faster"
            )
        else:
            text += (
                ", and otherwise waits for packets that are elsewhere; the memory serves "
                f"cache misses in {100 * units[MEMORY]['utilisation']:.1f} %"
            )
        stalled = [
            f"{unit} {100 * counts['stalled']:.1f} %"
            for unit, counts in units.items()
            if counts["stalled"] >= STALLED
        ]
        return text + (
            f"; held up for want of room behind them: {', '.join(stalled)}" if stalled else ""
        )

    def data(self) -> Json:
        return {
            "scene": self.scene,
            "configuration": self.config,
            **self.figures(),
            "waits": self.waits(),
            "frame": self.frame,
        }


def measure(dynrt: Dynrt, size: str, full_size: str, progress: Progress) -> list[Measured]:
    """All scenes, as many at a time as there are cores, which the clocks do not depend on."""

    def one(run: tuple[str, str]) -> Measured:
        scene, config = run
        return Measured(
            scene, config, dynrt.render(scene, "rtl", config, size).frame, size == full_size
        )

    progress(f"rtl, {size}: {', '.join(THESIS)}")
    with Pool(os.cpu_count()) as pool:
        # The longest first; the order of the table is the thesis's.
        return list(pool.map(one, reversed(RUNS)))[::-1]


def _text(value: float | str) -> str:
    if isinstance(value, float):
        return f"{value:,.4f}" if value < 1 else f"{value:,.2f}"
    return f"{value:,}" if isinstance(value, int) else value


def table(measured: list[Measured]) -> str:
    """Scenes as columns; below the figures, how busy each unit is."""
    rows = [("", *(m.scene for m in measured)), ("configuration", *(m.config for m in measured))]
    figures = [m.figures() for m in measured]
    rows += [(name, *(_text(f[name]) for f in figures)) for name in figures[0]]
    rows.append(("unit works, % of the clocks", *("" for _ in measured)))
    busy = [
        {unit: counts["utilisation"] for unit, counts in m.frame["units"].items()} for m in measured
    ]
    units = sorted(
        {unit for of in busy for unit in of},
        key=lambda unit: (-max(of.get(unit, 0) for of in busy), unit),
    )
    rows += [
        (f"  {unit}", *(f"{100 * of[unit]:.1f}" if unit in of else "-" for of in busy))
        for unit in units
    ]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = [
        f"{row[0]:<{widths[0]}}"
        + "".join(f"  {cell:>{width}}" for cell, width in zip(row[1:], widths[1:]))
        for row in rows
    ]
    return "\n".join(line.rstrip() for line in lines)


def report(measured: list[Measured]) -> str:
    """The table, and a sentence for every scene that is not above the thesis's range."""
    clocks = {of(m.config).of_core(m.config): None for m in measured}
    lines = [table(measured), "", *(f"Frames per second, placed: {text}." for text in clocks)]
    lines += [
        f"\n{m.scene}, {m.config}, {m.verdict} the thesis's range: {m.waits()}."
        for m in measured
        if m.verdict in ("within", "below")
    ]
    return "\n".join(lines)
