// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A memory port on a 16-bit SDR SDRAM: the logic around the unit sdram_controller, which takes a
// request or none and sets the pins in every clock. Reads go first; writes that have waited go
// together. A write becomes a request for the pairs of halves that its mask touches. A read sees the
// earlier writes to its bytes, and no later ones. hls/units/sdram_port.h is the native model.
//
// A request has a slot, which keeps a read's id or a write's data until its last word has moved. A
// read is taken only if there is space for its beats, so that the chip's words never wait. All pins
// are registers, in the pin's own cell if the device has one (syn_useioff): sdram_dq_i is taken
// CAS_LATENCY + 1 clocks after a command is on the pins.
//
// Parameters:
//   ID_WIDTH     bits of a read's id
//   PORT_BYTES   bytes of a beat: 8, 16 or 32
//   CAS_LATENCY  that of the controller
//
// Ports:
//   pause_i      clocks of the pause after power-up, in pairs
//   read_*       a read of read_last_i + 1 beats, aligned to a beat, within 32 bytes
//   write_*      a beat to be written, aligned; a bit of the mask for each 16 bits
//   beat_*       data read, in any order of reads; the beats of one read follow each other
//   sdram_*      the chip's pins; sdram_dq_float_o is high where a data pin is not driven; its clock, CKE and CS# are the board's (CKE high, CS# low)
`default_nettype none

module sdram_port #(
    parameter ID_WIDTH    = 8,
    parameter PORT_BYTES  = 16,
    parameter CAS_LATENCY = 3
) (
    input  wire                    clk_i,
    input  wire                    rst_ni,
    input  wire [            15:0] pause_i,
    input  wire                    read_valid_i,
    output wire                    read_ready_o,
    input  wire [    ID_WIDTH-1:0] read_id_i,
    input  wire [            24:0] read_address_i,
    input  wire [             3:0] read_last_i,
    input  wire                    write_valid_i,
    output wire                    write_ready_o,
    input  wire [            24:0] write_address_i,
    input  wire [8*PORT_BYTES-1:0] write_data_i,
    input  wire [PORT_BYTES/2-1:0] write_mask_i,
    output wire                    beat_valid_o,
    input  wire                    beat_ready_i,
    output wire [    ID_WIDTH-1:0] beat_id_o,
    output wire [8*PORT_BYTES-1:0] beat_data_o,
    output wire                    beat_last_o,
    output wire                    sdram_ras_no,
    output wire                    sdram_cas_no,
    output wire                    sdram_we_no,
    output wire [             1:0] sdram_ba_o,
    output wire [            12:0] sdram_a_o,
    output wire [             1:0] sdram_dqm_o,
    output wire [            15:0] sdram_dq_float_o,
    output wire [            15:0] sdram_dq_o,
    input  wire [            15:0] sdram_dq_i
);

  localparam DATA = 8 * PORT_BYTES;
  localparam HALVES = PORT_BYTES / 2;
  localparam INDEX = $clog2(HALVES);
  localparam [31:0] BEATS = 32;  // that may be on their way, or wait to be taken
  localparam READS = 32;  // slots
  localparam WRITES = 16;
  localparam [31:0] LAST_PAIR = PORT_BYTES / 4 - 1;
  localparam [31:0] MOST_BEATS = 32 / PORT_BYTES;  // of a read
  localparam MOST_BITS = $clog2(MOST_BEATS);
  localparam TAGS = CAS_LATENCY + 3;  // clocks from a token to its word in dq_q

  // The controller's token, and its bits.
  wire        step_valid;
  wire [33:0] step;
  wire        step_reads = step_valid && step[19];
  wire        step_writes = step_valid && step[20];
  wire [ 3:0] step_word = step[24:21];
  wire        step_last = step[25];
  wire [ 4:0] step_tag = step[30:26];
  wire [ 2:0] step_taken = step_valid ? step[33:31] : 3'd0;

  // The last word of a beat, of a read, and the bit of its slot.
  wire        ends, ends_read;
  reg  [READS-1:0] tag_bit_q;

  // ---- requests ----
  reg         writes_turn_q;
  reg  [ 4:0] batch_q;  // writes in this turn of theirs
  reg  [ 7:0] waited_q;  // clocks that a write has waited for reads
  reg  [ 4:0] waiting_q;  // requests in the controller's queue or on their way to it
  reg  [ 5:0] free_beats_q;
  reg  [32:0] request_q;
  reg  [ 4:0] read_slot_q;  // of the next read
  reg  [ 3:0] write_slot_q;
  reg  [ READS-1:0] read_busy_q;
  reg  [ READS-1:0] read_bit_q;  // that of read_slot_q
  reg  [WRITES-1:0] write_busy_q;
  reg  [WRITES-1:0] write_bit_q;  // that of write_slot_q
  reg         read_free_q;  // the slot
  reg         write_free_q;

  wire        room = !waiting_q[4];
  wire        beats_room = |free_beats_q[5:MOST_BITS];  // for the most beats of a read
  assign read_ready_o = !writes_turn_q && room && beats_room && read_free_q;
  assign write_ready_o = writes_turn_q && room && write_free_q;
  wire takes_read = read_valid_i && read_ready_o;
  wire takes_write = write_valid_i && write_ready_o;
  wire writes_any = takes_write && (|write_mask_i);

  wire [READS-1:0] next_read_bit = {read_bit_q[READS-2:0], read_bit_q[READS-1]};
  wire [WRITES-1:0] next_write_bit = {write_bit_q[WRITES-2:0], write_bit_q[WRITES-1]};
  wire [WRITES-1:0] written_bit = {15'd0, step_writes && step_last} << step_tag[3:0];

  // What is taken is known late: each number is found for both cases. A token tells of up to four
  // requests that are taken from the queues, as each bank has one.
  wire [4:0] fewer_waiting = waiting_q - {2'd0, step_taken};
  wire [2:0] fewer_but_one = step_taken - 3'd1;
  wire [4:0] waiting_and_one = waiting_q - {{2{fewer_but_one[2]}}, fewer_but_one};
  wire beat_leaves = beat_valid_o && beat_ready_i;
  wire [5:0] beats_and_one = free_beats_q + 6'd1;
  wire [5:0] beats_less_last = free_beats_q - {4'd0, read_last_i[1:0]};
  wire [5:0] beats_less_all = free_beats_q + {4'b1111, ~read_last_i[1:0]};
  wire [4:0] batch_and_one = batch_q + 5'd1;

  // Each way costs clocks to turn to, so writes wait for a while and then go together.
  wire full = takes_write && (&batch_q);
  wire changes = writes_turn_q ? read_valid_i && (!write_valid_i || full) :
      write_valid_i && (!read_valid_i || (&waited_q));

  // The first and the last pair that a mask touches.
  reg [2:0] first, last;
  integer i;
  always @* begin
    first = 3'd0;
    last  = 3'd0;
    for (i = 0; i < HALVES / 2; i = i + 1) begin
      if (|write_mask_i[2*i+:2]) last = i[2:0];
      if (|write_mask_i[HALVES-2-2*i+:2]) first = LAST_PAIR[2:0] - i[2:0];
    end
  end
  wire [ 2:0] write_pairs = last - first;  // less one
  wire [ 2:0] read_pairs = {1'b0, read_last_i[1:0]} << (INDEX - 1) | LAST_PAIR[2:0];  // less one

  always @(posedge clk_i) begin
    request_q <= writes_turn_q ?
        {1'b0, write_slot_q, 1'b1, write_pairs, write_address_i[24:2] | {20'd0, first}, writes_any} :
        {read_slot_q, 1'b0, read_pairs, read_address_i[24:2], takes_read};
    read_slot_q <= read_slot_q + {4'd0, takes_read};
    if (writes_any) write_slot_q <= write_slot_q + 4'd1;
    read_free_q <= takes_read ? !(|(read_busy_q & next_read_bit)) : !(|(read_busy_q & read_bit_q));
    write_free_q <= writes_any ? !(|(write_busy_q & next_write_bit)) :
        !(|(write_busy_q & write_bit_q));
    if (takes_read) read_bit_q <= next_read_bit;
    if (writes_any) write_bit_q <= next_write_bit;
    read_busy_q <= (read_busy_q & ~(ends && ends_read ? tag_bit_q : {READS{1'b0}})) |
        (takes_read ? read_bit_q : {READS{1'b0}});
    write_busy_q <= (write_busy_q & ~written_bit) | (writes_any ? write_bit_q : {WRITES{1'b0}});
    waiting_q <= takes_read || writes_any ? waiting_and_one : fewer_waiting;
    if (takes_read) free_beats_q <= beat_leaves ? beats_less_last : beats_less_all;
    else if (beat_leaves) free_beats_q <= beats_and_one;
    batch_q <= changes || !writes_turn_q ? 5'd0 : takes_write ? batch_and_one : batch_q;
    waited_q <= writes_turn_q || !write_valid_i ? 8'd0 : waited_q + {7'd0, !(&waited_q)};
    if (changes) writes_turn_q <= !writes_turn_q;
    if (!rst_ni) begin
      request_q <= 33'd0;
      read_slot_q <= 5'd0;
      read_bit_q <= {{(READS - 1) {1'b0}}, 1'b1};
      write_slot_q <= 4'd0;
      write_bit_q <= {{(WRITES - 1) {1'b0}}, 1'b1};
      read_busy_q <= {READS{1'b0}};
      write_busy_q <= {WRITES{1'b0}};
      read_free_q <= 1'b1;
      write_free_q <= 1'b1;
      waiting_q <= 5'd0;
      free_beats_q <= BEATS[5:0];
      batch_q <= 5'd0;
      waited_q <= 8'd0;
      writes_turn_q <= 1'b0;
    end
  end

  wire request_ready, fires, stalls;
  sdram_controller #(
      .PINS_BOUNDED(1)
  ) controller (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .request_valid_i(1'b1),
      .request_ready_o(request_ready),
      .request_data_i (request_q),
      .pause_i        (pause_i),
      .pins_valid_o   (step_valid),
      .pins_ready_i   (1'b1),
      .pins_data_o    (step),
      .fire_o         (fires),
      .stall_o        (stalls)
  );

  // ---- pins ----
  // A clock for the write's row, another for the word in it.
  (* ram_style = "distributed" *)
  reg  [DATA+HALVES-1:0] writes   [0:WRITES-1];
  reg  [DATA+HALVES-1:0] row_q;
  reg  [       INDEX-1:0] half_q;
  reg                     valid_q = 1'b0;
  reg  [            20:0] step_q;
  wire [        DATA-1:0] written = row_q[DATA-1:0];
  wire [      HALVES-1:0] mask = row_q[DATA+HALVES-1:DATA];
  wire                    ready = step_q[18];
  wire                    drives = valid_q && step_q[20];

  // No command from power-up on, before a reset has reached the registers.
  (* syn_useioff = 1 *)
  reg  [ 2:0] command_q = 3'b111;
  (* syn_useioff = 1 *)
  reg  [ 1:0] bank_q;
  (* syn_useioff = 1 *)
  reg  [12:0] address_q;
  (* syn_useioff = 1 *)
  reg  [15:0] word_q;
  assign {sdram_we_no, sdram_cas_no, sdram_ras_no} = command_q;
  assign sdram_ba_o = bank_q;
  assign sdram_a_o = address_q;
  assign sdram_dq_o = word_q;
  always @(posedge clk_i) begin
    if (writes_any) writes[write_slot_q] <= {write_mask_i, write_data_i};
    row_q <= writes[step_tag[3:0]];
    half_q <= step_word[INDEX-1:0];
    step_q <= step[20:0];
    valid_q <= rst_ni && step_valid;

    command_q <= valid_q ? step_q[2:0] : 3'b111;
    bank_q <= step_q[4:3];
    address_q <= step_q[17:5];
    word_q <= written[16*half_q+:16];
  end

  // A register for each pin; to a synthesis they are the same, and it would make one of them.
  wire    masks = !valid_q || !ready || (drives && !mask[half_q]);
  genvar  pin;
  generate
    for (pin = 0; pin < 2; pin = pin + 1) begin : mask_pin
      (* syn_useioff = 1 *)
      reg dqm_q;
      assign sdram_dqm_o[pin] = dqm_q;
      (* keep *)
      always @(posedge clk_i) dqm_q <= masks;
    end
    for (pin = 0; pin < 16; pin = pin + 1) begin : data_pin
      (* syn_useioff = 1 *)
      reg float_q = 1'b1;
      assign sdram_dq_float_o[pin] = float_q;
      (* keep *)
      always @(posedge clk_i) float_q <= !drives;
    end
  endgenerate

  // ---- words that are read ----
  (* ram_style = "distributed" *)
  reg  [ID_WIDTH+1:0] reads    [0:READS-1];  // the number of beats less one, the id
  reg  [ID_WIDTH+1:0] read_q;  // that of the word in dq_q
  reg  [    TAGS-1:0] reads_q;
  reg  [    TAGS-1:0] ends_q;  // the word is the last one of its beat
  reg  [  5*TAGS-6:0] tags_q;
  (* syn_useioff = 1 *)
  reg  [        15:0] dq_q;
  reg  [    DATA-1:0] beat_q;
  reg  [         1:0] number_q;  // of the beat in its read
  reg                 arrived_q;
  reg                 arrived_last_q;
  reg  [ID_WIDTH-1:0] arrived_id_q;
  assign ends = reads_q[TAGS-1] && ends_q[TAGS-1];
  assign ends_read = number_q == read_q[ID_WIDTH+1:ID_WIDTH];
  wire                beat_room;
  wire [         4:0] next_tag = tags_q[5*TAGS-6-:5];

  always @(posedge clk_i) begin
    if (takes_read) reads[read_slot_q] <= {read_last_i[1:0], read_id_i};
    dq_q <= sdram_dq_i;
    reads_q <= {reads_q[TAGS-2:0], step_reads};
    ends_q <= {ends_q[TAGS-2:0], &step_word[INDEX-1:0]};
    tags_q <= {tags_q[5*TAGS-11:0], step_tag};
    read_q <= reads[next_tag];
    tag_bit_q <= 32'd1 << next_tag;
    if (reads_q[TAGS-1]) beat_q <= {dq_q, beat_q[DATA-1:16]};
    arrived_q <= ends;
    arrived_last_q <= ends_read;
    arrived_id_q <= read_q[ID_WIDTH-1:0];
    if (ends) number_q <= ends_read ? 2'd0 : number_q + 2'd1;
    if (!rst_ni) begin
      reads_q <= {TAGS{1'b0}};
      number_q <= 2'd0;
      arrived_q <= 1'b0;
    end
  end

  hls_fifo #(
      .WIDTH  (DATA + ID_WIDTH + 1),
      .DEPTH  (BEATS),
      .BOUNDED(1)
  ) beat_fifo (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .valid_i(arrived_q),
      .ready_o(beat_room),
      .data_i ({arrived_last_q, arrived_id_q, beat_q}),
      .valid_o(beat_valid_o),
      .ready_i(beat_ready_i),
      .data_o ({beat_last_o, beat_id_o, beat_data_o})
  );

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (rst_ni && !request_ready) begin
      $display("%m: the controller does not take a request in this clock");
      $stop;
    end
    if (rst_ni && ((step_writes && !write_busy_q[step_tag[3:0]]) ||
                   (reads_q[TAGS-1] && !(|(read_busy_q & tag_bit_q))))) begin
      $display("%m: a word without its request");
      $stop;
    end
    if (takes_read && read_last_i >= MOST_BEATS[3:0]) begin
      $display("%m: a read of %0d beats crosses 32 bytes", read_last_i + 1);
      $stop;
    end
  end
`else
  wire unused = &{1'b0, request_ready};
`endif
  // The address's lowest bits are zeros, and what is bounded has room.
  wire unused_always = &{1'b0, step_word, step_q, beat_room, fires, stalls, read_last_i[3:2],
                         read_address_i[1:0], write_address_i[1:0]};

endmodule

`default_nettype wire
