// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A bank of up to 256 32-bit event counters, read one at a time: data_o is the value, three clocks
// ago, of the counter that addr_i named then. Counters wrap; clear_i sets all to zero.
//
// Only the low bits of a counter are flip-flops that count. A row of LUT RAM holds its high bits,
// and a copy of the highest low bit, from the counter's last turn. That was less than half a lap of
// the low bits ago, so if the copy is one and the bit is zero now, the low bits have wrapped since.
//
// Parameters:
//   COUNTERS  events that are counted, 1 to 256
//
// Ports:
//   clk_i, rst_ni  clock and synchronous reset, active low; the reset clears the counters too
//   clear_i        sets all counters to zero
//   addr_i         the counter to read
//   data_o         its value, three clocks later; zero where there is no counter
//   event_i        bit i counts up counter i
`default_nettype none

module hls_counters #(
    parameter COUNTERS = 1
) (
    input  wire                clk_i,
    input  wire                rst_ni,
    input  wire                clear_i,
    input  wire [7:0]          addr_i,
    output reg  [31:0]         data_o,
    input  wire [COUNTERS-1:0] event_i
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (COUNTERS < 1 || COUNTERS > 256) begin : bad_counters
      hls_counters_COUNTERS_must_be_1_to_256 stop ();
    end
  endgenerate

  localparam LOW = $clog2(COUNTERS + 4) + 1;  // half of them count what happens between two turns
  localparam HIGH = 32 - LOW;
  localparam SLOT_WIDTH = COUNTERS > 1 ? $clog2(COUNTERS) : 1;
  localparam [31:0] LAST = COUNTERS - 1;

  wire clear = clear_i || !rst_ni;
  wire [COUNTERS*LOW-1:0] low;  // of all counters, counter 0 lowest
  wire [COUNTERS-1:0] top;  // the highest low bits
  (* ram_style = "distributed" *)  // an FPGA without LUT RAM: docs/how-to/fpga.md
  reg [HIGH:0] rows[0:COUNTERS-1];
  reg written_q;  // each row was written since the clear; before that no low bits have wrapped

  genvar i, k;
  generate
    for (i = 0; i < COUNTERS; i = i + 1) begin : counter
      reg [LOW-1:0] low_q;
      // Without a carry chain, which would take more LUTs: a bit flips where all below it are ones.
      wire [LOW-1:0] flips;
      assign flips[0] = 1'b1;
      for (k = 1; k < LOW; k = k + 1) begin : others
        assign flips[k] = &low_q[k-1:0];
      end
      assign low[i*LOW+:LOW] = low_q;
      assign top[i] = low_q[LOW-1];
      always @(posedge clk_i) begin
        if (clear) low_q <= {LOW{1'b0}};
        else if (event_i[i]) low_q <= low_q ^ flips;
      end
    end
  endgenerate

  // The high bits, from the row and the current highest low bit.
  function [HIGH-1:0] high(input written, input [HIGH:0] row, input now);
    high = written ? row[HIGH:1] + {{(HIGH - 1) {1'b0}}, row[0] && !now} : {HIGH{1'b0}};
  endfunction

  // Both the turns and the read port pick one counter in two clocks: of each group, then the group.
  localparam GROUP = 8;
  localparam GROUPS = (COUNTERS + GROUP - 1) / GROUP;
  localparam GROUP_BITS = GROUPS > 1 ? $clog2(GROUPS) : 1;
  localparam WITHIN_BITS = GROUPS > 1 ? 3 : SLOT_WIDTH;

  // The counters take turns: each row is read, and written two clocks later.
  reg [SLOT_WIDTH-1:0] slot_q, pick_slot_q, write_slot_q;
  reg pick_q, pick_written_q, write_q, write_written_q, write_top_q;
  reg [HIGH:0] pick_row_q, write_row_q;
  wire [GROUPS-1:0] group_top;
  wire picked_top;
  always @(posedge clk_i) begin
    slot_q <= clear || slot_q == LAST[SLOT_WIDTH-1:0] ? {SLOT_WIDTH{1'b0}} : slot_q + 1'b1;
    pick_q <= !clear;
    pick_slot_q <= slot_q;
    pick_written_q <= written_q;
    pick_row_q <= rows[slot_q];
    write_q <= pick_q && !clear;
    write_slot_q <= pick_slot_q;
    write_written_q <= pick_written_q;
    write_row_q <= pick_row_q;
    write_top_q <= picked_top;
    if (write_q) begin
      rows[write_slot_q] <= {high(write_written_q, write_row_q, write_top_q), write_top_q};
      if (write_slot_q == LAST[SLOT_WIDTH-1:0]) written_q <= 1'b1;
    end
    if (clear) written_q <= 1'b0;
  end

  generate
    if (GROUPS > 1) begin : pick_group
      assign picked_top = group_top[pick_slot_q[3+:GROUP_BITS]];
    end else begin : one_group
      assign picked_top = group_top[0];
    end
  endgenerate

  // The read port: low bits of a counter of each group, those of one group, the sum.
  reg [7:0] group_addr_q;
  reg group_written_q, read_q, read_written_q;
  reg [HIGH:0] group_row_q, read_row_q;
  reg [LOW-1:0] read_low_q;
  wire [31:0] group_addr = {24'd0, group_addr_q};
  wire [LOW-1:0] group_low[0:GROUPS-1];

  generate
    for (i = 0; i < GROUPS; i = i + 1) begin : group
      reg [LOW-1:0] picked, low_q;
      reg now, top_q;
      assign group_low[i] = low_q;
      assign group_top[i] = top_q;
      integer at;
      always @* begin
        picked = {LOW{1'b0}};
        now = 1'b0;
        for (at = i * GROUP; at < COUNTERS && at < (i + 1) * GROUP; at = at + 1) begin
          if (addr_i[2:0] == at[2:0]) picked = picked | low[at*LOW+:LOW];
          if (slot_q[WITHIN_BITS-1:0] == at[WITHIN_BITS-1:0]) now = now | top[at];
        end
      end
      always @(posedge clk_i) begin
        low_q <= picked;
        top_q <= now;
      end
    end
  endgenerate

  always @(posedge clk_i) begin
    group_addr_q <= addr_i;
    group_written_q <= written_q;
    group_row_q <= rows[addr_i[SLOT_WIDTH-1:0]];
    read_q <= group_addr < COUNTERS;
    read_written_q <= group_written_q;
    read_row_q <= group_row_q;
    read_low_q <= group_low[group_addr_q[3+:GROUP_BITS]];
    data_o <= read_q ? {high(read_written_q, read_row_q, read_low_q[LOW-1]), read_low_q} : 32'd0;
  end

endmodule

`default_nettype wire
