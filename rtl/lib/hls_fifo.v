// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// FIFO of up to DEPTH tokens. The first token lies in a register and can leave the clock after it
// came. ready_o comes from a register; it is high while more than MARGIN places are free. With a
// MARGIN the FIFO takes every token: the sender promises to send at most MARGIN tokens after
// ready_o falls. With BOUNDED the sender promises that there are never more than DEPTH tokens in
// all: the FIFO is always ready.
//
// Parameters:
//   WIDTH    bits of a token, at least 1
//   DEPTH    places, at least 1
//   MARGIN   tokens that may still come once ready_o is low, at least 0 and fewer than DEPTH
//   BOUNDED  1: the sender promises that there are never more than DEPTH tokens; else 0
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset, active low
//   valid_i, ready_o, data_i  the stream that comes in
//   valid_o, ready_i, data_o  the stream that goes out, in the same order
`default_nettype none

module hls_fifo #(
    parameter WIDTH  = 8,
    parameter DEPTH  = 16,
    parameter MARGIN = 0,
    parameter BOUNDED = 0
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_fifo_WIDTH_must_be_at_least_1 stop ();
    end
    if (DEPTH < 1) begin : bad_depth
      hls_fifo_DEPTH_must_be_at_least_1 stop ();
    end else if (MARGIN < 0 || MARGIN >= DEPTH) begin : bad_margin
      hls_fifo_MARGIN_must_be_0_to_DEPTH_minus_1 stop ();
    end
    if (BOUNDED != 0 && BOUNDED != 1) begin : bad_bounded
      hls_fifo_BOUNDED_must_be_0_or_1 stop ();
    end
  endgenerate

  localparam ADDR_WIDTH = DEPTH > 1 ? $clog2(DEPTH) : 1;
  localparam [31:0] LAST = DEPTH - 1;
  localparam WRAPS = DEPTH == 1 << ADDR_WIDTH;  // addresses wrap from LAST to 0 on their own
  localparam [31:0] SPACE = DEPTH - MARGIN - 1;

  // Data of block RAM come late for the multiplexer before data_q.
  // verilator lint_off UNUSEDPARAM
  localparam RAM_STYLE = DEPTH <= 64 ? "distributed" : "auto";
  // verilator lint_on UNUSEDPARAM
  (* ram_style = RAM_STYLE *)  // an FPGA without LUT RAM: docs/how-to/fpga.md
  reg  [     WIDTH-1:0] rows     [0:DEPTH-1];
  reg  [ADDR_WIDTH-1:0] write_q;
  reg  [ADDR_WIDTH-1:0] read_q;
  reg                   empty_q;  // the rows hold no token
  reg  [ADDR_WIDTH+1:0] space_q;  // free places less MARGIN + 1; negative: not ready
  reg                   valid_q;
  reg  [     WIDTH-1:0] data_q;

  wire                  push = valid_i && (MARGIN > 0 || ready_o);
  wire                  pop = valid_q && ready_i;
  wire                  refill = !valid_q || ready_i;
  wire                  take = refill && !empty_q;
  wire                  store = push && !(refill && empty_q);
  // Counters so narrow take fewer LUTs than a carry chain with its ends: a bit flips where all below
  // it are ones, or in counting down zeros.
  wire [ADDR_WIDTH-1:0] write_flips;
  wire [ADDR_WIDTH-1:0] read_flips;
  wire [ADDR_WIDTH+1:0] space_flips;
  genvar i;
  generate
    assign {write_flips[0], read_flips[0], space_flips[0]} = 3'b111;
    for (i = 1; i < ADDR_WIDTH; i = i + 1) begin : pointer
      assign write_flips[i] = &write_q[i-1:0];
      assign read_flips[i] = &read_q[i-1:0];
    end
    for (i = 1; i < ADDR_WIDTH + 2; i = i + 1) begin : space
      assign space_flips[i] = &(space_q[i-1:0] ^ {i{push}});
    end
  endgenerate
  wire [ADDR_WIDTH-1:0] write_next =
      !WRAPS && write_q == LAST[ADDR_WIDTH-1:0] ? {ADDR_WIDTH{1'b0}} : write_q ^ write_flips;
  wire [ADDR_WIDTH-1:0] read_next =
      !WRAPS && read_q == LAST[ADDR_WIDTH-1:0] ? {ADDR_WIDTH{1'b0}} : read_q ^ read_flips;

  assign ready_o = BOUNDED != 0 || !space_q[ADDR_WIDTH+1];
  assign valid_o = valid_q;
  assign data_o  = data_q;

  // A row is always free, since one of DEPTH tokens is in the register. So it takes data_i in every
  // clock, and whether it keeps them comes late to the pointers alone.
  always @(posedge clk_i) begin
    rows[write_q] <= data_i;
    if (refill) data_q <= empty_q ? data_i : rows[read_q];
  end

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= {ADDR_WIDTH{1'b0}};
      read_q  <= {ADDR_WIDTH{1'b0}};
      empty_q <= 1'b1;
      space_q <= SPACE[ADDR_WIDTH+1:0];
      valid_q <= 1'b0;
    end else begin
      if (store) write_q <= write_next;
      if (take) read_q <= read_next;
      if (store != take) empty_q <= take && read_next == write_q;
      if (push != pop) space_q <= space_q ^ space_flips;
      if (refill) valid_q <= push || !empty_q;
    end
  end

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (rst_ni && push && !pop && space_q == SPACE[ADDR_WIDTH+1:0] - DEPTH[ADDR_WIDTH+1:0]) begin
      $display("%m: a token came to a full FIFO of depth %0d", DEPTH);
      $stop;
    end
  end
`endif

endmodule

`default_nettype wire
