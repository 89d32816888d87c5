// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// FIFO from one clock to another, whatever their rates and phases. Each side counts its tokens in
// Gray code, of which one bit changes at a time; the other side sees the count through two
// registers, so it sees the old one or the new one, and late, which only makes the FIFO seem fuller
// or emptier than it is. ready_o and valid_o come from registers, which know it another clock later,
// and each count has the next one in registers beside it, so that they are a comparison away. A token
// takes three to four clocks of the reader to come through. A row is read three clocks of the reader
// after it was written at the earliest.
//
// Parameters:
//   WIDTH  bits of a token, at least 1
//   DEPTH  places, a power of two, at least 4
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset of the writer, active low
//   valid_i, ready_o, data_i  the stream that comes in, in the writer's clock
//   read_clk_i, read_rst_ni   clock and synchronous reset of the reader; for four clocks of each
//                             side both resets must be low at once
//   valid_o, ready_i, data_o  the stream that goes out, in the same order, in the reader's clock
`default_nettype none

module hls_clock_fifo #(
    parameter WIDTH = 8,
    parameter DEPTH = 16
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,
    input  wire             read_clk_i,
    input  wire             read_rst_ni,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_clock_fifo_WIDTH_must_be_at_least_1 stop ();
    end
    if (DEPTH < 4 || (DEPTH & (DEPTH - 1)) != 0) begin : bad_depth
      hls_clock_fifo_DEPTH_must_be_a_power_of_two_of_at_least_4 stop ();
    end
  endgenerate

  localparam BITS = DEPTH > 4 ? $clog2(DEPTH) : 2;

  (* ram_style = "distributed" *)
  reg [WIDTH-1:0] rows           [0:DEPTH-1];

  // Tokens that came and that left, modulo DEPTH; modulo 2 * DEPTH in Gray code, and with one more; and
  // as the other side sees them.
  reg [ BITS-1:0] write_q;
  reg [   BITS:0] write_gray_q;
  reg [   BITS:0] write_next_q;
  reg [   BITS:0] write_next_gray_q;
  reg [   BITS:0] write_early_q;
  reg [   BITS:0] write_seen_q;
  reg [ BITS-1:0] read_q;
  reg [   BITS:0] read_gray_q;
  reg [   BITS:0] read_next_q;
  reg [   BITS:0] read_next_gray_q;
  reg [   BITS:0] read_early_q;
  reg [   BITS:0] read_seen_q;
  reg             ready_q;
  reg             valid_q;

  wire            push = valid_i && ready_q;
  wire            pop = valid_q && ready_i;
  // Counters so narrow take fewer LUTs than a carry chain: a bit flips where all below it are ones.
  wire [  BITS:0] write_flips;
  wire [  BITS:0] read_flips;
  wire [  BITS:0] write_after = write_next_q ^ write_flips;
  wire [  BITS:0] read_after = read_next_q ^ read_flips;
  localparam [BITS:0] ONE = 1;  // its Gray code too
  genvar i;
  generate
    assign {write_flips[0], read_flips[0]} = 2'b11;
    for (i = 1; i <= BITS; i = i + 1) begin : counter
      assign write_flips[i] = &write_next_q[i-1:0];
      assign read_flips[i] = &read_next_q[i-1:0];
    end
  endgenerate

  // Full: the counts differ by DEPTH, which in Gray code turns the two highest bits about.
  wire [BITS:0] full_gray = {~read_seen_q[BITS:BITS-1], read_seen_q[BITS-2:0]};
  assign ready_o = ready_q;
  assign valid_o = valid_q;
  assign data_o  = rows[read_q];

  // Comparisons are written as |(a ^ b): of a choice between two != Yosys makes one comparison behind
  // a choice of counts, which takes longer.
  always @(posedge clk_i) if (push) rows[write_q] <= data_i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q           <= {BITS{1'b0}};
      write_gray_q      <= {(BITS + 1) {1'b0}};
      write_next_q      <= ONE;
      write_next_gray_q <= ONE;
      ready_q           <= 1'b1;
      read_early_q      <= {(BITS + 1) {1'b0}};
      read_seen_q       <= {(BITS + 1) {1'b0}};
    end else begin
      if (push) begin
        write_q           <= write_next_q[BITS-1:0];
        write_gray_q      <= write_next_gray_q;
        write_next_q      <= write_after;
        write_next_gray_q <= write_after ^ {1'b0, write_after[BITS:1]};
      end
      ready_q      <= push ? |(write_next_gray_q ^ full_gray) : |(write_gray_q ^ full_gray);
      read_early_q <= read_gray_q;
      read_seen_q  <= read_early_q;
    end
  end

  always @(posedge read_clk_i) begin
    if (!read_rst_ni) begin
      read_q           <= {BITS{1'b0}};
      read_gray_q      <= {(BITS + 1) {1'b0}};
      read_next_q      <= ONE;
      read_next_gray_q <= ONE;
      valid_q          <= 1'b0;
      write_early_q    <= {(BITS + 1) {1'b0}};
      write_seen_q     <= {(BITS + 1) {1'b0}};
    end else begin
      if (pop) begin
        read_q           <= read_next_q[BITS-1:0];
        read_gray_q      <= read_next_gray_q;
        read_next_q      <= read_after;
        read_next_gray_q <= read_after ^ {1'b0, read_after[BITS:1]};
      end
      valid_q       <= pop ? |(read_next_gray_q ^ write_seen_q) : |(read_gray_q ^ write_seen_q);
      write_early_q <= write_gray_q;
      write_seen_q  <= write_early_q;
    end
  end

endmodule

`default_nettype wire
