// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One memory for three: the display, the core and the host, whose reads take turns, as do their
// writes. Buffers behind them let a turn pass on while the memory is busy. An answer finds its way by
// the two highest bits of its id. A read of the host waits for the writes before it, so that it sees
// them, and writes of the core wait for it meanwhile. The memory answers reads of different rows of
// 1 KB in any order, but display and host want theirs in order: the display asks for one row at a
// time, the host for one beat. Answers that a core in reset has no more use for are dropped.
//
// Parameters:
//   ID_BITS     of a read of the core
//   BEAT_BYTES  of the memory's port
`default_nettype none

module memory_switch #(
  parameter ID_BITS = 9,
  parameter BEAT_BYTES = 16
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  // display
  input  wire                    display_read_valid_i,
  output wire                    display_read_ready_o,
  input  wire [24:0]             display_read_address_i,
  input  wire [3:0]              display_read_last_i,
  output wire                    display_beat_valid_o,
  input  wire                    display_beat_ready_i,
  // core
  input  wire                    core_stop_i, // in reset
  output wire                    core_idle_o, // no read of it is under way, nor any write
  input  wire                    core_read_valid_i,
  output wire                    core_read_ready_o,
  input  wire [ID_BITS-1:0]      core_read_id_i,
  input  wire [23:0]             core_read_address_i,
  input  wire [3:0]              core_read_last_i,
  output wire                    core_beat_valid_o,
  input  wire                    core_beat_ready_i,
  input  wire                    core_write_valid_i,
  output wire                    core_write_ready_o,
  input  wire [24:0]             core_write_address_i,
  input  wire [8*BEAT_BYTES-1:0] core_write_data_i,
  input  wire [BEAT_BYTES/2-1:0] core_write_mask_i,
  // host
  input  wire                    host_read_valid_i,
  output wire                    host_read_ready_o,
  input  wire [24:0]             host_read_address_i,
  input  wire [3:0]              host_read_last_i,
  output wire                    host_beat_valid_o,
  output wire                    host_beat_last_o,
  input  wire                    host_beat_ready_i,
  input  wire                    host_write_valid_i,
  output wire                    host_write_ready_o,
  input  wire [24:0]             host_write_address_i,
  input  wire [8*BEAT_BYTES-1:0] host_write_data_i,
  input  wire [BEAT_BYTES/2-1:0] host_write_mask_i,
  // what a beat brings, to whoever it is for
  output wire [ID_BITS-1:0]      beat_id_o,
  output wire [8*BEAT_BYTES-1:0] beat_data_o,
  output wire                    beat_last_o,
  // memory
  output wire                    read_valid_o,
  input  wire                    read_ready_i,
  output wire [ID_BITS+1:0]      read_id_o,
  output wire [24:0]             read_address_o,
  output wire [3:0]              read_last_o,
  input  wire                    beat_valid_i,
  output wire                    beat_ready_o,
  input  wire [ID_BITS+1:0]      beat_id_i,
  input  wire [8*BEAT_BYTES-1:0] beat_data_i,
  input  wire                    beat_last_i,
  output wire                    write_valid_o,
  input  wire                    write_ready_i,
  output wire [24:0]             write_address_o,
  output wire [8*BEAT_BYTES-1:0] write_data_o,
  output wire [BEAT_BYTES/2-1:0] write_mask_o,
  input  wire                    writes_idle_i // none is on its way
);

  localparam [1:0] DISPLAY = 2'd0, CORE = 2'd1, HOST = 2'd2;
  localparam [ID_BITS-1:0] NO_ID = 0;
  localparam READ_BITS = ID_BITS + 2 + 25 + 4;
  localparam WRITE_BITS = 25 + 8 * BEAT_BYTES + BEAT_BYTES / 2;

  // The display's reads under way are all of one row.
  reg  [14:0] display_row_q;
  reg  [7:0]  display_reads_q;
  wire display_read_allowed = display_reads_q == 8'd0 ||
                              (display_read_address_i[24:10] == display_row_q && !display_reads_q[7]);
  wire display_read_granted;
  assign display_read_ready_o = display_read_granted && display_read_allowed;

  // The beats of a read of the host, one after another.
  reg  [3:0] host_beat_q;
  reg        host_waits_q;
  wire host_read_ends = host_beat_q == host_read_last_i;
  wire write_under_way = write_valid_o || !writes_idle_i;
  wire host_read_waits = host_read_valid_i && !host_waits_q;
  wire core_write_granted;
  assign core_write_ready_o = core_write_granted && !host_read_waits;
  wire host_read_allowed = !host_write_valid_i && !write_under_way && !host_waits_q;
  wire host_read_granted;
  wire host_asks = host_read_valid_i && host_read_allowed && host_read_granted;
  wire [24:0] host_beat_address = host_read_address_i + {21'd0, host_beat_q} * BEAT_BYTES[24:0];
  wire asks, asks_ready, writes_valid, writes_ready;
  wire [READ_BITS-1:0]  asked;
  wire [WRITE_BITS-1:0] written;
  assign host_read_ready_o = host_asks && host_read_ends;

  hls_arbiter #(.INPUTS(3), .WIDTH(READ_BITS)) reads (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .valid_i({host_read_valid_i && host_read_allowed, core_read_valid_i,
              display_read_valid_i && display_read_allowed}),
    .ready_o({host_read_granted, core_read_ready_o, display_read_granted}),
    .data_i({HOST, NO_ID, host_beat_address, 4'd0,
             CORE, core_read_id_i, 1'b0, core_read_address_i, core_read_last_i,
             DISPLAY, NO_ID, display_read_address_i, display_read_last_i}),
    .valid_o(asks), .ready_i(asks_ready), .data_o(asked)
  );
  hls_buffer #(.WIDTH(READ_BITS)) next_read (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(asks), .ready_o(asks_ready), .data_i(asked),
    .valid_o(read_valid_o), .ready_i(read_ready_i),
    .data_o({read_id_o, read_address_o, read_last_o})
  );

  hls_arbiter #(.INPUTS(2), .WIDTH(WRITE_BITS)) writes (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .valid_i({host_write_valid_i, core_write_valid_i && !host_read_waits}),
    .ready_o({host_write_ready_o, core_write_granted}),
    .data_i({host_write_address_i, host_write_data_i, host_write_mask_i,
             core_write_address_i, core_write_data_i, core_write_mask_i}),
    .valid_o(writes_valid), .ready_i(writes_ready), .data_o(written)
  );
  hls_buffer #(.WIDTH(WRITE_BITS)) next_write (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(writes_valid), .ready_o(writes_ready),
    .data_i(written), .valid_o(write_valid_o), .ready_i(write_ready_i),
    .data_o({write_address_o, write_data_o, write_mask_o})
  );

  wire [1:0] beat_for = beat_id_i[ID_BITS +: 2];
  assign display_beat_valid_o = beat_valid_i && beat_for == DISPLAY;
  assign core_beat_valid_o = beat_valid_i && beat_for == CORE && !core_stop_i;
  assign host_beat_valid_o = beat_valid_i && beat_for == HOST;
  assign beat_ready_o = beat_for == DISPLAY ? display_beat_ready_i :
                        beat_for == CORE ? core_beat_ready_i || core_stop_i : host_beat_ready_i;
  assign beat_id_o = beat_id_i[ID_BITS-1:0];
  assign beat_data_o = beat_data_i;
  assign beat_last_o = beat_last_i;

  // A read is under way until its last beat is taken; the core's ids are unique among them.
  reg  [ID_BITS:0] core_reads_q;
  reg  host_last_q; // the beat of the host that is under way ends its read
  wire core_begins = core_read_valid_i && core_read_ready_o;
  wire display_begins = display_read_valid_i && display_read_ready_o;
  wire ends = beat_valid_i && beat_ready_o && beat_last_i;
  wire core_ends = ends && beat_for == CORE;
  wire display_ends = ends && beat_for == DISPLAY;
  wire host_ends = ends && beat_for == HOST;
  assign core_idle_o = core_reads_q == {(ID_BITS + 1) {1'b0}} && !write_under_way;
  assign host_beat_last_o = host_last_q;
  always @(posedge clk_i) begin
    if (core_begins && !core_ends) core_reads_q <= core_reads_q + 1'b1;
    if (core_ends && !core_begins) core_reads_q <= core_reads_q - 1'b1;
    if (display_begins && !display_ends) display_reads_q <= display_reads_q + 8'd1;
    if (display_ends && !display_begins) display_reads_q <= display_reads_q - 8'd1;
    if (display_begins) display_row_q <= display_read_address_i[24:10];
    if (host_asks) begin
      host_waits_q <= 1'b1;
      host_last_q <= host_read_ends;
      host_beat_q <= host_read_ends ? 4'd0 : host_beat_q + 4'd1;
    end
    if (host_ends) host_waits_q <= 1'b0;
    if (!rst_ni) begin
      core_reads_q <= {(ID_BITS + 1) {1'b0}};
      display_reads_q <= 8'd0;
      host_waits_q <= 1'b0;
      host_beat_q <= 4'd0;
    end
  end

endmodule

`default_nettype wire
