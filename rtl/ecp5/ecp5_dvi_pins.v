// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The pins of a DVI link on an ECP5: each of the eight wires of the four pairs by a cell of double
// data rate, those of a pair with the bits of each other's complement. Both wires of a pair change
// at the same edge of the clock, as they come from the same kind of cell. The pins lie at the chip's
// edge and the serialiser may not, so their bits and the reset take three clocks on the way.
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

  (* keep *) reg [8:0] leaving_q, near_q;
  reg       reset_q;
  reg [3:0] p_first_q, p_second_q, n_first_q, n_second_q;
  (* keep *) always @(posedge clk_i) begin
    leaving_q <= {!rst_ni, first_i, second_i};
    near_q <= leaving_q;
    {reset_q, p_first_q, p_second_q} <= near_q;
    {n_first_q, n_second_q} <= ~near_q[7:0];
  end

  genvar i;
  generate
    for (i = 0; i < 4; i = i + 1) begin : pair
      ODDRX1F p (
        .SCLK(clk_i), .RST(reset_q), .D0(p_first_q[i]), .D1(p_second_q[i]), .Q(dvi_p_o[i])
      );
      ODDRX1F n (
        .SCLK(clk_i), .RST(reset_q), .D0(n_first_q[i]), .D1(n_second_q[i]), .Q(dvi_n_o[i])
      );
    end
  endgenerate

endmodule

`default_nettype wire
