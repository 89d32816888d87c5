// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core with a Wishbone B4 manager for its memory, a subordinate for its registers, both
// pipelined, and an interrupt, all on one clock.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_wishbone #(
  // Those of fast_port; another core takes its own.
  parameter PACKETS = 64,      // packets in flight of the core below
  parameter CACHE_LINES = 512, // lines of each of its caches
  parameter ADDRESS_BITS = 32, // of the memory's bus, 26 to 64
  parameter [63:0] MEMORY_BASE = 64'd0, // where the memory begins on it, a multiple of 32 MB
  parameter FLIGHT = 64, // accesses in flight
  parameter TURN = 256   // accesses after which CYC falls
) (
  input  wire clk_i,
  input  wire rst_ni,
  output wire irq_o, // a frame is done, until IRQ_PENDING is cleared
  // registers, see wishbone_registers.v
  input  wire s_wb_cyc_i,
  input  wire s_wb_stb_i,
  input  wire s_wb_we_i,
  input  wire [11:0] s_wb_adr_i,
  input  wire [31:0] s_wb_dat_i,
  input  wire [3:0] s_wb_sel_i,
  output wire s_wb_stall_o,
  output wire s_wb_ack_o,
  output wire s_wb_err_o,
  output wire [31:0] s_wb_dat_o,
  // memory, see wishbone_memory.v
  output wire m_wb_cyc_o,
  output wire m_wb_stb_o,
  output wire m_wb_we_o,
  output wire [ADDRESS_BITS-1:0] m_wb_adr_o,
  output wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_wb_dat_o,
  output wire [`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_wb_sel_o,
  input  wire m_wb_stall_i,
  input  wire m_wb_ack_i,
  input  wire m_wb_err_i,
  input  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_wb_dat_i
);

  wire        bus_valid, bus_write, bus_ready, bus_exists, bus_rvalid;
  wire [25:0] bus_addr;
  wire [31:0] bus_wdata, bus_rdata;
  wire        idle, stop, error, error_write;
  wire [1:0]  error_response;
  wire [24:0] error_address;
  wire [63:0] base;
  wire        core_clk_en;
  wire read_valid;
  wire read_ready;
  wire [`DYNRT_CORE_MEMORY_ID_BITS-1:0] read_id;
  wire [23:0] read_address;
  wire [3:0] read_last;
  wire beat_valid;
  wire beat_ready;
  wire [`DYNRT_CORE_MEMORY_ID_BITS-1:0] beat_id;
  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] beat_data;
  wire beat_last;
  wire write_valid;
  wire write_ready;
  wire [24:0] write_address;
  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] write_data;
  wire [`DYNRT_CORE_MEMORY_BEAT_BYTES/2-1:0] write_mask;
  wire [2:0] write_left;

  wishbone_registers registers (
    .clk_i(clk_i), .rst_ni(rst_ni), .s_wb_cyc_i(s_wb_cyc_i), .s_wb_stb_i(s_wb_stb_i),
    .s_wb_we_i(s_wb_we_i), .s_wb_adr_i(s_wb_adr_i), .s_wb_dat_i(s_wb_dat_i),
    .s_wb_sel_i(s_wb_sel_i), .s_wb_stall_o(s_wb_stall_o), .s_wb_ack_o(s_wb_ack_o),
    .s_wb_err_o(s_wb_err_o), .s_wb_dat_o(s_wb_dat_o), .bus_valid_o(bus_valid),
    .bus_write_o(bus_write), .bus_addr_o(bus_addr), .bus_wdata_o(bus_wdata),
    .bus_ready_i(bus_ready), .bus_exists_i(bus_exists), .bus_rvalid_i(bus_rvalid),
    .bus_rdata_i(bus_rdata)
  );

  dynrt_port_board #(
    .PACKETS(PACKETS), .CACHE_LINES(CACHE_LINES), .MEMORY_BASE_BITS(ADDRESS_BITS),
    .MEMORY_BASE(MEMORY_BASE)
  ) board (
    .clk_i(clk_i), .core_clk_i(clk_i), .core_clk_en_o(core_clk_en), .rst_ni(rst_ni),
    .bus_valid_i(bus_valid), .bus_write_i(bus_write), .bus_addr_i(bus_addr),
    .bus_wdata_i(bus_wdata), .bus_ready_o(bus_ready), .bus_exists_o(bus_exists),
    .bus_rvalid_o(bus_rvalid), .bus_rdata_o(bus_rdata), .irq_o(irq_o),
    .scan_clocks_o(), .scan_o(), .scan_shown_i(20'd0), .scan_frames_i(32'd0), .scan_missed_i(1'b0),
    .memory_read_valid_o(read_valid), .memory_read_ready_i(read_ready), .memory_read_id_o(read_id),
    .memory_read_address_o(read_address), .memory_read_last_o(read_last),
    .memory_beat_valid_i(beat_valid), .memory_beat_ready_o(beat_ready), .memory_beat_id_i(beat_id),
    .memory_beat_data_i(beat_data), .memory_beat_last_i(beat_last),
    .memory_write_valid_o(write_valid), .memory_write_ready_i(write_ready),
    .memory_write_address_o(write_address), .memory_write_data_o(write_data),
    .memory_write_mask_o(write_mask), .memory_write_left_o(write_left), .memory_idle_i(idle),
    .memory_stop_o(stop), .memory_base_o(base), .memory_error_i(error),
    .memory_error_write_i(error_write), .memory_error_response_i(error_response),
    .memory_error_address_i(error_address)
  );

  wishbone_memory #(
    .ID_BITS(`DYNRT_CORE_MEMORY_ID_BITS), .BEAT_BYTES(`DYNRT_CORE_MEMORY_BEAT_BYTES),
    .ADDRESS_BITS(ADDRESS_BITS), .FLIGHT(FLIGHT), .TURN(TURN)
  ) memory (
    .clk_i(clk_i), .rst_ni(rst_ni), .base_i(base[ADDRESS_BITS-1:0]), .stop_i(stop), .idle_o(idle),
    .error_o(error), .error_write_o(error_write), .error_response_o(error_response),
    .error_address_o(error_address), .read_valid_i(read_valid), .read_ready_o(read_ready),
    .read_id_i(read_id), .read_address_i(read_address), .read_last_i(read_last),
    .beat_valid_o(beat_valid), .beat_ready_i(beat_ready), .beat_id_o(beat_id),
    .beat_data_o(beat_data), .beat_last_o(beat_last), .write_valid_i(write_valid),
    .write_ready_o(write_ready), .write_address_i(write_address), .write_data_i(write_data),
    .write_mask_i(write_mask), .write_left_i(write_left), .m_wb_cyc_o(m_wb_cyc_o),
    .m_wb_stb_o(m_wb_stb_o), .m_wb_we_o(m_wb_we_o), .m_wb_adr_o(m_wb_adr_o),
    .m_wb_dat_o(m_wb_dat_o), .m_wb_sel_o(m_wb_sel_o), .m_wb_stall_i(m_wb_stall_i),
    .m_wb_ack_i(m_wb_ack_i), .m_wb_err_i(m_wb_err_i), .m_wb_dat_i(m_wb_dat_i)
  );

  // A board without a clock gate has the core on its own clock. A bus may be narrower than a
  // register for its addresses.
  wire unused = &{1'b0, core_clk_en, base};

endmodule

`default_nettype wire
