# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The clocks that a board's PLL makes, by the Verilog that sets it."""

import re

from dynrt_tools import project

ULX3S = project.ROOT / "rtl" / "ulx3s" / "ulx3s_clocks.v"
OSCILLATOR_MHZ = 25.0
# What an output of ulx3s_clocks.v is called within the top.
CORE, SDRAM, DVI = "board.clk", "board.sdram_clk", "board.dvi_clk"


def ulx3s() -> dict[str, float]:
    """In MHz, by the net within dynrt_ulx3s. CLKOP closes the PLL's loop, so the VCO runs at the
    oscillator's clock times both dividers of the loop."""
    text = ULX3S.read_text(encoding="utf-8")
    divided = {name: int(by) for name, by in re.findall(r"\.(CLK\w+)_DIV\((\d+)\)", text)}
    nets = dict(re.findall(r"\.(CLKO\w+)\((\w+)_o\)", text))
    vco = OSCILLATOR_MHZ / divided["CLKI"] * divided["CLKFB"] * divided["CLKOP"]
    return {f"board.{net}": vco / divided[output] for output, net in nets.items()}
