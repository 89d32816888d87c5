# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The timing diagrams of the buses of rtl/bus: a read and a write of the memory, as WaveDrom's JSON."""

from dynrt_tools.docs.waves import Diagram


def _group(name: str, *lanes: tuple[str, ...]) -> list[object]:
    """A channel; of a lane its name, its wave and, if it has any, what its values are called."""
    signals: list[Diagram] = []
    for lane, wave, *values in lanes:
        signals.append({"name": lane, "wave": wave})
        if values:
            signals[-1]["data"] = values[0].split()
    return [name, *signals]


def diagrams() -> dict[str, Diagram]:
    """By the picture's name."""
    clock = {"name": "clk_i", "wave": "p..........."}
    axi = [
        clock,
        _group(
            "AR",
            ("arvalid", "01.0........"),
            ("arready", "0.10........"),
            ("araddr", "x3.x........", "A"),
            ("arid", "x3.x........", "7"),
        ),
        _group(
            "R",
            ("rvalid", "0....10....."),
            ("rready", "1..........."),
            ("rid", "x....3x.....", "7"),
            ("rdata", "x....3x.....", "node"),
        ),
        _group(
            "AW",
            ("awvalid", "0.1.0......."),
            ("awready", "0..10......."),
            ("awaddr", "x.4.x.......", "B"),
            ("awlen", "x.4.x.......", "1"),
        ),
        _group(
            "W",
            ("wvalid", "0.1...0....."),
            ("wready", "0.10.10....."),
            ("wdata", "x.45..x.....", "B B+1"),
            ("wlast", "x.01..x....."),
        ),
        _group("B", ("bvalid", "0.......10.."), ("bready", "1...........")),
    ]
    wishbone = [
        clock,
        {"name": "cyc", "wave": "01........0."},
        {"name": "stb", "wave": "01...0......"},
        {"name": "stall", "wave": "0.10........"},
        {"name": "we", "wave": "x0..1x......"},
        {"name": "adr", "wave": "x34.5x......", "data": ["A", "A+4", "B"]},
        {"name": "ack", "wave": "0....1.0.10."},
        {"name": "dat (read)", "wave": "x....34x....", "data": ["A", "A+4"]},
    ]
    return {"bus_axi": {"signal": axi}, "bus_wishbone": {"signal": wishbone}}
