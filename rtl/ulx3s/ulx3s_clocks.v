// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks of the ULX3S, made by one PLL of the oscillator of 25 MHz, whose own runs at 500 MHz:
// 125 MHz for the DVI link, five times a pixel's, 100 MHz for the SDRAM and 62.5 MHz for the core. The
// SDRAM's pin gets its clock three quarters of a period late (ulx3s_board.v).
// The resets are released in step with them once the PLL has locked; parts of the board that lie far
// from each other have their own.
`default_nettype none

module ulx3s_clocks (
  input  wire osc_i,  // 25 MHz
  input  wire rst_ni, // may change at any time
  output wire clk_o,  // of the core
  output wire host_rst_no,
  output wire core_rst_no,
  output wire memory_rst_no,
  output wire display_rst_no,
  output wire sdram_clk_o,
  output wire sdram_pin_clk_o,
  output wire sdram_rst_no,
  output wire dvi_clk_o,
  output wire dvi_rst_no
);

  wire locked;

  EHXPLLL #(
    .CLKI_DIV(1), .CLKFB_DIV(5), .FEEDBK_PATH("CLKOP"),
    .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(4), .CLKOP_CPHASE(3),
    .CLKOS_ENABLE("ENABLED"), .CLKOS_DIV(8), .CLKOS_CPHASE(7),
    .CLKOS2_ENABLE("ENABLED"), .CLKOS2_DIV(5), .CLKOS2_CPHASE(4),
    .CLKOS3_ENABLE("ENABLED"), .CLKOS3_DIV(5), .CLKOS3_CPHASE(7), .CLKOS3_FPHASE(6)
  ) pll (
    .CLKI(osc_i), .CLKFB(dvi_clk_o), .CLKOP(dvi_clk_o), .CLKOS(clk_o), .CLKOS2(sdram_clk_o),
    .CLKOS3(sdram_pin_clk_o), .LOCK(locked),
    .RST(1'b0), .STDBY(1'b0), .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0), .ENCLKOS(1'b0), .ENCLKOS2(1'b0),
    .ENCLKOS3(1'b0), .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b0), .PHASESTEP(1'b0),
    .PHASELOADREG(1'b0), .INTLOCK(), .REFCLK(), .CLKINTFB()
  );

  hls_reset #(.PARTS(4)) reset (
    .clk_i(clk_o), .rst_ni(rst_ni && locked),
    .rst_no({host_rst_no, core_rst_no, memory_rst_no, display_rst_no})
  );
  hls_reset sdram_reset (
    .clk_i(sdram_clk_o), .rst_ni(rst_ni && locked), .rst_no(sdram_rst_no)
  );
  hls_reset dvi_reset (.clk_i(dvi_clk_o), .rst_ni(rst_ni && locked), .rst_no(dvi_rst_no));

endmodule

`default_nettype wire
