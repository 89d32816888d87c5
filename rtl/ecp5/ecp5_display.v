// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The display of a board with an ECP5, from the core's clock to the pins of a DVI link; see
// display_dvi for its ports.
//
//   PIXEL_MHZ     25: 640x480, or 40: 800x600 (both at 60 Hz); config_i has to agree
`default_nettype none

module ecp5_display #(
  parameter PIXEL_MHZ = 25
) (
  input  wire         clk_i,
  input  wire         rst_ni,
  input  wire         osc_i,   // 25 MHz
  input  wire         on_i,
  input  wire [447:0] config_i,
  output wire         running_o,
  output wire [19:0]  shown_o,
  output wire         begins_o,
  output wire [19:0]  base_o,
  output wire [31:0]  frames_o,
  output wire         starved_o,
  output wire         bank_en_o,
  output wire [19:0]  bank_addr_o,
  input  wire [31:0]  bank_data_i,
  // pins: clock, red, green, blue
  output wire [3:0]   dvi_p_o,
  output wire [3:0]   dvi_n_o
);

  wire       dvi_clk, dvi_rst_n, locked_unused;
  wire [3:0] first, second;

  ecp5_dvi_clock #(.PIXEL_MHZ(PIXEL_MHZ)) clock (
    .osc_i(osc_i), .rst_ni(rst_ni), .clk_o(dvi_clk), .rst_no(dvi_rst_n), .locked_o(locked_unused)
  );

  display_dvi display (
    .clk_i(clk_i), .rst_ni(rst_ni), .on_i(on_i), .config_i(config_i), .running_o(running_o),
    .shown_o(shown_o), .begins_o(begins_o), .base_o(base_o), .frames_o(frames_o),
    .starved_o(starved_o), .bank_en_o(bank_en_o), .bank_addr_o(bank_addr_o),
    .bank_data_i(bank_data_i), .dvi_clk_i(dvi_clk), .dvi_rst_ni(dvi_rst_n), .dvi_first_o(first),
    .dvi_second_o(second)
  );

  ecp5_dvi_pins pins (
    .clk_i(dvi_clk), .rst_ni(dvi_rst_n), .first_i(first), .second_i(second), .dvi_p_o(dvi_p_o),
    .dvi_n_o(dvi_n_o)
  );

endmodule

`default_nettype wire
