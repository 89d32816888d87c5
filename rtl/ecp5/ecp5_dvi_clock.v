// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clock of a DVI link on an ECP5: five times that of the pixels, made by a PLL from an
// oscillator of 25 MHz. The reset is released in step with it once the PLL has locked.
//
//   PIXEL_MHZ     25: 640x480, or 40: 800x600 (both at 60 Hz)
`default_nettype none

module ecp5_dvi_clock #(
  parameter PIXEL_MHZ = 25
) (
  input  wire osc_i,  // 25 MHz
  input  wire rst_ni, // may change at any time
  output wire clk_o,
  output wire rst_no,
  output wire locked_o
);

  // The PLL's oscillator runs at 500 or 600 MHz, in the middle of its range.
  localparam FEEDBACK = PIXEL_MHZ * 5 / 25;
  localparam OUTPUT = 600 / (PIXEL_MHZ * 5);

  generate
    if (PIXEL_MHZ != 25 && PIXEL_MHZ != 40) begin : bad_clock
      ecp5_dvi_clock_PIXEL_MHZ_must_be_25_or_40 stop ();
    end
  endgenerate

  EHXPLLL #(
    .CLKI_DIV(1), .CLKFB_DIV(FEEDBACK), .FEEDBK_PATH("CLKOP"),
    .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(OUTPUT), .CLKOP_CPHASE(OUTPUT - 1)
  ) pll (
    .CLKI(osc_i), .CLKFB(clk_o), .CLKOP(clk_o), .LOCK(locked_o),
    .RST(1'b0), .STDBY(1'b0), .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0), .ENCLKOS(1'b0), .ENCLKOS2(1'b0),
    .ENCLKOS3(1'b0), .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b0), .PHASESTEP(1'b0),
    .PHASELOADREG(1'b0), .CLKOS(), .CLKOS2(), .CLKOS3(), .INTLOCK(), .REFCLK(), .CLKINTFB()
  );

  hls_reset reset (.clk_i(clk_o), .rst_ni(rst_ni && locked_o), .rst_no(rst_no));

endmodule

`default_nettype wire
