// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The display on a DVI link: the unit scan_out gives pixels as fast as the link takes them, the
// unit tmds_encoder makes characters of them, a FIFO brings these to the clock of the link, and the
// serialiser sends them. So the link alone keeps time, and both units work in the core's clock,
// which must be faster than that of the pixels. Switched off, everything is held in reset, for
// OFF_CLOCKS at least, so that both sides of the FIFO see it.
//
// bank_en_o takes the next pixel of the picture, whose word must be there BANK_LATENCY clocks later
// (3, as scan_out is lowered), from a bank or from picture_stream.
`default_nettype none

module display_dvi #(
  parameter OFF_CLOCKS = 32
) (
  input  wire         clk_i,
  input  wire         rst_ni,
  input  wire         on_i,
  input  wire [447:0] config_i,  // ScanConfig of hls/units/scan_out.h
  output wire         running_o, // low while it is switched off, or was not yet long enough
  output wire [19:0]  shown_o,   // base of the picture that is being shown, or is in this blank
  output wire         begins_o,  // a vertical blank begins, and the picture at shown_data_o next
  output wire [19:0]  base_o,
  output wire [31:0]  frames_o,  // vertical blanks since it was switched on
  output wire         starved_o, // the link has waited for a pixel since it was switched on
  output wire         bank_en_o,
  output wire [19:0]  bank_addr_o,
  input  wire [31:0]  bank_data_i,
  // link: its clock is five times that of the pixels
  input  wire         dvi_clk_i,
  input  wire         dvi_rst_ni,
  output wire [3:0]   dvi_first_o,
  output wire [3:0]   dvi_second_o
);

  localparam COUNT_BITS = $clog2(OFF_CLOCKS + 1);

  reg [COUNT_BITS-1:0] off_q; // clocks that it still has to be off
  reg        running_q;
  reg        first_q;
  reg [19:0] shown_q;
  reg [31:0] frames_q;

  wire        tick_ready;
  wire        pixel_valid, pixel_ready;
  wire [26:0] pixel;
  wire        shown_valid;
  wire [19:0] shown;
  wire        characters_valid, characters_ready;
  wire [29:0] characters;
  wire        crossing_rst_n, waiting_rst_n, sending_rst_n;
  wire        crossed_valid, crossed_ready, dvi_valid, dvi_ready, dvi_starved;
  wire [29:0] crossed, dvi_characters;

  assign running_o = running_q;
  assign shown_o = shown_q;
  assign frames_o = frames_q;
  assign begins_o = shown_valid;
  assign base_o = shown;

  always @(posedge clk_i) begin
    running_q <= on_i && off_q == {COUNT_BITS{1'b0}};
    if (off_q != {COUNT_BITS{1'b0}}) off_q <= off_q - {{(COUNT_BITS - 1){1'b0}}, 1'b1};
    if (tick_ready) first_q <= 1'b0;
    if (shown_valid) begin
      shown_q <= shown;
      frames_q <= frames_q + 32'd1;
    end
    if (!running_q) begin
      first_q <= 1'b1;
      shown_q <= 20'd0;
      frames_q <= 32'd0;
    end
    if (!rst_ni || (running_q && !on_i)) begin
      running_q <= 1'b0;
      off_q <= OFF_CLOCKS[COUNT_BITS-1:0];
    end
  end

  scan_out u_scan_out (
    .clk_i(clk_i), .rst_ni(running_q),
    .tick_valid_i(running_q), .tick_ready_o(tick_ready), .tick_data_i(first_q),
    .config_i(config_i),
    .bank_en_o(bank_en_o), .bank_addr_o(bank_addr_o), .bank_data_i(bank_data_i),
    .pixel_valid_o(pixel_valid), .pixel_ready_i(pixel_ready), .pixel_data_o(pixel),
    .shown_valid_o(shown_valid), .shown_ready_i(1'b1), .shown_data_o(shown),
    .fire_o(), .stall_o()
  );

  tmds_encoder u_tmds_encoder (
    .clk_i(clk_i), .rst_ni(running_q),
    .pixel_valid_i(pixel_valid), .pixel_ready_o(pixel_ready), .pixel_data_i(pixel),
    .characters_valid_o(characters_valid), .characters_ready_i(characters_ready),
    .characters_data_o(characters),
    .fire_o(), .stall_o()
  );

  hls_clock_fifo #(.WIDTH(30), .DEPTH(16)) to_link (
    .clk_i(clk_i), .rst_ni(running_q),
    .valid_i(characters_valid), .ready_o(characters_ready), .data_i(characters),
    .read_clk_i(dvi_clk_i), .read_rst_ni(crossing_rst_n),
    .valid_o(crossed_valid), .ready_i(crossed_ready), .data_o(crossed)
  );
  hls_buffer #(.WIDTH(30)) at_serialiser (
    .clk_i(dvi_clk_i), .rst_ni(waiting_rst_n),
    .valid_i(crossed_valid), .ready_o(crossed_ready), .data_i(crossed),
    .valid_o(dvi_valid), .ready_i(dvi_ready), .data_o(dvi_characters)
  );

  // The link's clock leaves no time for one reset to reach all of them.
  hls_reset #(.PARTS(3)) link_reset (
    .clk_i(dvi_clk_i), .rst_ni(running_q && dvi_rst_ni),
    .rst_no({crossing_rst_n, waiting_rst_n, sending_rst_n})
  );

  dvi_serialiser serialiser (
    .clk_i(dvi_clk_i), .rst_ni(sending_rst_n),
    .valid_i(dvi_valid), .ready_o(dvi_ready), .data_i(dvi_characters), .starved_o(dvi_starved),
    .first_o(dvi_first_o), .second_o(dvi_second_o)
  );

  hls_synchroniser starved (
    .clk_i(clk_i), .rst_ni(running_q), .data_i(dvi_starved), .data_o(starved_o)
  );

endmodule

`default_nettype wire
