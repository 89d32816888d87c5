# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What a frame says of an SDRAM behind the port, each of core and SDRAM at its own clock, and the
budget of the memory's peak."""

from collections.abc import Mapping, Sequence

from dynrt_tools.experiments import frame as frames
from dynrt_tools.experiments.table import Variant
from dynrt_tools.hardware import board_clocks, placed_clocks
from dynrt_tools.project import Json

BYTES = 2  # that the SDRAM moves in a clock
SAFE = 0.85  # of the peak: no aim asks for more
SRAM, SHARE = "SRAM", "share of SRAM"  # the variant with banks, and the part of its frames
ASKED = {"office": 0.7, "cistern": 0.9, "conference": 0.65}  # of SHARE, of the first system
BOARD = "rtl/ulx3s"  # a clock in a table that the board's PLL makes


def mhz_of(stated: object, net: str) -> float:
    """A clock as a table states it: in MHz, that of a placed core, or that of the board."""
    if stated == BOARD:
        return board_clocks.ulx3s()[net]
    if isinstance(stated, str):
        return placed_clocks.of(stated.removeprefix("placed ")).mhz
    assert isinstance(stated, (int, float))
    return float(stated)


def core_mhz(variant: Variant) -> float:
    return mhz_of(variant.setting("core_mhz"), board_clocks.CORE)


def flags_of(variant: Variant) -> list[str]:
    """The clocks as the programs with the SDRAM take them."""
    if not variant.setting("core_mhz"):
        return []
    sdram = mhz_of(variant.setting("sdram_mhz"), board_clocks.SDRAM)
    return ["--core-mhz", f"{core_mhz(variant):g}", "--sdram-mhz", f"{sdram:g}"]


def figures_of(frame: Json, variant: Variant) -> Json:
    """The figures of a frame with the SDRAM."""
    sdram, mhz, count = frame["sdram"], core_mhz(variant), frames.rays(frame)
    seconds = frame["cycles"] / mhz / 1e6
    # Those of the port look a line that is on its way up again and again.
    others = {name: unit for name, unit in frame["units"].items() if "memory_" not in name}
    unit = frames.busiest(others)
    stalls = {name: float(unit_["stalled"]) for name, unit_ in frame["units"].items()}
    stalled = max(stalls, key=lambda name: stalls[name])
    moves, idle = sdram["busy"] / sdram["clocks"], sdram["idle"] / sdram["clocks"]
    peak = sdram["clocks"] * BYTES / seconds / 1e6
    kinds = ("node", "list", "matrix")
    bytes_of = {name: sdram[f"bytes_{name}"] for name in ("read", "written", "displayed")}
    return {
        "core_hz": mhz * 1e6,  # divided by the clocks: frames per second
        "bytes read per ray": sdram["bytes_read"] / count,
        **{f"{kind} bytes per ray": sdram[f"{kind}_bytes_read"] / count for kind in kinds},
        "bytes written per ray": sdram["bytes_written"] / count,
        **{f"MB per second {name}": n / seconds / 1e6 for name, n in bytes_of.items()},
        "share of the peak": moves,
        "waits for the core": idle,
        "waits for rows and turns": 1 - moves - idle,
        "rows opened per burst": sdram["activations"] / sdram["bursts"],
        "ns of a read": sdram["read_nanoseconds"] / sdram["reads"],
        "reads under way": sdram["read_nanoseconds"] / (seconds * 1e9),
        "busiest unit": unit,
        "use": 100 * others[unit]["utilisation"],
        "stalled unit": stalled,
        "stalled": 100 * stalls[stalled],
        "peak": peak,
        "refresh": peak * sdram["refreshes"] * sdram["refresh_clocks"] / sdram["clocks"],
    }


def budgets(rows: Sequence[Json], variants: Mapping[str, Variant]) -> list[Json]:
    """Of each system and scene, what the frame rate of SRAM would ask of the SDRAM."""
    rates = {row["scene"]: row["rays per clock"] for row in rows if row["variant"] == SRAM}
    systems = [n for n, v in variants.items() if v.setting("program") and not v.setting("size")]
    return [
        budget(
            row,
            rates[row["scene"]],
            ASKED.get(row["scene"]) if row["variant"] == systems[0] else None,
        )
        for row in rows
        if row["variant"] in systems and row["scene"] in rates
    ]


def budget(row: Json, rays_per_clock: float, asked: float | None) -> Json:
    """In MB/s, and the aim that this leaves."""
    rays_per_second = rays_per_clock * row["core_hz"]
    read = row["bytes read per ray"] * rays_per_second / 1e6
    written = row["bytes written per ray"] * rays_per_second / 1e6
    fixed = row["MB per second displayed"] + row["refresh"]
    reachable = min(1, (SAFE * row["peak"] - fixed) / (read + written))
    aim = None if asked is None else min(asked, reachable)
    return {
        "variant": row["variant"],
        "scene": row["scene"],
        "read": read,
        "written": written,
        "displayed": row["MB per second displayed"],
        "refresh": row["refresh"],
        "sum": read + written + fixed,
        "peak": row["peak"],
        "of the peak": (read + written + fixed) / row["peak"],
        "reachable": reachable,
        "asked": asked,
        "aim": aim,
        "reached": row[SHARE],
        "verdict": "no aim" if aim is None else "reached" if row[SHARE] >= aim else "missed",
    }


def text(budget_rows: Sequence[Json]) -> str:
    lines = ["MB/s that the frame rate of SRAM asks for, and the share of it that is reached:"]
    for row in budget_rows:
        parts = ", ".join(
            f"{row[part]:.0f} {part}" for part in ("read", "written", "displayed", "refresh", "sum")
        )
        aim = "no aim" if row["aim"] is None else f"aim {row['aim']:.1%}: {row['verdict']}"
        lines.append(
            f"{row['variant']}, {row['scene']}: {parts}, {row['of the peak']:.1%} of the peak; "
            f"{row['reached']:.1%} of the frames, {aim}"
        )
    return "\n".join(lines)
