// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Top of the board: the core (dynrt_core, generated) between a register slave with an interrupt and
// six synchronous SRAM banks of 2^20 words of 32 bits; and the scan-out (scan_out, generated),
// which shows the picture in bank 3 while the core works.
//
// core_clk_i is clk_i or, to save power between frames, clk_i behind a clock gate that
// core_clk_en_o opens. The gate must not skew the two clocks.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_board #(
  // Those of the checked-in core, thesis; another core takes its own.
  parameter PACKETS = 32,      // packets in flight of the core below
  parameter CACHE_LINES = 512, // lines of each of its caches
  parameter SCAN_OUT = 1,      // 0: without the scan-out, the VGA pins stay low
  parameter SRAM_LATENCY = 3   // clocks from the core's address to its data; the banks' own plus 2
) (
  input  wire             clk_i,
  input  wire             core_clk_i,
  output wire             core_clk_en_o,
  input  wire             rst_ni,
  // bus, see board_registers.v
  input  wire             bus_valid_i,
  input  wire             bus_write_i,
  input  wire [25:0]      bus_addr_i,
  input  wire [31:0]      bus_wdata_i,
  output wire             bus_ready_o,
  output wire             bus_rvalid_o,
  output wire [31:0]      bus_rdata_o,
  output wire             irq_o,
  // SRAM, bank b in bits 20b+19:20b and 32b+31:32b
  output wire [5:0]       sram_en_o,
  output wire [5:0]       sram_we_o,
  output wire [6*20-1:0]  sram_addr_o,
  output wire [6*32-1:0]  sram_wdata_o,
  input  wire [6*32-1:0]  sram_rdata_i,
`ifdef DYNRT_CORE_MEMORY_ID_BITS
  // the memory of scene, pixels and hits, where the core has a port for it, see
  // hls/units/memory_port.h; the host still finds them in the banks
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
`endif
  // VGA, see board_scan.v
  output wire             vga_clock_o,
  output wire             vga_hsync_o,
  output wire             vga_vsync_o,
  output wire             vga_visible_o,
  output wire [23:0]      vga_colour_o
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
  // No write waits for the memory.
`ifdef DYNRT_CORE_MEMORY_ID_BITS
  wire        written = !memory_write_valid_o;
`else
  wire        written = 1'b1;
`endif

  wire [5:0]      window_en;
  wire            window_we;
  wire [19:0]     window_addr;
  wire [31:0]     window_wdata;
  wire [6*32-1:0] rdata;
  wire [5:0]      core_en;
  wire [6*20-1:0] core_addr;
  wire [3*32-1:0] core_wdata;

  wire [7:0]       scan_clocks;
  wire [32*`DYNRT_CORE_SCAN_WORDS-1:0] scan;
  wire [19:0]      scan_shown;
  wire [31:0]      scan_frames;
  wire             scan_en;
  wire [19:0]      scan_addr;

  wire [8:0]  last_packet, last_line;

  assign core_clk_en_o = !rst_ni || busy || counter_fetch;

  board_registers #(
    .PACKETS(PACKETS), .CACHE_LINES(CACHE_LINES), .FRAME_WORDS(FRAME_WORDS),
    .SRAM_LATENCY(SRAM_LATENCY), .SCAN_OUT(SCAN_OUT)
  ) registers (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .bus_valid_i(bus_valid_i), .bus_write_i(bus_write_i), .bus_addr_i(bus_addr_i),
    .bus_wdata_i(bus_wdata_i), .bus_ready_o(bus_ready_o), .bus_exists_o(),
    .bus_rvalid_o(bus_rvalid_o), .bus_rdata_o(bus_rdata_o), .irq_o(irq_o),
    .start_o(start), .reset_o(reset), .last_packet_o(last_packet),
    .last_line_o(last_line), .busy_i(busy), .done_i(done), .cycles_i(cycles),
    .frame_o(frame), .counter_addr_o(counter_addr), .counter_data_i(counter_data),
    .counter_fetch_o(counter_fetch),
    .scan_clocks_o(scan_clocks), .scan_o(scan), .scan_shown_i(scan_shown),
    .scan_frames_i(scan_frames), .scan_en_i(scan_en), .scan_missed_i(1'b0),
    .memory_error_i(1'b0), .memory_error_write_i(1'b0), .memory_error_response_i(2'd0),
    .memory_error_address_i(25'd0), .memory_base_o(),
    .window_en_o(window_en), .window_we_o(window_we), .window_addr_o(window_addr),
    .window_wdata_o(window_wdata), .window_rdata_i(rdata)
  );

  board_sequencer sequencer (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .start_i(start), .reset_i(reset), .ready_i(1'b1), .last_line_i(last_line),
    .last_packet_i(last_packet), .busy_o(busy), .done_o(done), .cycles_o(cycles),
    .core_rst_no(core_rst_n), .counter_clear_o(counter_clear),
    .start_valid_o(start_valid), .start_ready_i(start_ready), .start_data_o(start_data),
    .done_valid_i(done_valid && written), .done_ready_o(done_ready)
  );

  board_sram sram (
    .clk_i(clk_i), .rst_ni(rst_ni), .core_owns_i(busy),
    .core_en_i(core_en), .core_addr_i(core_addr), .core_wdata_i(core_wdata),
    .scan_en_i(scan_en), .scan_addr_i(scan_addr),
    .window_en_i(window_en), .window_we_i(window_we), .window_addr_i(window_addr),
    .window_wdata_i(window_wdata), .rdata_o(rdata),
    .sram_en_o(sram_en_o), .sram_we_o(sram_we_o), .sram_addr_o(sram_addr_o),
    .sram_wdata_o(sram_wdata_o), .sram_rdata_i(sram_rdata_i)
  );

`ifdef DYNRT_CORE_MEMORY_ID_BITS
  assign core_en = 6'd0;
  assign core_addr = 120'd0;
  assign core_wdata = 96'd0;
`endif

  // Only the arrival of the done token counts, not its data.
  dynrt_core core (
    .clk_i(core_clk_i), .rst_ni(core_rst_n),
    .start_valid_i(start_valid), .start_ready_o(start_ready), .start_data_i(start_data),
    .done_valid_o(done_valid), .done_ready_i(done_ready && written), .done_data_o(),
    .frame_i(frame),
`ifdef DYNRT_CORE_MEMORY_ID_BITS
    .memory_read_valid_o(memory_read_valid_o), .memory_read_ready_i(memory_read_ready_i),
    .memory_read_data_o({memory_read_last_o, memory_read_address_o, memory_read_id_o}),
    .memory_beat_valid_i(memory_beat_valid_i), .memory_beat_ready_o(memory_beat_ready_o),
    .memory_beat_data_i({memory_beat_last_i, memory_beat_data_i, memory_beat_id_i}),
    .memory_write_valid_o(memory_write_valid_o), .memory_write_ready_i(memory_write_ready_i),
    .memory_write_data_o({memory_write_left_o, memory_write_mask_o, memory_write_data_o,
                          memory_write_address_o}),
`else
    .bank0_en_o(core_en[0]), .bank0_addr_o(core_addr[19:0]), .bank0_data_i(rdata[31:0]),
    .bank1_en_o(core_en[1]), .bank1_addr_o(core_addr[39:20]), .bank1_data_i(rdata[63:32]),
    .bank2_en_o(core_en[2]), .bank2_addr_o(core_addr[59:40]), .bank2_data_i(rdata[95:64]),
    .bank3_en_o(core_en[3]), .bank3_addr_o(core_addr[79:60]), .bank3_data_o(core_wdata[31:0]),
    .bank4_en_o(core_en[4]), .bank4_addr_o(core_addr[99:80]), .bank4_data_o(core_wdata[63:32]),
    .bank5_en_o(core_en[5]), .bank5_addr_o(core_addr[119:100]), .bank5_data_o(core_wdata[95:64]),
`endif
    .counter_addr_i(counter_addr), .counter_data_o(counter_data), .counter_clear_i(counter_clear)
  );

  generate
    if (SCAN_OUT != 0) begin : with_scan_out
      wire        scan_rst_n;
      wire        tick_valid, tick_ready, tick_data;
      wire        pixel_valid, shown_valid;
      wire [26:0] pixel_data;
      wire [19:0] shown_data;

      board_scan scan_pins (
        .clk_i(clk_i), .rst_ni(rst_ni), .clocks_i(scan_clocks), .shown_o(scan_shown),
        .frames_o(scan_frames), .scan_rst_no(scan_rst_n),
        .tick_valid_o(tick_valid), .tick_data_o(tick_data), .tick_ready_i(tick_ready),
        .pixel_valid_i(pixel_valid), .pixel_data_i(pixel_data),
        .shown_valid_i(shown_valid), .shown_data_i(shown_data),
        .vga_clock_o(vga_clock_o), .vga_hsync_o(vga_hsync_o), .vga_vsync_o(vga_vsync_o),
        .vga_visible_o(vga_visible_o), .vga_colour_o(vga_colour_o)
      );

      // The pins take every pixel.
      scan_out u_scan_out (
        .clk_i(clk_i), .rst_ni(scan_rst_n),
        .tick_valid_i(tick_valid), .tick_ready_o(tick_ready), .tick_data_i(tick_data),
        .config_i(scan),
        .bank_en_o(scan_en), .bank_addr_o(scan_addr), .bank_data_i(rdata[127:96]),
        .pixel_valid_o(pixel_valid), .pixel_ready_i(1'b1), .pixel_data_o(pixel_data),
        .shown_valid_o(shown_valid), .shown_ready_i(1'b1), .shown_data_o(shown_data),
        .fire_o(), .stall_o()
      );
    end else begin : without_scan_out
      assign scan_shown = 20'd0;
      assign scan_frames = 32'd0;
      assign scan_en = 1'b0;
      assign scan_addr = 20'd0;
      assign vga_clock_o = 1'b0;
      assign vga_hsync_o = 1'b0;
      assign vga_vsync_o = 1'b0;
      assign vga_visible_o = 1'b0;
      assign vga_colour_o = 24'd0;
      wire unused = &{1'b0, scan_clocks, scan};
    end
  endgenerate

endmodule

`default_nettype wire
