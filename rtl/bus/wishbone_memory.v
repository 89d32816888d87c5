// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core's memory port as a Wishbone B4 manager, pipelined. A beat of the port is an access; its
// address is that of its first byte. Accesses are answered in order, so the core's data about each
// answer wait in a FIFO. If reads and writes both wait, they take turns. CYC stays
// high while anything is in flight, but after TURN accesses it falls, so that others get the bus.
//
// In place of an answer with ERR the core gets data that end its path through the scene
// (memory_filler.v), so that the frame ends; the first error's address goes to the registers.
//
// While stop_i is high, the core is in reset: its answers are dropped. stop_i stays high until
// idle_o is.
//
// Parameters:
//   ID_BITS, BEAT_BYTES  of the core's port, as its dynrt_core.vh has them
//   ADDRESS_BITS         of the bus, 26 to 64
//   FLIGHT               accesses in flight, and beats that wait for the core; at least 1
//   TURN                 accesses in a row, 1 to 1023
`default_nettype none

module wishbone_memory #(
  parameter ID_BITS = 10,
  parameter BEAT_BYTES = 4,
  parameter ADDRESS_BITS = 32,
  parameter FLIGHT = 64,
  parameter TURN = 256
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire [ADDRESS_BITS-1:0] base_i, // changes only while idle_o is high
  input  wire                    stop_i,
  output wire                    idle_o, // nothing is in flight
  // an answer with an error, a pulse
  output reg                     error_o,
  output reg                     error_write_o,
  output wire [1:0]              error_response_o,
  output reg  [24:0]             error_address_o, // of its beat, in the core's memory
  // the core's port
  input  wire                    read_valid_i,
  output wire                    read_ready_o,
  input  wire [ID_BITS-1:0]      read_id_i,
  input  wire [23:0]             read_address_i,
  input  wire [3:0]              read_last_i,
  output wire                    beat_valid_o,
  input  wire                    beat_ready_i,
  output wire [ID_BITS-1:0]      beat_id_o,
  output wire [8*BEAT_BYTES-1:0] beat_data_o,
  output wire                    beat_last_o,
  input  wire                    write_valid_i,
  output wire                    write_ready_o,
  input  wire [24:0]             write_address_i,
  input  wire [8*BEAT_BYTES-1:0] write_data_i,
  input  wire [BEAT_BYTES/2-1:0] write_mask_i,
  input  wire [2:0]              write_left_i,
  // Wishbone
  output wire                    m_wb_cyc_o,
  output wire                    m_wb_stb_o,
  output wire                    m_wb_we_o,
  output wire [ADDRESS_BITS-1:0] m_wb_adr_o,
  output wire [8*BEAT_BYTES-1:0] m_wb_dat_o,
  output wire [BEAT_BYTES-1:0]   m_wb_sel_o,
  input  wire                    m_wb_stall_i,
  input  wire                    m_wb_ack_i,
  input  wire                    m_wb_err_i,
  input  wire [8*BEAT_BYTES-1:0] m_wb_dat_i
);

  localparam DATA = 8 * BEAT_BYTES, HALVES = BEAT_BYTES / 2;
  localparam CREDIT_BITS = $clog2(FLIGHT + 1);
  localparam [CREDIT_BITS-1:0] CREDITS = FLIGHT[CREDIT_BITS-1:0];
  localparam [CREDIT_BITS-1:0] CREDIT = 1;
  localparam [31:0] LAST_OF_TURN = TURN - 1;

  // What the core asks for. It stays, whatever becomes of the core.
  wire               r_valid, r_ready;
  wire [ID_BITS-1:0] r_id;
  wire [23:0]        r_address;
  wire [3:0]         r_last;
  hls_buffer #(.WIDTH(ID_BITS + 28)) read_buffer (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(read_valid_i && !stop_i), .ready_o(read_ready_o),
    .data_i({read_id_i, read_address_i, read_last_i}), .valid_o(r_valid), .ready_i(r_ready),
    .data_o({r_id, r_address, r_last})
  );
  wire              w_valid, w_ready;
  wire [24:0]       w_address;
  wire [DATA-1:0]   w_data;
  wire [HALVES-1:0] w_mask;
  hls_buffer #(.WIDTH(25 + DATA + HALVES)) write_buffer (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(write_valid_i && !stop_i), .ready_o(write_ready_o),
    .data_i({write_address_i, write_data_i, write_mask_i}), .valid_o(w_valid), .ready_i(w_ready),
    .data_o({w_address, w_data, w_mask})
  );

  // The access at the pins is replaced when the bus has taken it.
  reg                    stb_q, we_q;
  reg  [24:0]            address_q;
  reg  [DATA-1:0]        data_q;
  reg  [HALVES-1:0]      mask_q;
  reg  [9:0]             turn_q;    // accesses since CYC rose
  reg                    rests_q;   // until CYC has fallen
  reg                    writes_q;  // a write goes first
  reg  [3:0]             beat_q;    // of the read
  reg  [CREDIT_BITS-1:0] credits_q; // beats that there is room for
  wire                   flight_room, in_flight;
  wire                   free = (!stb_q || !m_wb_stall_i) && flight_room && !rests_q;
  wire                   write_asks = w_valid && w_mask != {HALVES{1'b0}};
  wire                   read_asks = r_valid && credits_q != {CREDIT_BITS{1'b0}};
  wire                   write_goes = free && write_asks && (writes_q || !read_asks);
  wire                   read_goes = free && read_asks && !write_goes;
  wire                   goes = write_goes || read_goes;
  wire                   read_ends = beat_q == r_last;
  wire [24:0]            read_beat = {1'b0, r_address} + {21'd0, beat_q} * BEAT_BYTES[24:0];
  wire [24:0]            address = write_goes ? w_address : read_beat;
  // A beat that writes nothing needs no access.
  assign w_ready = write_goes || !write_asks;
  assign r_ready = read_goes && read_ends;

  // What is to be known of the answers.
  wire               a_we, a_last;
  wire [ID_BITS-1:0] a_id;
  wire [24:0]        a_address;
  wire               answered = m_wb_ack_i || m_wb_err_i;
  hls_fifo #(.WIDTH(ID_BITS + 27), .DEPTH(FLIGHT)) flight_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(goes), .ready_o(flight_room),
    .data_i({r_id, address, read_ends, write_goes}), .valid_o(in_flight), .ready_i(answered),
    .data_o({a_id, a_address, a_last, a_we})
  );
  wire            read_answered = answered && !a_we;
  wire [DATA-1:0] filled;
  memory_filler #(.ID_BITS(ID_BITS), .BEAT_BYTES(BEAT_BYTES)) filler (
    .clk_i(clk_i), .rst_ni(rst_ni), .taken_i(read_answered), .id_i(a_id), .last_i(a_last),
    .error_i(m_wb_err_i), .data_i(m_wb_dat_i), .data_o(filled)
  );
  wire beat_room;
  wire beat_waits;
  wire beat_taken = beat_waits && (beat_ready_i || stop_i);
  hls_fifo #(.WIDTH(ID_BITS + DATA + 1), .DEPTH(FLIGHT), .BOUNDED(1)) beat_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(read_answered), .ready_o(beat_room),
    .data_i({a_last, filled, a_id}), .valid_o(beat_waits), .ready_i(beat_ready_i || stop_i),
    .data_o({beat_last_o, beat_data_o, beat_id_o})
  );
  assign beat_valid_o = beat_waits && !stop_i;

  assign m_wb_cyc_o = in_flight;
  assign m_wb_stb_o = stb_q;
  assign m_wb_we_o = we_q;
  assign m_wb_adr_o = {base_i[ADDRESS_BITS-1:25], address_q};
  assign m_wb_dat_o = data_q;
  genvar h;
  generate
    for (h = 0; h < HALVES; h = h + 1) begin : select
      assign m_wb_sel_o[2*h +: 2] = {2{mask_q[h]}};
    end
  endgenerate
  assign idle_o = !r_valid && !w_valid && !in_flight && !beat_waits;

  always @(posedge clk_i) begin
    if (goes) begin
      we_q <= write_goes;
      address_q <= address;
      data_q <= w_data;
      mask_q <= write_goes ? w_mask : {HALVES{1'b1}};
    end
    error_write_o <= a_we;
    error_address_o <= a_address;
  end
  always @(posedge clk_i) begin
    if (goes || !m_wb_stall_i) stb_q <= goes;
    if (goes) writes_q <= !write_goes;
    if (goes) turn_q <= turn_q + 10'd1;
    if (goes && turn_q == LAST_OF_TURN[9:0]) rests_q <= 1'b1;
    if (!in_flight && !goes) begin
      turn_q <= 10'd0;
      rests_q <= 1'b0;
    end
    if (read_goes) beat_q <= read_ends ? 4'd0 : beat_q + 4'd1;
    if (read_goes != beat_taken)
      credits_q <= beat_taken ? credits_q + CREDIT : credits_q - CREDIT;
    error_o <= answered && m_wb_err_i;
    if (!rst_ni) begin
      stb_q <= 1'b0;
      writes_q <= 1'b0;
      turn_q <= 10'd0;
      rests_q <= 1'b0;
      beat_q <= 4'd0;
      credits_q <= CREDITS;
      error_o <= 1'b0;
    end
  end
  // Wishbone tells no more of an error than that it is one.
  assign error_response_o = 2'd2;

  // The lowest bits of the base are zero, the bus knows no bursts, and credits keep room for beats.
  wire unused = &{1'b0, base_i[24:0], write_left_i, beat_room};

endmodule

`default_nettype wire
