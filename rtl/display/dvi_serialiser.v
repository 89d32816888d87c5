// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Serialiser of a DVI link: sends the ten bits of a character in five clocks, two bits in each, the
// lowest first. clk_i is five times the clock of the pixels, which needs no net of its own: it
// leaves on the fourth pair, high for the first half of each character. A display waits for no
// one. If the next characters are not there in time, the three channels carry the character of
// silent syncs and starved_o stays high from then on; before the first characters they carry it, too.
`default_nettype none

module dvi_serialiser (
  input  wire        clk_i,
  input  wire        rst_ni,
  // a character of each channel: red, green, blue
  input  wire        valid_i,
  output wire        ready_o,
  input  wire [29:0] data_i,
  output wire        starved_o,
  // what each pair carries in the first and the second half of a clock: clock, red, green, blue
  output wire [3:0]  first_o,
  output wire [3:0]  second_o
);

  localparam [9:0] SILENT = 10'b1101010100;

  reg [4:0] place_q; // one bit: which pair of bits is being sent
  reg       running_q;
  reg       starved_q;
  reg [9:0] blue_q;
  reg [9:0] green_q;
  reg [9:0] red_q;

  wire      load = place_q[4];

  assign ready_o = load;
  assign starved_o = starved_q;
  assign first_o = {place_q[0] || place_q[1] || place_q[2], red_q[0], green_q[0], blue_q[0]};
  assign second_o = {place_q[0] || place_q[1], red_q[1], green_q[1], blue_q[1]};

  always @(posedge clk_i) begin
    place_q <= {place_q[3:0], place_q[4]};
    blue_q <= {2'b00, blue_q[9:2]};
    green_q <= {2'b00, green_q[9:2]};
    red_q <= {2'b00, red_q[9:2]};
    if (load) begin
      {red_q, green_q, blue_q} <= valid_i ? data_i : {3{SILENT}};
      running_q <= running_q || valid_i;
      starved_q <= starved_q || (running_q && !valid_i);
    end
    if (!rst_ni) begin
      place_q <= 5'b10000;
      running_q <= 1'b0;
      starved_q <= 1'b0;
    end
  end

endmodule

`default_nettype wire
