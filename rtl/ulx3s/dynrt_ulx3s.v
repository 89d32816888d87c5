// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Top for an ULX3S with LFE5U-85F (constraints/ulx3s.lpf): ulx3s_board, the pads of the SDRAM's data,
// which go both ways, and the pin by which the board's ESP32 would begin to load its flash.
`default_nettype none

module dynrt_ulx3s #(
  parameter [7:0] PIXEL_MHZ = 8'd25 // or 40, see ulx3s_board.v
) (
  input  wire        clk_25mhz_i,
  input  wire        button_ni,
  input  wire        serial_i,
  output wire        serial_o,
  output wire [7:0]  led_o,
  output wire        sdram_clk_o,
  output wire        sdram_cke_o,
  output wire        sdram_cs_no,
  output wire        sdram_ras_no,
  output wire        sdram_cas_no,
  output wire        sdram_we_no,
  output wire [1:0]  sdram_bank_o,
  output wire [12:0] sdram_addr_o,
  output wire [1:0]  sdram_dqm_o,
  inout  wire [15:0] sdram_dq_io,
  output wire [3:0]  dvi_p_o,
  output wire [3:0]  dvi_n_o,
  output wire        wifi_gpio0_o
);

  assign wifi_gpio0_o = 1'b1; // while it is low and the ESP32 starts, that waits for a program

  wire [15:0] floats, dq, pads;
  genvar i;
  generate
    for (i = 0; i < 16; i = i + 1) begin : data
      BB pad (.B(sdram_dq_io[i]), .I(dq[i]), .T(floats[i]), .O(pads[i]));
    end
  endgenerate

  ulx3s_board #(.PIXEL_MHZ(PIXEL_MHZ)) board (
    .clk_25mhz_i(clk_25mhz_i), .button_ni(button_ni), .serial_i(serial_i), .serial_o(serial_o),
    .led_o(led_o), .sdram_clk_o(sdram_clk_o), .sdram_cke_o(sdram_cke_o),
    .sdram_cs_no(sdram_cs_no), .sdram_ras_no(sdram_ras_no), .sdram_cas_no(sdram_cas_no),
    .sdram_we_no(sdram_we_no), .sdram_bank_o(sdram_bank_o), .sdram_addr_o(sdram_addr_o),
    .sdram_dqm_o(sdram_dqm_o), .sdram_dq_float_o(floats), .sdram_dq_o(dq), .sdram_dq_i(pads),
    .dvi_p_o(dvi_p_o), .dvi_n_o(dvi_n_o)
  );

endmodule

`default_nettype wire
