// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board as its bus sees it: registers and the window into the SRAM (dynrt_registers.vh).
//
// A word is transferred in every clock in which bus_valid_i and bus_ready_o are high. Reads are
// pipelined and answered in order, each SRAM_LATENCY + 2 clocks after it was accepted, so a burst
// of reads moves a word a clock as well. The bus waits while the scan-out reads the SRAM, a clock,
// and for two clocks behind a write to CONTROL. A register is written a clock after the bus wrote it,
// CONTROL two; a read sees every write before it, and none behind it.
`default_nettype none
`include "dynrt_core.vh"

module board_registers #(
  parameter PACKETS = 64,
  parameter CACHE_LINES = 512,
  parameter FRAME_WORDS = `DYNRT_CORE_FRAME_BITS / 32, // at most 2^FRAME_WORD_BITS of the register map
  parameter SCAN_WORDS = `DYNRT_CORE_SCAN_WORDS,       // at most 16
  parameter SRAM_LATENCY = 3, // 3 to 8
  parameter SCAN_OUT = 1,     // 1: there is a scan-out
  parameter READ_BACK = 1,    // 1: FRAME and SCAN can be read; 0: they read as zero
  parameter WINDOW = 1,       // 1: there is a window into the SRAM; 0: its words are not there
  parameter MEMORY_BASE_BITS = 0, // bits of an address on the memory's bus, at most 64; 0: no such bus
  parameter [63:0] MEMORY_BASE = 64'd0 // where the memory begins on it, after a reset
) (
  input  wire        clk_i,
  input  wire        rst_ni,
  // bus
  input  wire        bus_valid_i,
  input  wire        bus_write_i,
  input  wire [25:0] bus_addr_i,
  input  wire [31:0] bus_wdata_i,
  output wire        bus_ready_o,
  output wire        bus_exists_o, // there is something at bus_addr_i
  output reg         bus_rvalid_o,
  output reg  [31:0] bus_rdata_o,
  output wire        irq_o,
  // sequencer
  output wire        start_o,
  output wire        reset_o,
  output reg  [8:0]  last_packet_o, // of the frame, as the next
  output wire [8:0]  last_line_o,
  input  wire        busy_i,
  input  wire        done_i,      // a pulse at the end of a frame
  input  wire [63:0] cycles_i,
  // core
  output wire [32*FRAME_WORDS-1:0] frame_o,
  output reg  [7:0]  counter_addr_o,
  input  wire [31:0] counter_data_i,
  output wire        counter_fetch_o, // the core needs its clock to fetch a counter
  // scan-out
  output reg  [7:0]  scan_clocks_o,
  output wire [32*SCAN_WORDS-1:0] scan_o,
  input  wire [19:0] scan_shown_i,
  input  wire [31:0] scan_frames_i,
  input  wire        scan_en_i,       // it reads the SRAM in this clock
  input  wire        scan_missed_i,   // it has missed pixels since it was switched on
  // the memory's bus: an access that was answered with an error; where the memory begins
  input  wire        memory_error_i, // a pulse
  input  wire        memory_error_write_i,
  input  wire [1:0]  memory_error_response_i,
  input  wire [24:0] memory_error_address_i,
  output wire [63:0] memory_base_o,
  // SRAM window; rdata_i belongs to the read SRAM_LATENCY clocks earlier
  output wire [5:0]  window_en_o,
  output wire        window_we_o,
  output wire [19:0] window_addr_o,
  output wire [31:0] window_wdata_o,
  input  wire [6*32-1:0] window_rdata_i
);

`include "dynrt_registers.vh"

  // Clocks that the core gets to fetch a counter, which takes three; no more than a read takes to be
  // answered.
  localparam [2:0] COUNTER_CLOCKS = 3'd4;
  localparam BANKS = 6;

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (SRAM_LATENCY < 3 || SRAM_LATENCY > 8) begin : bad_latency
      board_registers_SRAM_LATENCY_must_be_3_to_8 stop ();
    end
  endgenerate

  // Decode.
  wire        accept = bus_valid_i && bus_ready_o;
  wire        write = accept && bus_write_i;
  wire        read = accept && !bus_write_i;
  wire        in_window = bus_addr_i[WINDOW_BIT];
  wire [2:0]  bank = bus_addr_i[WINDOW_BANK_LOW +: 3];
  wire        bank_exists = bank < BANKS[2:0];
  wire        in_frame = bus_addr_i[25:FRAME_WORD_BITS+2] == REG_FRAME[25:FRAME_WORD_BITS+2];
  wire        in_scan = SCAN_OUT != 0 && bus_addr_i[25:6] == REG_SCAN[25:6];

  wire in_registers = bus_addr_i <= REG_SCAN_FRAMES;
  wire of_memory = MEMORY_BASE_BITS != 0 && bus_addr_i >= REG_MEMORY_ERROR &&
                   bus_addr_i <= REG_MEMORY_BASE_HIGH;
  assign bus_exists_o = in_registers || of_memory || (WINDOW != 0 && in_window && bank_exists) ||
                        (in_frame && {26'd0, bus_addr_i[2 +: FRAME_WORD_BITS]} < FRAME_WORDS) ||
                        (in_scan && {28'd0, bus_addr_i[5:2]} < SCAN_WORDS);
  wire window_ok = WINDOW != 0 && in_window && bank_exists && !busy_i;
  assign window_en_o = accept && window_ok ? 6'd1 << bank : 6'd0;
  assign window_we_o = bus_write_i;
  assign window_addr_o = bus_addr_i[WINDOW_WORD_LOW +: 20];
  assign window_wdata_o = bus_wdata_i;

  // What the bus writes waits for a clock, so that neither its pins nor the words of a frame are far
  // from where the address is compared. CONTROL waits for another, until it is known whether the core
  // can render the frame that was written before it; the bus waits with it.
  reg        write_q;
  reg [25:0] write_addr_q;
  reg [31:0] write_data_q;
  reg [FRAME_WORDS-1:0] write_frame_q; // the word that is written
  reg [SCAN_WORDS-1:0]  write_scan_q;
  reg        control_q;
  reg        control_waits_q;
  reg        asks_start_q;
  reg        asks_reset_q;
  reg        frame_ok_q; // the core can render the frame
  assign start_o = asks_start_q && !busy_i && frame_ok_q;
  assign reset_o = asks_reset_q;
  assign bus_ready_o = !scan_en_i && !control_q && !control_waits_q;

  integer i;
  always @(posedge clk_i) begin
    write_q <= write && !in_window;
    write_addr_q <= bus_addr_i;
    write_data_q <= bus_wdata_i;
    for (i = 0; i < FRAME_WORDS; i = i + 1)
      write_frame_q[i] <=
          write && in_frame && bus_addr_i[2 +: FRAME_WORD_BITS] == i[FRAME_WORD_BITS-1:0];
    for (i = 0; i < SCAN_WORDS; i = i + 1)
      write_scan_q[i] <= write && in_scan && bus_addr_i[5:2] == i[3:0];
    control_q <= write && bus_addr_i == REG_CONTROL;
    control_waits_q <= control_q;
    asks_start_q <= control_q && write_data_q[CONTROL_START];
    asks_reset_q <= control_q && write_data_q[CONTROL_RESET];
    if (!rst_ni) begin
      write_q <= 1'b0;
      write_frame_q <= {FRAME_WORDS{1'b0}};
      write_scan_q <= {SCAN_WORDS{1'b0}};
      control_q <= 1'b0;
      control_waits_q <= 1'b0;
      asks_start_q <= 1'b0;
      asks_reset_q <= 1'b0;
    end
  end

  wire       writes_base_low = write_q && write_addr_q == REG_MEMORY_BASE_LOW;
  wire       writes_base_high = write_q && write_addr_q == REG_MEMORY_BASE_HIGH;
  wire refuse = (accept && in_window && !window_ok) || (asks_start_q && !start_o) ||
                ((|write_frame_q || writes_base_low || writes_base_high) && busy_i);

  // State.
  reg                      irq_enable_q;
  reg                      irq_pending_q;
  reg                      done_q;
  reg                      refused_q;
  reg [32*FRAME_WORDS-1:0] frame_q;
  reg [2:0]                fetch_q;
  reg [32*SCAN_WORDS-1:0]  scan_q;

  // No interrupt follows a reset, not even of a frame that ends while the reset waits.
  assign irq_o = irq_enable_q && irq_pending_q && !asks_reset_q &&
                 !(control_q && write_data_q[CONTROL_RESET]);
  assign frame_o = frame_q;
  assign counter_fetch_o = fetch_q != 3'd0;
  assign scan_o = scan_q;

  // The packets and the cache lines that the frame uses. A mask below CACHE_LINES has ones in its
  // lowest 9 bits alone.
  wire [31:0] packets = frame_q[`DYNRT_CORE_FRAME_PACKETS +: 32];
  wire [31:0] line_mask = frame_q[`DYNRT_CORE_FRAME_LINE_MASK +: 32];
  wire [8:0]  next_line = last_line_o + 9'd1;
  assign last_line_o = line_mask[8:0];
  always @(posedge clk_i) begin
    last_packet_o <= packets[8:0] - 9'd1;
    frame_ok_q <= packets[31:9] == 23'd0 && packets[8:0] != 9'd0 &&
                  {23'd0, packets[8:0]} <= PACKETS &&
                  line_mask[31:9] == 23'd0 && {23'd0, last_line_o} < CACHE_LINES &&
                  (last_line_o & next_line) == 9'd0;
  end

  // The first error of the memory's bus, until the host has seen it.
  reg        error_q;
  reg        error_write_q;
  reg [1:0]  error_response_q;
  reg [24:0] error_address_q;
  reg [63:0] base_q;
  localparam [63:0] BASE_MASK =
      MEMORY_BASE_BITS == 0 ? 64'd0 : (~64'd0 >> (64 - MEMORY_BASE_BITS)) & ~64'h1ffffff;
  assign memory_base_o = base_q;
  wire clears_error = write_q && write_addr_q == REG_MEMORY_ERROR && write_data_q[MEMORY_ERROR_SEEN];
  always @(posedge clk_i) begin
    if (memory_error_i && (!error_q || clears_error)) begin
      error_q <= 1'b1;
      error_write_q <= memory_error_write_i;
      error_response_q <= memory_error_response_i;
      error_address_q <= memory_error_address_i;
    end else if (clears_error) begin
      error_q <= 1'b0;
      error_write_q <= 1'b0;
      error_response_q <= 2'd0;
      error_address_q <= 25'd0;
    end
    if (writes_base_low && !busy_i) base_q[31:0] <= write_data_q & BASE_MASK[31:0];
    if (writes_base_high && !busy_i) base_q[63:32] <= write_data_q & BASE_MASK[63:32];
    if (!rst_ni) begin
      error_q <= 1'b0;
      error_write_q <= 1'b0;
      error_response_q <= 2'd0;
      error_address_q <= 25'd0;
      base_q <= MEMORY_BASE & BASE_MASK;
    end
  end

  integer r;
  always @(posedge clk_i) begin
    if (done_i) begin
      irq_pending_q <= 1'b1;
      done_q <= 1'b1;
    end else if (write_q && write_addr_q == REG_IRQ_PENDING && write_data_q[0]) begin
      irq_pending_q <= 1'b0;
    end
    if (refuse) refused_q <= 1'b1;
    if (write_q && write_addr_q == REG_IRQ_ENABLE) irq_enable_q <= write_data_q[0];
    if (write_q && write_addr_q == REG_COUNTER_ADDRESS) begin
      counter_addr_o <= write_data_q[7:0];
      fetch_q <= COUNTER_CLOCKS;
    end else if (fetch_q != 3'd0) begin
      fetch_q <= fetch_q - 3'd1;
    end
    for (r = 0; r < FRAME_WORDS; r = r + 1)
      if (write_frame_q[r] && !busy_i) frame_q[32*r +: 32] <= write_data_q;
    for (r = 0; r < SCAN_WORDS; r = r + 1)
      if (write_scan_q[r]) scan_q[32*r +: 32] <= write_data_q;
    if (write_q && write_addr_q == REG_SCAN_CLOCKS && SCAN_OUT != 0)
      scan_clocks_o <= write_data_q[7:0];
    if (start_o || reset_o) begin
      irq_pending_q <= 1'b0;
      done_q <= 1'b0;
      refused_q <= 1'b0;
    end
    if (!rst_ni) begin
      irq_enable_q <= 1'b0;
      irq_pending_q <= 1'b0;
      done_q <= 1'b0;
      refused_q <= 1'b0;
      frame_q <= {32*FRAME_WORDS{1'b0}};
      counter_addr_o <= 8'd0;
      fetch_q <= 3'd0;
      scan_q <= {32*SCAN_WORDS{1'b0}};
      scan_clocks_o <= 8'd0;
    end
  end

  // A read of a register takes as long as one of the SRAM, so that both answer in order. Stage s
  // holds the read that was accepted s + 1 clocks ago. Stage 0 picks a word of the frame, of the
  // scan-out and of the other registers, stage 1 one of the three; a counter comes in stage 3, three
  // clocks after its address, and a bank's word in the last but one.
  localparam LAST = SRAM_LATENCY, COUNTER_STAGE = 3;
  reg [LAST:0]      wait_valid_q;
  reg [LAST-1:0]    wait_window_q; // of the window and not refused
  reg [26*LAST-1:0] wait_addr_q;
  reg [31:0]        frame_word_q, scan_word_q, register_q; // of stage 1
  reg               picks_frame_q, picks_scan_q, picks_register_q;
  reg               picks_counter_q; // of stage 3
  reg [32*LAST+31:0] value_q;        // from stage 2 on
  wire [25:0] first_addr = wait_addr_q[25:0];
  wire [2:0]  window_bank = wait_addr_q[26*(LAST-1) + WINDOW_BANK_LOW +: 3];
  wire        window_picked = wait_addr_q[26*(LAST-1) + WINDOW_BIT];
  wire [31:0] window_word = window_rdata_i[{5'd0, window_bank} * 8'd32 +: 32];

  reg [31:0] frame_word, scan_word, register;
  integer w;
  always @* begin
    frame_word = 32'd0;
    for (w = 0; w < FRAME_WORDS; w = w + 1)
      if (READ_BACK != 0 && first_addr[2 +: FRAME_WORD_BITS] == w[FRAME_WORD_BITS-1:0])
        frame_word = frame_q[32*w +: 32];
    scan_word = 32'd0;
    for (w = 0; w < SCAN_WORDS; w = w + 1)
      if (READ_BACK != 0 && first_addr[5:2] == w[3:0]) scan_word = scan_q[32*w +: 32];
    register = 32'd0;
    case (first_addr)
      REG_ID: register = ID_VALUE;
      REG_VERSION: register = VERSION_VALUE;
      REG_LIMITS: register = {CACHE_LINES[15:0], PACKETS[15:0]};
      REG_STATUS: begin
        register[STATUS_BUSY] = busy_i;
        register[STATUS_DONE] = done_q;
        register[STATUS_REFUSED] = refused_q;
        register[STATUS_MEMORY_ERROR] = error_q;
        register[STATUS_DISPLAY_MISSED] = scan_missed_i;
      end
      REG_IRQ_ENABLE: register = {31'd0, irq_enable_q};
      REG_IRQ_PENDING: register = {31'd0, irq_pending_q};
      REG_CYCLES_LOW: register = cycles_i[31:0];
      REG_CYCLES_HIGH: register = cycles_i[63:32];
      REG_FRAME_WORDS: register = FRAME_WORDS;
      REG_SCAN_WORDS: register = SCAN_OUT != 0 ? SCAN_WORDS : 32'd0;
      REG_SCAN_CLOCKS: register = {24'd0, scan_clocks_o};
      REG_SCAN_SHOWN: register = {12'd0, scan_shown_i};
      REG_SCAN_FRAMES: register = scan_frames_i;
      REG_MEMORY_ERROR: begin
        register[MEMORY_ERROR_SEEN] = error_q;
        register[MEMORY_ERROR_WRITE] = error_write_q;
        register[MEMORY_ERROR_RESPONSE +: 2] = error_response_q;
      end
      REG_MEMORY_ERROR_ADDRESS: register = {7'd0, error_address_q};
      REG_MEMORY_BASE_LOW: register = base_q[31:0];
      REG_MEMORY_BASE_HIGH: register = base_q[63:32];
      default: register = 32'd0;
    endcase
  end

  // The word of a stage with what comes in it.
  function [31:0] joined(input [31:0] word, input counter, input in_window_now,
                         input [31:0] counter_word, input [31:0] bank_word);
    joined = counter ? counter_word : in_window_now ? bank_word : word;
  endfunction

  integer s;
  always @(posedge clk_i) begin
    wait_valid_q <= {wait_valid_q[LAST-1:0], read};
    wait_window_q <= {wait_window_q[LAST-2:0], window_ok};
    wait_addr_q <= {wait_addr_q[26*(LAST-1)-1:0], bus_addr_i};
    frame_word_q <= frame_word;
    scan_word_q <= scan_word;
    register_q <= register;
    picks_frame_q <= first_addr[25:FRAME_WORD_BITS+2] == REG_FRAME[25:FRAME_WORD_BITS+2];
    picks_scan_q <= first_addr[25:6] == REG_SCAN[25:6];
    picks_register_q <= !first_addr[WINDOW_BIT];
    picks_counter_q <= wait_addr_q[26*(COUNTER_STAGE-1) +: 26] == REG_COUNTER_DATA;
    value_q[32*2 +: 32] <= !picks_register_q ? 32'd0 : picks_frame_q ? frame_word_q
                           : picks_scan_q ? scan_word_q : register_q;
    for (s = 2; s < LAST; s = s + 1)
      value_q[32*(s+1) +: 32] <=
          joined(value_q[32*s +: 32], s == COUNTER_STAGE && picks_counter_q,
                 s == LAST - 1 && window_picked && wait_window_q[LAST-1],
                 counter_data_i, window_word);
    bus_rvalid_o <= wait_valid_q[LAST];
    bus_rdata_o <= joined(value_q[32*LAST +: 32], LAST == COUNTER_STAGE && picks_counter_q, 1'b0,
                          counter_data_i, window_word);
    if (!rst_ni) begin
      wait_valid_q <= {LAST+1{1'b0}};
      bus_rvalid_o <= 1'b0;
    end
  end

endmodule

`default_nettype wire
