// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A core with a port to its memory (hls/units/memory_port.h), its registers and its sequencer: the
// heart of every board whose memory is not in banks of SRAM. It has neither a window into the
// memory, which the host reaches its own way, nor a scan-out.
//
// A frame is done when all that it writes is in the memory: no write waits and memory_idle_i is
// high. Before the core leaves its reset, memory_idle_i has to be high too, so that no answer comes
// to it that it has not asked for.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_port_board #(
  // Those of fast_port; another core takes its own.
  parameter PACKETS = 64,      // packets in flight of the core below
  parameter CACHE_LINES = 512, // lines of each of its caches
  parameter SCAN_OUT = 0,
  parameter READ_BACK = 1,           // see board_registers.v
  parameter MEMORY_BASE_BITS = 0,    // of an address on the memory's bus; 0: there is no bus
  parameter [63:0] MEMORY_BASE = 64'd0 // where the memory begins on it, after a reset
) (
  input  wire             clk_i,
  input  wire             core_clk_i, // as that of dynrt_board.v
  output wire             core_clk_en_o,
  input  wire             rst_ni,
  // bus, see board_registers.v
  input  wire             bus_valid_i,
  input  wire             bus_write_i,
  input  wire [25:0]      bus_addr_i,
  input  wire [31:0]      bus_wdata_i,
  output wire             bus_ready_o,
  output wire             bus_exists_o,
  output wire             bus_rvalid_o,
  output wire [31:0]      bus_rdata_o,
  output wire             irq_o,
  // scan-out, see board_registers.v
  output wire [7:0]       scan_clocks_o,
  output wire [32*`DYNRT_CORE_SCAN_WORDS-1:0] scan_o,
  input  wire [19:0]      scan_shown_i,
  input  wire [31:0]      scan_frames_i,
  input  wire             scan_missed_i,
  // memory
  output wire             memory_read_valid_o,
  input  wire             memory_read_ready_i,
  output wire [`DYNRT_CORE_MEMORY_ID_BITS-1:0] memory_read_id_o,
  output wire [23:0]      memory_read_address_o, // of the first byte
  output wire [3:0]       memory_read_last_o,    // beats less one
  input  wire             memory_beat_valid_i,
  output wire             memory_beat_ready_o,
  input  wire [`DYNRT_CORE_MEMORY_ID_BITS-1:0] memory_beat_id_i,
  input  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] memory_beat_data_i,
  input  wire             memory_beat_last_i,
  output wire             memory_write_valid_o,
  input  wire             memory_write_ready_i,
  output wire [24:0]      memory_write_address_o, // of the first byte
  output wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] memory_write_data_o,
  output wire [`DYNRT_CORE_MEMORY_BEAT_BYTES/2-1:0] memory_write_mask_o, // halves to be written
  output wire [2:0]       memory_write_left_o,    // beats of its burst that follow
  // whatever stands behind the port
  input  wire             memory_idle_i, // nothing that it has taken is under way
  output wire             memory_stop_o, // the core is in reset and wants no answers
  output wire [63:0]      memory_base_o,
  input  wire             memory_error_i, // a pulse: an access was answered with an error
  input  wire             memory_error_write_i,
  input  wire [1:0]       memory_error_response_i,
  input  wire [24:0]      memory_error_address_i
);

  // Registers that describe a frame (hls/units/frame.h).
  localparam FRAME_WORDS = `DYNRT_CORE_FRAME_BITS / 32;

  wire        start, reset, busy, done;
  wire [63:0] cycles;
  wire [32*FRAME_WORDS-1:0] frame;
  wire [7:0]  counter_addr;
  wire [31:0] counter_data;
  wire        counter_fetch;
  wire        counter_clear;
  wire        core_rst_n;
  wire        start_valid, start_ready;
  wire [9:0]  start_data;
  wire        done_valid, done_ready;
  wire [8:0]  last_packet, last_line;
  wire        written = memory_idle_i && !memory_write_valid_o;

  assign core_clk_en_o = !rst_ni || busy || counter_fetch;
  assign memory_stop_o = !core_rst_n;

  board_registers #(
    .PACKETS(PACKETS), .CACHE_LINES(CACHE_LINES), .FRAME_WORDS(FRAME_WORDS), .SCAN_OUT(SCAN_OUT),
    .READ_BACK(READ_BACK), .WINDOW(0), .MEMORY_BASE_BITS(MEMORY_BASE_BITS),
    .MEMORY_BASE(MEMORY_BASE)
  ) registers (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .bus_valid_i(bus_valid_i), .bus_write_i(bus_write_i), .bus_addr_i(bus_addr_i),
    .bus_wdata_i(bus_wdata_i), .bus_ready_o(bus_ready_o), .bus_exists_o(bus_exists_o),
    .bus_rvalid_o(bus_rvalid_o), .bus_rdata_o(bus_rdata_o), .irq_o(irq_o),
    .start_o(start), .reset_o(reset), .last_packet_o(last_packet),
    .last_line_o(last_line), .busy_i(busy), .done_i(done), .cycles_i(cycles),
    .frame_o(frame), .counter_addr_o(counter_addr), .counter_data_i(counter_data),
    .counter_fetch_o(counter_fetch),
    .scan_clocks_o(scan_clocks_o), .scan_o(scan_o), .scan_shown_i(scan_shown_i),
    .scan_frames_i(scan_frames_i), .scan_en_i(1'b0), .scan_missed_i(scan_missed_i),
    .memory_error_i(memory_error_i), .memory_error_write_i(memory_error_write_i),
    .memory_error_response_i(memory_error_response_i),
    .memory_error_address_i(memory_error_address_i), .memory_base_o(memory_base_o),
    .window_en_o(), .window_we_o(), .window_addr_o(), .window_wdata_o(), .window_rdata_i(192'd0)
  );

  board_sequencer sequencer (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .start_i(start), .reset_i(reset), .ready_i(memory_idle_i), .last_line_i(last_line),
    .last_packet_i(last_packet), .busy_o(busy), .done_o(done), .cycles_o(cycles),
    .core_rst_no(core_rst_n), .counter_clear_o(counter_clear),
    .start_valid_o(start_valid), .start_ready_i(start_ready), .start_data_o(start_data),
    .done_valid_i(done_valid && written), .done_ready_o(done_ready)
  );

  // Only the arrival of the done token counts, not its data.
  dynrt_core core (
    .clk_i(core_clk_i), .rst_ni(core_rst_n),
    .start_valid_i(start_valid), .start_ready_o(start_ready), .start_data_i(start_data),
    .done_valid_o(done_valid), .done_ready_i(done_ready && written), .done_data_o(),
    .frame_i(frame),
    .memory_read_valid_o(memory_read_valid_o), .memory_read_ready_i(memory_read_ready_i),
    .memory_read_data_o({memory_read_last_o, memory_read_address_o, memory_read_id_o}),
    .memory_beat_valid_i(memory_beat_valid_i), .memory_beat_ready_o(memory_beat_ready_o),
    .memory_beat_data_i({memory_beat_last_i, memory_beat_data_i, memory_beat_id_i}),
    .memory_write_valid_o(memory_write_valid_o), .memory_write_ready_i(memory_write_ready_i),
    .memory_write_data_o({memory_write_left_o, memory_write_mask_o, memory_write_data_o,
                          memory_write_address_o}),
    .counter_addr_i(counter_addr), .counter_data_o(counter_data), .counter_clear_i(counter_clear)
  );

endmodule

`default_nettype wire
