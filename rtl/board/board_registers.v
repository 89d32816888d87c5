// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board as its bus sees it: registers and the window into the SRAM (dynrt_registers.vh).
//
// A word is transferred in every clock in which bus_valid_i and bus_ready_o are high. Reads are
// pipelined and answered in order, each SRAM_LATENCY + 1 clocks after it was accepted, so a burst
// of reads moves a word a clock as well. The bus waits only while the scan-out reads the SRAM, a clock.
`default_nettype none
`include "dynrt_core.vh"

module board_registers #(
  parameter PACKETS = 64,
  parameter CACHE_LINES = 512,
  parameter FRAME_WORDS = `DYNRT_CORE_FRAME_BITS / 32, // at most 2^FRAME_WORD_BITS of the register map
  parameter SCAN_WORDS = `DYNRT_CORE_SCAN_WORDS,       // at most 16
  parameter SRAM_LATENCY = 3,
  parameter SCAN_OUT = 1      // 1: there is a scan-out
) (
  input  wire        clk_i,
  input  wire        rst_ni,
  // bus
  input  wire        bus_valid_i,
  input  wire        bus_write_i,
  input  wire [25:0] bus_addr_i,
  input  wire [31:0] bus_wdata_i,
  output wire        bus_ready_o,
  output reg         bus_rvalid_o,
  output reg  [31:0] bus_rdata_o,
  output wire        irq_o,
  // sequencer
  output wire        start_o,
  output wire        reset_o,
  input  wire        frame_ok_i,  // the core can render the frame of the FRAME registers
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

  // Decode.
  wire        accept = bus_valid_i && bus_ready_o;
  wire        write = accept && bus_write_i;
  wire        read = accept && !bus_write_i;
  wire        in_window = bus_addr_i[WINDOW_BIT];
  wire [2:0]  bank = bus_addr_i[WINDOW_BANK_LOW +: 3];
  wire        bank_exists = bank < BANKS[2:0];
  wire [FRAME_WORD_BITS-1:0] frame_word = bus_addr_i[2 +: FRAME_WORD_BITS];
  wire        in_frame = bus_addr_i[25:FRAME_WORD_BITS+2] == REG_FRAME[25:FRAME_WORD_BITS+2] &&
                         {1'b0, frame_word} < FRAME_WORDS[FRAME_WORD_BITS:0];
  wire [3:0]  scan_word = bus_addr_i[5:2];
  wire        in_scan = SCAN_OUT != 0 && bus_addr_i[25:6] == REG_SCAN[25:6];
  wire        is_control = write && bus_addr_i == REG_CONTROL;

  wire asks_start = is_control && bus_wdata_i[CONTROL_START];
  assign start_o = asks_start && !busy_i && frame_ok_i;
  assign reset_o = is_control && bus_wdata_i[CONTROL_RESET];

  wire window_ok = in_window && bank_exists && !busy_i;
  assign window_en_o = accept && window_ok ? 6'd1 << bank : 6'd0;
  assign window_we_o = bus_write_i;
  assign window_addr_o = bus_addr_i[WINDOW_WORD_LOW +: 20];
  assign window_wdata_o = bus_wdata_i;
  wire refuse = (accept && (in_window ? !window_ok : bus_write_i && in_frame && busy_i)) ||
                (asks_start && !start_o);

  // State.
  reg                      irq_enable_q;
  reg                      irq_pending_q;
  reg                      done_q;
  reg                      refused_q;
  reg [32*FRAME_WORDS-1:0] frame_q;
  reg [2:0]                fetch_q;
  reg [32*SCAN_WORDS-1:0]  scan_q;

  assign irq_o = irq_enable_q && irq_pending_q;
  assign frame_o = frame_q;
  assign counter_fetch_o = fetch_q != 3'd0;
  assign scan_o = scan_q;
  assign bus_ready_o = !scan_en_i;

  integer i;
  always @(posedge clk_i) begin
    if (done_i) begin
      irq_pending_q <= 1'b1;
      done_q <= 1'b1;
    end else if (write && bus_addr_i == REG_IRQ_PENDING && bus_wdata_i[0]) begin
      irq_pending_q <= 1'b0;
    end
    if (refuse) refused_q <= 1'b1;
    if (write && bus_addr_i == REG_IRQ_ENABLE) irq_enable_q <= bus_wdata_i[0];
    if (write && bus_addr_i == REG_COUNTER_ADDRESS) begin
      counter_addr_o <= bus_wdata_i[7:0];
      fetch_q <= COUNTER_CLOCKS;
    end else if (fetch_q != 3'd0) begin
      fetch_q <= fetch_q - 3'd1;
    end
    if (write && in_frame && !busy_i) begin
      for (i = 0; i < FRAME_WORDS; i = i + 1)
        if (frame_word == i[FRAME_WORD_BITS-1:0]) frame_q[32*i +: 32] <= bus_wdata_i;
    end
    if (write && in_scan) begin
      for (i = 0; i < SCAN_WORDS; i = i + 1)
        if (scan_word == i[3:0]) scan_q[32*i +: 32] <= bus_wdata_i;
    end
    if (write && bus_addr_i == REG_SCAN_CLOCKS && SCAN_OUT != 0)
      scan_clocks_o <= bus_wdata_i[7:0];
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

  // A read of a register takes as long as one of the SRAM, so that both answer in order: stage s
  // holds the read that was accepted s + 1 clocks ago.
  reg [SRAM_LATENCY-1:0]    wait_valid_q;
  reg [SRAM_LATENCY-1:0]    wait_window_q; // of the window and not refused
  reg [26*SRAM_LATENCY-1:0] wait_addr_q;
  wire        answer = wait_valid_q[SRAM_LATENCY-1];
  wire        answer_window = wait_window_q[SRAM_LATENCY-1];
  wire [25:0] answer_addr = wait_addr_q[26*(SRAM_LATENCY-1) +: 26];
  wire [2:0]  answer_bank = answer_addr[WINDOW_BANK_LOW +: 3];
  wire        answer_frame =
      answer_addr[25:FRAME_WORD_BITS+2] == REG_FRAME[25:FRAME_WORD_BITS+2];
  wire        answer_scan = answer_addr[25:6] == REG_SCAN[25:6];

  reg [31:0] status;
  reg [31:0] value;
  integer w;
  always @* begin
    status = 32'd0;
    status[STATUS_BUSY] = busy_i;
    status[STATUS_DONE] = done_q;
    status[STATUS_REFUSED] = refused_q;

    value = 32'd0;
    if (answer_addr[WINDOW_BIT]) begin
      if (answer_window) value = window_rdata_i[{5'd0, answer_bank} * 8'd32 +: 32];
    end else if (answer_frame) begin
      for (w = 0; w < FRAME_WORDS; w = w + 1)
        if (answer_addr[2 +: FRAME_WORD_BITS] == w[FRAME_WORD_BITS-1:0])
          value = frame_q[32*w +: 32];
    end else if (answer_scan) begin
      for (w = 0; w < SCAN_WORDS; w = w + 1)
        if (answer_addr[5:2] == w[3:0]) value = scan_q[32*w +: 32];
    end else begin
      case (answer_addr)
        REG_ID: value = ID_VALUE;
        REG_VERSION: value = VERSION_VALUE;
        REG_LIMITS: value = {CACHE_LINES[15:0], PACKETS[15:0]};
        REG_STATUS: value = status;
        REG_IRQ_ENABLE: value = {31'd0, irq_enable_q};
        REG_IRQ_PENDING: value = {31'd0, irq_pending_q};
        REG_CYCLES_LOW: value = cycles_i[31:0];
        REG_CYCLES_HIGH: value = cycles_i[63:32];
        REG_COUNTER_DATA: value = counter_data_i;
        REG_FRAME_WORDS: value = FRAME_WORDS;
        REG_SCAN_WORDS: value = SCAN_OUT != 0 ? SCAN_WORDS : 32'd0;
        REG_SCAN_CLOCKS: value = {24'd0, scan_clocks_o};
        REG_SCAN_SHOWN: value = {12'd0, scan_shown_i};
        REG_SCAN_FRAMES: value = scan_frames_i;
        default: value = 32'd0;
      endcase
    end
  end

  always @(posedge clk_i) begin
    wait_valid_q <= {wait_valid_q[SRAM_LATENCY-2:0], read};
    wait_window_q <= {wait_window_q[SRAM_LATENCY-2:0], window_ok};
    wait_addr_q <= {wait_addr_q[26*(SRAM_LATENCY-1)-1:0], bus_addr_i};
    bus_rvalid_o <= answer;
    bus_rdata_o <= value;
    if (!rst_ni) begin
      wait_valid_q <= {SRAM_LATENCY{1'b0}};
      bus_rvalid_o <= 1'b0;
    end
  end

endmodule

`default_nettype wire
