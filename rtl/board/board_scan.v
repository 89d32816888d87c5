// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The logic around the unit scan_out: the pixel clock before it, the pins behind it. It asks for a
// pixel every clocks_i clocks; as the unit's latency is constant, pixels come out at the same rate.
// The pins change with vga_clock_o low and hold still from a clock before it rises until it has
// fallen. Fewer than two clocks a pixel switch the scan-out off: all pins are low and the unit is
// held in reset.
`default_nettype none

module board_scan (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire [7:0]  clocks_i,
  output wire [19:0] shown_o,  // base of the picture that is being shown, or is in this blank
  output wire [31:0] frames_o, // vertical blanks since it was switched on
  // unit
  output wire        scan_rst_no,
  output wire        tick_valid_o,
  output wire        tick_data_o, // the first since it was switched on
  input  wire        tick_ready_i,
  input  wire        pixel_valid_i,
  input  wire [26:0] pixel_data_i, // visible, vsync, hsync, colour
  input  wire        shown_valid_i,
  input  wire [19:0] shown_data_i,
  // pins; red is the lowest byte of vga_colour_o
  output wire        vga_clock_o,
  output wire        vga_hsync_o,
  output wire        vga_vsync_o,
  output wire        vga_visible_o,
  output wire [23:0] vga_colour_o
);

  wire on = rst_ni && clocks_i[7:1] != 7'd0;

  reg [7:0]  count_q; // clocks until the next pixel is asked for
  reg        first_q;
  reg        clock_q;
  reg [26:0] pixel_q;
  reg [19:0] shown_q;
  reg [31:0] frames_q;

  assign scan_rst_no = on;
  assign tick_valid_o = on && count_q == 8'd0;
  assign tick_data_o = first_q;
  assign shown_o = shown_q;
  assign frames_o = frames_q;
  assign vga_clock_o = clock_q;
  assign {vga_visible_o, vga_vsync_o, vga_hsync_o, vga_colour_o} = pixel_q;

  always @(posedge clk_i) begin
    count_q <= tick_valid_o ? clocks_i - 8'd1 : count_q - 8'd1;
    if (tick_valid_o) first_q <= 1'b0;
    clock_q <= !pixel_valid_i;
    if (pixel_valid_i) pixel_q <= pixel_data_i;
    if (shown_valid_i) begin
      shown_q <= shown_data_i;
      frames_q <= frames_q + 32'd1;
    end
    if (!on) begin
      count_q <= 8'd0;
      first_q <= 1'b1;
      clock_q <= 1'b0;
      pixel_q <= 27'd0;
      shown_q <= 20'd0;
      frames_q <= 32'd0;
    end
  end

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (tick_valid_o && !tick_ready_i) begin
      $display("%m: the scan-out does not take a pixel every %0d clocks", clocks_i);
      $stop;
    end
  end
`else
  wire unused = &{1'b0, tick_ready_i};
`endif

endmodule

`default_nettype wire
