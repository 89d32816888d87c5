# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The clocks that a board's PLL makes, by the Verilog that sets it."""

import re

from dynrt_tools import project

ULX3S = project.ROOT / "rtl" / "ulx3s" / "ulx3s_clocks.v"
OSCILLATOR_MHZ = 25.0
# The modes of displays, and in MHz the clock of their pixels on a DVI link.
MODES = project.ROOT / "host" / "board" / "display_mode.h"
MODE = re.compile(r'\{"(\d+x\d+)", \{.*\}, [\d.]+, (\d+)\}')
# What an output of ulx3s_clocks.v is called within the top.
CORE, SDRAM, DVI = "board.clk", "board.sdram_clk", "board.dvi_clk"


# In ulx3s_clocks.v, a divider that depends on the display's mode.
DIVIDER = re.compile(r"localparam (\w+) = PIXEL_MHZ == 25 \? (\d+) : (\d+);")


def modes() -> dict[str, int]:
    """By their names."""
    return {name: int(mhz) for name, mhz in MODE.findall(MODES.read_text(encoding="utf-8"))}


def ulx3s(pixel_mhz: int = 25) -> dict[str, float]:
    """In MHz, by the net within dynrt_ulx3s. CLKOP closes the PLL's loop, so the VCO runs at the
    oscillator's clock times both dividers of the loop."""
    text = ULX3S.read_text(encoding="utf-8")
    at = {name: int(a if pixel_mhz == 25 else b) for name, a, b in DIVIDER.findall(text)}
    divided = {
        name: at[by] if by in at else int(by)
        for name, by in re.findall(r"\.(CLK\w+)_DIV\((\w+)\)", text)
    }
    nets = dict(re.findall(r"\.(CLKO\w+)\((\w+)_o\)", text))
    vco = OSCILLATOR_MHZ / divided["CLKI"] * divided["CLKFB"] * divided["CLKOP"]
    return {f"board.{net}": vco / divided[output] for output, net in nets.items()}
