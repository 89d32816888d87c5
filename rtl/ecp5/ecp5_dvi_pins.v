// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The pins of a DVI link on an ECP5: each of the eight wires of the four pairs by a cell of double
// data rate, those of a pair with the bits of each other's complement. Both wires of a pair change
// at the same edge of the clock, as they come from the same kind of cell.
`default_nettype none

module ecp5_dvi_pins (
  input  wire       clk_i,
  input  wire       rst_ni,
  // of the serialiser: clock, red, green, blue
  input  wire [3:0] first_i,
  input  wire [3:0] second_i,
  output wire [3:0] dvi_p_o,
  output wire [3:0] dvi_n_o
);

  genvar i;
  generate
    for (i = 0; i < 4; i = i + 1) begin : pair
      ODDRX1F p (.SCLK(clk_i), .RST(!rst_ni), .D0(first_i[i]), .D1(second_i[i]), .Q(dvi_p_o[i]));
      ODDRX1F n (.SCLK(clk_i), .RST(!rst_ni), .D0(!first_i[i]), .D1(!second_i[i]), .Q(dvi_n_o[i]));
    end
  endgenerate

endmodule

`default_nettype wire
