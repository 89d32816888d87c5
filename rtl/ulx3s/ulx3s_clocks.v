// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks of the ULX3S, made by one PLL of the oscillator of 25 MHz:
//
//   PIXEL_MHZ                           25         40
//   the PLL's own oscillator           500        600 MHz
//   DVI link, five times a pixel's     125        200 MHz
//   SDRAM                              100        100 MHz
//   core                                62.5       60 MHz
//
// The SDRAM's pin gets its clock three quarters of a period late (ulx3s_board.v).
// The resets are released in step with them once the PLL has locked; parts of the board that lie far
// from each other have their own. Those of the faster clocks take more clocks, so that all are low at
// once for four clocks of the core, as hls_clock_fifo asks.
`default_nettype none

module ulx3s_clocks #(
  parameter PIXEL_MHZ = 25
) (
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

  generate
    if (PIXEL_MHZ != 25 && PIXEL_MHZ != 40) begin : bad_clock
      ulx3s_clocks_PIXEL_MHZ_must_be_25_or_40 stop ();
    end
  endgenerate

  // In periods of the PLL's oscillator; LATE and eighths are three quarters of SDRAM.
  localparam FEEDBACK = PIXEL_MHZ == 25 ? 5 : 8;
  localparam DVI = PIXEL_MHZ == 25 ? 4 : 3;
  localparam SDRAM = PIXEL_MHZ == 25 ? 5 : 6;
  localparam CORE = PIXEL_MHZ == 25 ? 8 : 10;
  localparam LATE = PIXEL_MHZ == 25 ? 3 : 4;
  localparam LATE_EIGHTHS = PIXEL_MHZ == 25 ? 6 : 4;

  wire locked;

  EHXPLLL #(
    .CLKI_DIV(1), .CLKFB_DIV(FEEDBACK), .FEEDBK_PATH("CLKOP"),
    .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(DVI), .CLKOP_CPHASE(DVI - 1),
    .CLKOS_ENABLE("ENABLED"), .CLKOS_DIV(CORE), .CLKOS_CPHASE(CORE - 1),
    .CLKOS2_ENABLE("ENABLED"), .CLKOS2_DIV(SDRAM), .CLKOS2_CPHASE(SDRAM - 1),
    .CLKOS3_ENABLE("ENABLED"), .CLKOS3_DIV(SDRAM), .CLKOS3_CPHASE(SDRAM - 1 + LATE),
    .CLKOS3_FPHASE(LATE_EIGHTHS)
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
  hls_reset #(.CLOCKS(16)) sdram_reset (
    .clk_i(sdram_clk_o), .rst_ni(rst_ni && locked), .rst_no(sdram_rst_no)
  );
  hls_reset #(.CLOCKS(32)) dvi_reset (.clk_i(dvi_clk_o), .rst_ni(rst_ni && locked), .rst_no(dvi_rst_no));

endmodule

`default_nettype wire
