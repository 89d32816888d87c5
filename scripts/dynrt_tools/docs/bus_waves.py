# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The timing diagrams of the buses of rtl/bus, as WaveDrom's JSON: accesses to the memory and to the
registers. A test runs the Verilog with a diagram's inputs and compares its outputs."""

from dynrt_tools.docs.waves import Diagram

# Its blanks keep room beside the channels: WaveDrom takes names to be narrower than some fonts are.
CLOCK = "\u00a0" * 20 + "clk_i"
Lane = tuple[str, ...]  # name, wave and, if it has any, what its values are called


def _lanes(*lanes: Lane) -> list[Diagram]:
    signals: list[Diagram] = []
    for name, wave, *values in lanes:
        signals.append({"name": name, "wave": wave})
        if values:
            signals[-1]["data"] = values[0].split()
    return signals


def _group(name: str, *lanes: Lane) -> list[object]:
    """A channel."""
    return [name, *_lanes(*lanes)]


def _diagram(clocks: int, *signals: object) -> Diagram:
    """A diagram whose clocks are wide enough for what the values are called."""
    clock = {"name": CLOCK, "wave": "p" + "." * (clocks - 1)}
    return {"signal": [clock, *signals], "config": {"hscale": 2}, "foot": {"tick": 0}}


def _axi() -> Diagram:
    return _diagram(
        10,
        _group(
            "AR",
            ("arvalid", "01..0....."),
            ("arready", "0.1......."),
            ("araddr", "x3.4x.....", "A B"),
            ("arid", "x3.4x.....", "7 9"),
        ),
        _group(
            "R",
            ("rvalid", "0....1.0.."),
            ("rready", "1........."),
            ("rid", "x....43x..", "9 7"),
            ("rdata", "x....4x...", "b"),
            ("rresp", "x....43x..", "0 2"),
        ),
        _group(
            "AW",
            ("awvalid", "01....0..."),
            ("awready", "0.10.10..."),
            ("awaddr", "x5.6..x...", "C D"),
            ("awlen", "x5.6..x...", "0 0"),
        ),
        _group(
            "W",
            ("wvalid", "01..0....."),
            ("wready", "0.1..0...."),
            ("wdata", "x5.6x.....", "c d"),
            ("wstrb", "x5.6x.....", "ff ffff"),
            ("wlast", "x1..x....."),
        ),
        _group(
            "B",
            ("bvalid", "0....10.10"),
            ("bready", "1........."),
            ("bresp", "x....5x.6x", "0 2"),
        ),
    )


def _wishbone() -> Diagram:
    return _diagram(
        11,
        *_lanes(
            ("cyc_o", "0.1......0."),
            ("stb_o", "0.1...0...."),
            ("stall_i", "0..10......"),
            ("we_o", "x.0..1x...."),
            ("adr_o", "x.34.5x....", "A A+4 C"),
            ("sel_o", "x.34.5x....", "f f f"),
            ("dat_o", "x....5x....", "c"),
            ("ack_i", "0....10.10."),
            ("err_i", "0.....10..."),
            ("dat_i", "x....3x....", "a"),
        ),
    )


def _axi_lite() -> Diagram:
    return _diagram(
        16,
        _group(
            "AW",
            ("awvalid", "010............."),
            ("awready", "1.01............"),
            ("awaddr", "x5x.............", "100"),
        ),
        _group(
            "W",
            ("wvalid", "010............."),
            ("wready", "1.01............"),
            ("wdata", "x5x.............", "40"),
            ("wstrb", "x5x.............", "f"),
        ),
        _group(
            "B",
            ("bvalid", "0..10..........."),
            ("bready", "1..............."),
            ("bresp", "x..5x...........", "0"),
        ),
        _group(
            "AR",
            ("arvalid", "0..10......10..."),
            ("arready", "1...01......01.."),
            ("araddr", "x..3x......4x...", "000 ffc"),
        ),
        _group(
            "R",
            ("rvalid", "0.........10.10."),
            ("rready", "1..............."),
            ("rdata", "x.........3x....", "ID"),
            ("rresp", "x.........3x.4x.", "0 2"),
        ),
    )


def _wishbone_registers() -> Diagram:
    return _diagram(
        16,
        *_lanes(
            ("cyc_i", "01.............0"),
            ("stb_i", "01...0......10.."),
            ("stall_o", "0.1.01......01.0"),
            ("we_i", "x10..x......0x.."),
            ("adr_i", "x53..x......4x..", "100 000 ffc"),
            ("dat_i", "x5x.............", "40"),
            ("sel_i", "x53..x......4x..", "f f f"),
            ("ack_o", "0..10......10..."),
            ("err_o", "0.............10"),
            ("dat_o", "x..........3x...", "ID"),
        ),
    )


def diagrams() -> dict[str, Diagram]:
    """By the picture's name."""
    return {
        "bus_axi": _axi(),
        "bus_wishbone": _wishbone(),
        "bus_axi_lite": _axi_lite(),
        "bus_wishbone_registers": _wishbone_registers(),
    }
