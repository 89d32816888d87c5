// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ULX3S: a core with a memory port, the SDRAM behind it, the host on the serial line of the USB
// bridge, and a DVI display of the picture. All of the board but its pads of two directions, which
// dynrt_ulx3s.v has.
//
//   PIXEL_MHZ     25: a display of 640x480, or 40: of 800x600. It sets the core's clock as well
//                 (ulx3s_clocks.v), and with it what a bit on the line takes.
//
// The SDRAM's clock leaves three quarters of a period late. So a command that changes at an edge is
// there before the chip takes it, and stays until it has; and a word that the chip gives after an edge
// of its clock is there around the second edge here that follows (docs/how-to/ulx3s.md has the times).
`default_nettype none
`include "dynrt_core.vh"
`include "dynrt_link.vh"

module ulx3s_board #(
  parameter PACKETS = 64,
  parameter CACHE_LINES = 512,
  parameter [351:0] NAME = "fast_ulx3s",
  parameter [7:0]   PIXEL_MHZ = 8'd25,
  parameter [15:0]  PAUSE_TURNS = 16'd10000    // 200 us at 100 MHz
) (
  input  wire        clk_25mhz_i,
  input  wire        button_ni,
  input  wire        serial_i,
  output wire        serial_o,
  output wire [7:0]  led_o,
  output wire        sdram_clk_o,
  output wire        sdram_cke_o,
  output wire        sdram_cs_no,
  output wire        sdram_ras_no,
  output wire        sdram_cas_no,
  output wire        sdram_we_no,
  output wire [1:0]  sdram_bank_o,
  output wire [12:0] sdram_addr_o,
  output wire [1:0]  sdram_dqm_o,
  output wire [15:0] sdram_dq_float_o,
  output wire [15:0] sdram_dq_o,
  input  wire [15:0] sdram_dq_i,
  output wire [3:0]  dvi_p_o,
  output wire [3:0]  dvi_n_o
);

  localparam [31:0] CLOCK_HZ = PIXEL_MHZ == 8'd40 ? 32'd60000000 : 32'd62500000;
  localparam [11:0] DIVISOR = PIXEL_MHZ == 8'd40 ? 12'd20 : 12'd21; // 3 Mbaud, or 2.976
  localparam ID_BITS = `DYNRT_CORE_MEMORY_ID_BITS;
  localparam BEAT_BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES;
  localparam DATA_BITS = 8 * BEAT_BYTES;
  localparam MASK_BITS = BEAT_BYTES / 2;

  generate
    if (`DYNRT_CORE_MEMORY_READ_BEATS * BEAT_BYTES > 32) begin : bad_read
      ulx3s_board_needs_a_core_whose_reads_have_at_most_32_bytes stop ();
    end
  endgenerate

  wire clk, host_rst_n, core_rst_n, memory_rst_n, display_rst_n;
  wire sdram_clk, sdram_pin_clk, sdram_rst_n, dvi_clk, dvi_rst_n;
  ulx3s_clocks #(.PIXEL_MHZ(PIXEL_MHZ)) clocks (
    .osc_i(clk_25mhz_i), .rst_ni(button_ni), .clk_o(clk), .host_rst_no(host_rst_n),
    .core_rst_no(core_rst_n), .memory_rst_no(memory_rst_n), .display_rst_no(display_rst_n),
    .sdram_clk_o(sdram_clk), .sdram_pin_clk_o(sdram_pin_clk), .sdram_rst_no(sdram_rst_n),
    .dvi_clk_o(dvi_clk), .dvi_rst_no(dvi_rst_n)
  );

  // The host.
  wire                 bus_valid, bus_write, bus_ready;
  wire [25:0]          bus_addr;
  wire [31:0]          bus_wdata;
  wire                 host_write_valid, host_write_ready, host_write_last;
  wire [24:0]          host_write_address;
  wire [DATA_BITS-1:0] host_write_data;
  wire [MASK_BITS-1:0] host_write_mask;
  wire                 host_read_valid, host_read_ready;
  wire [24:0]          host_read_address;
  wire [3:0]           host_read_last;
  wire                 host_beat_valid, host_beat_ready, host_beat_last;
  wire                 answer_valid, answer_ready, answer_last;
  wire [DATA_BITS-1:0] answer_data;
  hls_buffer #(.WIDTH(1 + DATA_BITS)) answer (
    .clk_i(clk), .rst_ni(host_rst_n),
    .valid_i(host_beat_valid), .ready_o(host_beat_ready), .data_i({host_beat_last, beat_data}),
    .valid_o(answer_valid), .ready_i(answer_ready), .data_o({answer_last, answer_data})
  );
  board_link #(
    .CLOCK_HZ(CLOCK_HZ), .DIVISOR(DIVISOR), .MEMORY_BYTES(32'd33554432), .NAME(NAME),
    .PIXEL_MHZ(PIXEL_MHZ)
  ) host (
    .clk_i(clk), .rst_ni(host_rst_n), .rx_i(serial_i), .tx_o(serial_o),
    .write_valid_o(host_write_valid), .write_ready_i(host_write_ready),
    .write_data_o({host_write_last, host_write_mask, host_write_data, host_write_address}),
    .read_valid_o(host_read_valid), .read_ready_i(host_read_ready),
    .read_data_o({host_read_last, host_read_address}),
    .beat_valid_i(answer_valid), .beat_ready_o(answer_ready),
    .beat_data_i({answer_last, answer_data}),
    .bus_valid_o(bus_valid), .bus_write_o(bus_write), .bus_addr_o(bus_addr),
    .bus_wdata_o(bus_wdata), .bus_ready_i(bus_ready), .bus_rvalid_i(rvalid_q),
    .bus_rdata_i(rdata_q)
  );

  // Its accesses of registers, which wait for a clock on the way to the core and back.
  wire                 core_bus_valid, core_bus_write, core_bus_ready, core_bus_rvalid;
  wire [25:0]          core_bus_addr;
  wire [31:0]          core_bus_wdata, core_bus_rdata;
  reg                  rvalid_q;
  reg  [31:0]          rdata_q;
  hls_buffer #(.WIDTH(1 + 26 + 32)) access (
    .clk_i(clk), .rst_ni(core_rst_n),
    .valid_i(bus_valid), .ready_o(bus_ready), .data_i({bus_write, bus_addr, bus_wdata}),
    .valid_o(core_bus_valid), .ready_i(core_bus_ready),
    .data_o({core_bus_write, core_bus_addr, core_bus_wdata})
  );
  always @(posedge clk) begin
    rvalid_q <= host_rst_n && core_bus_rvalid;
    rdata_q <= core_bus_rdata;
  end

  // The core.
  wire                 irq, core_stop, core_idle, core_clk_en;
  wire                 core_read_valid, core_read_ready;
  wire [ID_BITS-1:0]   core_read_id;
  wire [23:0]          core_read_address;
  wire [3:0]           core_read_last;
  wire                 core_beat_valid, core_beat_ready;
  wire                 core_write_valid, core_write_ready;
  wire [24:0]          core_write_address;
  wire [DATA_BITS-1:0] core_write_data;
  wire [MASK_BITS-1:0] core_write_mask;
  wire [2:0]           core_write_left;
  wire [7:0]           scan_clocks;
  wire [32*`DYNRT_CORE_SCAN_WORDS-1:0] scan;
  wire [19:0]          scan_shown;
  wire [31:0]          scan_frames;
  wire                 starved, underrun;
  wire                 missed = underrun || starved;
  // A bit of a frame that the core does not use has no register then, and no wire to it.
  dynrt_port_board #(
    .PACKETS(PACKETS), .CACHE_LINES(CACHE_LINES), .SCAN_OUT(1), .READ_BACK(0)
  ) core (
    .clk_i(clk), .core_clk_i(clk), .core_clk_en_o(core_clk_en), .rst_ni(core_rst_n),
    .bus_valid_i(core_bus_valid), .bus_write_i(core_bus_write), .bus_addr_i(core_bus_addr),
    .bus_wdata_i(core_bus_wdata), .bus_ready_o(core_bus_ready), .bus_exists_o(),
    .bus_rvalid_o(core_bus_rvalid), .bus_rdata_o(core_bus_rdata), .irq_o(irq),
    .scan_clocks_o(scan_clocks), .scan_o(scan), .scan_shown_i(scan_shown),
    .scan_frames_i(scan_frames), .scan_missed_i(missed),
    .memory_read_valid_o(core_read_valid), .memory_read_ready_i(core_read_ready),
    .memory_read_id_o(core_read_id), .memory_read_address_o(core_read_address),
    .memory_read_last_o(core_read_last),
    .memory_beat_valid_i(core_beat_valid), .memory_beat_ready_o(core_beat_ready),
    .memory_beat_id_i(beat_id), .memory_beat_data_i(beat_data), .memory_beat_last_i(beat_last),
    .memory_write_valid_o(core_write_valid), .memory_write_ready_i(core_write_ready),
    .memory_write_address_o(core_write_address), .memory_write_data_o(core_write_data),
    .memory_write_mask_o(core_write_mask), .memory_write_left_o(core_write_left),
    .memory_idle_i(core_idle), .memory_stop_o(core_stop), .memory_base_o(),
    .memory_error_i(1'b0), .memory_error_write_i(1'b0), .memory_error_response_i(2'd0),
    .memory_error_address_i(25'd0)
  );

  // The memory.
  wire                 display_read_valid, display_read_ready;
  wire [24:0]          display_read_address;
  wire [3:0]           display_read_last;
  wire                 display_beat_valid, display_beat_ready;
  wire [ID_BITS-1:0]   beat_id;
  wire [DATA_BITS-1:0] beat_data;
  wire                 beat_last;
  wire                 read_valid, read_ready, all_valid, all_ready, all_last;
  wire [ID_BITS+1:0]   read_id, all_id;
  wire [24:0]          read_address;
  wire [3:0]           read_last;
  wire [DATA_BITS-1:0] all_data;
  wire                 write_valid, write_ready, writes_idle;
  wire [24:0]          write_address;
  wire [DATA_BITS-1:0] write_data;
  wire [MASK_BITS-1:0] write_mask;
  memory_switch #(.ID_BITS(ID_BITS), .BEAT_BYTES(BEAT_BYTES)) switch (
    .clk_i(clk), .rst_ni(memory_rst_n),
    .display_read_valid_i(display_read_valid), .display_read_ready_o(display_read_ready),
    .display_read_address_i(display_read_address), .display_read_last_i(display_read_last),
    .display_beat_valid_o(display_beat_valid), .display_beat_ready_i(display_beat_ready),
    .core_stop_i(core_stop), .core_idle_o(core_idle),
    .core_read_valid_i(core_read_valid), .core_read_ready_o(core_read_ready),
    .core_read_id_i(core_read_id), .core_read_address_i(core_read_address),
    .core_read_last_i(core_read_last),
    .core_beat_valid_o(core_beat_valid), .core_beat_ready_i(core_beat_ready),
    .core_write_valid_i(core_write_valid), .core_write_ready_o(core_write_ready),
    .core_write_address_i(core_write_address), .core_write_data_i(core_write_data),
    .core_write_mask_i(core_write_mask),
    .host_read_valid_i(host_read_valid), .host_read_ready_o(host_read_ready),
    .host_read_address_i(host_read_address), .host_read_last_i(host_read_last),
    .host_beat_valid_o(host_beat_valid), .host_beat_last_o(host_beat_last),
    .host_beat_ready_i(host_beat_ready),
    .host_write_valid_i(host_write_valid), .host_write_ready_o(host_write_ready),
    .host_write_address_i(host_write_address), .host_write_data_i(host_write_data),
    .host_write_mask_i(host_write_mask),
    .beat_id_o(beat_id), .beat_data_o(beat_data), .beat_last_o(beat_last),
    .read_valid_o(read_valid), .read_ready_i(read_ready), .read_id_o(read_id),
    .read_address_o(read_address), .read_last_o(read_last),
    .beat_valid_i(all_valid), .beat_ready_o(all_ready), .beat_id_i(all_id),
    .beat_data_i(all_data), .beat_last_i(all_last),
    .write_valid_o(write_valid), .write_ready_i(write_ready), .write_address_o(write_address),
    .write_data_o(write_data), .write_mask_o(write_mask), .writes_idle_i(writes_idle)
  );
  ulx3s_memory #(
    .ID_BITS(ID_BITS + 2), .BEAT_BYTES(BEAT_BYTES), .PAUSE_TURNS(PAUSE_TURNS)
  ) memory (
    .clk_i(clk), .rst_ni(memory_rst_n),
    .read_valid_i(read_valid), .read_ready_o(read_ready), .read_id_i(read_id),
    .read_address_i(read_address), .read_last_i(read_last),
    .beat_valid_o(all_valid), .beat_ready_i(all_ready), .beat_id_o(all_id),
    .beat_data_o(all_data), .beat_last_o(all_last),
    .write_valid_i(write_valid), .write_ready_o(write_ready), .write_address_i(write_address),
    .write_data_i(write_data), .write_mask_i(write_mask), .writes_idle_o(writes_idle),
    .sdram_clk_i(sdram_clk), .sdram_rst_ni(sdram_rst_n),
    .sdram_ras_no(sdram_ras_no), .sdram_cas_no(sdram_cas_no), .sdram_we_no(sdram_we_no),
    .sdram_ba_o(sdram_bank_o), .sdram_a_o(sdram_addr_o), .sdram_dqm_o(sdram_dqm_o),
    .sdram_dq_float_o(sdram_dq_float_o), .sdram_dq_o(sdram_dq_o), .sdram_dq_i(sdram_dq_i)
  );
  assign sdram_cke_o = 1'b1;
  assign sdram_cs_no = 1'b0;
  ODDRX1F sdram_clock (
    .SCLK(sdram_pin_clk), .RST(1'b0), .D0(1'b1), .D1(1'b0), .Q(sdram_clk_o)
  );

  // The display.
  wire        running, begins, bank_en;
  wire [19:0] base, bank_addr;
  wire [31:0] bank_data;
  wire [3:0]  first, second;
  picture_stream picture (
    .clk_i(clk), .rst_ni(display_rst_n), .running_i(running), .config_i(scan), .begins_i(begins),
    .base_i(base), .bank_en_i(bank_en), .bank_data_o(bank_data), .underrun_o(underrun),
    .read_valid_o(display_read_valid), .read_ready_i(display_read_ready),
    .read_address_o(display_read_address), .read_last_o(display_read_last),
    .beat_valid_i(display_beat_valid), .beat_ready_o(display_beat_ready),
    .beat_data_i(beat_data), .beat_last_i(beat_last)
  );
  display_dvi display (
    .clk_i(clk), .rst_ni(display_rst_n), .on_i(scan_clocks != 8'd0), .config_i(scan),
    .running_o(running), .shown_o(scan_shown), .begins_o(begins), .base_o(base),
    .frames_o(scan_frames), .starved_o(starved), .bank_en_o(bank_en), .bank_addr_o(bank_addr),
    .bank_data_i(bank_data), .dvi_clk_i(dvi_clk), .dvi_rst_ni(dvi_rst_n),
    .dvi_first_o(first), .dvi_second_o(second)
  );
  ecp5_dvi_pins pins (
    .clk_i(dvi_clk), .rst_ni(dvi_rst_n), .first_i(first), .second_i(second),
    .dvi_p_o(dvi_p_o), .dvi_n_o(dvi_n_o)
  );

  // Lit from the left: the core works, the host has an interrupt to see, the display has missed
  // pixels, it is switched on.
  assign led_o = {core_clk_en, irq, missed, running, 4'd0};

  wire unused = &{1'b0, host_write_last, core_write_left, bank_addr};

endmodule

`default_nettype wire
