// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core with an AXI4 manager for its memory, an AXI4-Lite subordinate for its registers and an
// interrupt, all on one clock. The signals have the names by which tools know the buses.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_axi #(
  // Those of fast_port; another core takes its own.
  parameter PACKETS = 64,      // packets in flight of the core below
  parameter CACHE_LINES = 512, // lines of each of its caches
  parameter ADDRESS_BITS = 32, // of the memory's bus, 26 to 64
  parameter [63:0] MEMORY_BASE = 64'd0, // where the memory begins on it, a multiple of 32 MB
  parameter READS = 64,  // reads in flight, of a core whose reads have several beats
  parameter WRITES = 16, // bursts of writes in flight
  parameter [3:0] CACHE = 4'b0010, // AxCACHE of all accesses
  parameter [2:0] PROT = 3'b000,   // and their AxPROT
  // Follows from the core, leave it as it is.
  parameter AXI_ID_BITS = `DYNRT_CORE_MEMORY_READ_BEATS > 1 ? 1 : `DYNRT_CORE_MEMORY_ID_BITS
) (
  input  wire clk_i,
  input  wire rst_ni,
  output wire irq_o, // a frame is done, until IRQ_PENDING is cleared
  // registers, see axi_lite_registers.v
  input  wire s_axil_awvalid,
  output wire s_axil_awready,
  input  wire [11:0] s_axil_awaddr,
  input  wire [2:0] s_axil_awprot,
  input  wire s_axil_wvalid,
  output wire s_axil_wready,
  input  wire [31:0] s_axil_wdata,
  input  wire [3:0] s_axil_wstrb,
  output wire s_axil_bvalid,
  input  wire s_axil_bready,
  output wire [1:0] s_axil_bresp,
  input  wire s_axil_arvalid,
  output wire s_axil_arready,
  input  wire [11:0] s_axil_araddr,
  input  wire [2:0] s_axil_arprot,
  output wire s_axil_rvalid,
  input  wire s_axil_rready,
  output wire [31:0] s_axil_rdata,
  output wire [1:0] s_axil_rresp,
  // memory, see axi_memory.v
  output wire m_axi_arvalid,
  input  wire m_axi_arready,
  output wire [AXI_ID_BITS-1:0] m_axi_arid,
  output wire [ADDRESS_BITS-1:0] m_axi_araddr,
  output wire [7:0] m_axi_arlen,
  output wire [2:0] m_axi_arsize,
  output wire [1:0] m_axi_arburst,
  output wire m_axi_arlock,
  output wire [3:0] m_axi_arcache,
  output wire [2:0] m_axi_arprot,
  output wire [3:0] m_axi_arqos,
  input  wire m_axi_rvalid,
  output wire m_axi_rready,
  input  wire [AXI_ID_BITS-1:0] m_axi_rid,
  input  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_axi_rdata,
  input  wire [1:0] m_axi_rresp,
  input  wire m_axi_rlast,
  output wire m_axi_awvalid,
  input  wire m_axi_awready,
  output wire [AXI_ID_BITS-1:0] m_axi_awid,
  output wire [ADDRESS_BITS-1:0] m_axi_awaddr,
  output wire [7:0] m_axi_awlen,
  output wire [2:0] m_axi_awsize,
  output wire [1:0] m_axi_awburst,
  output wire m_axi_awlock,
  output wire [3:0] m_axi_awcache,
  output wire [2:0] m_axi_awprot,
  output wire [3:0] m_axi_awqos,
  output wire m_axi_wvalid,
  input  wire m_axi_wready,
  output wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_axi_wdata,
  output wire [`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_axi_wstrb,
  output wire m_axi_wlast,
  input  wire m_axi_bvalid,
  output wire m_axi_bready,
  input  wire [AXI_ID_BITS-1:0] m_axi_bid,
  input  wire [1:0] m_axi_bresp
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

  axi_lite_registers registers (
    .clk_i(clk_i), .rst_ni(rst_ni), .s_axil_awvalid(s_axil_awvalid),
    .s_axil_awready(s_axil_awready), .s_axil_awaddr(s_axil_awaddr), .s_axil_awprot(s_axil_awprot),
    .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(s_axil_wready), .s_axil_wdata(s_axil_wdata),
    .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(s_axil_bvalid), .s_axil_bready(s_axil_bready),
    .s_axil_bresp(s_axil_bresp), .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready),
    .s_axil_araddr(s_axil_araddr), .s_axil_arprot(s_axil_arprot), .s_axil_rvalid(s_axil_rvalid),
    .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata), .s_axil_rresp(s_axil_rresp),
    .bus_valid_o(bus_valid), .bus_write_o(bus_write), .bus_addr_o(bus_addr),
    .bus_wdata_o(bus_wdata), .bus_ready_i(bus_ready), .bus_exists_i(bus_exists),
    .bus_rvalid_i(bus_rvalid), .bus_rdata_i(bus_rdata)
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

  axi_memory #(
    .ID_BITS(`DYNRT_CORE_MEMORY_ID_BITS), .BEAT_BYTES(`DYNRT_CORE_MEMORY_BEAT_BYTES),
    .READ_BEATS(`DYNRT_CORE_MEMORY_READ_BEATS), .ADDRESS_BITS(ADDRESS_BITS), .READS(READS),
    .WRITES(WRITES), .CACHE(CACHE), .PROT(PROT)
  ) memory (
    .clk_i(clk_i), .rst_ni(rst_ni), .base_i(base[ADDRESS_BITS-1:0]), .stop_i(stop), .idle_o(idle),
    .error_o(error), .error_write_o(error_write), .error_response_o(error_response),
    .error_address_o(error_address), .read_valid_i(read_valid), .read_ready_o(read_ready),
    .read_id_i(read_id), .read_address_i(read_address), .read_last_i(read_last),
    .beat_valid_o(beat_valid), .beat_ready_i(beat_ready), .beat_id_o(beat_id),
    .beat_data_o(beat_data), .beat_last_o(beat_last), .write_valid_i(write_valid),
    .write_ready_o(write_ready), .write_address_i(write_address), .write_data_i(write_data),
    .write_mask_i(write_mask), .write_left_i(write_left), .m_axi_arvalid(m_axi_arvalid),
    .m_axi_arready(m_axi_arready), .m_axi_arid(m_axi_arid), .m_axi_araddr(m_axi_araddr),
    .m_axi_arlen(m_axi_arlen), .m_axi_arsize(m_axi_arsize), .m_axi_arburst(m_axi_arburst),
    .m_axi_arlock(m_axi_arlock), .m_axi_arcache(m_axi_arcache), .m_axi_arprot(m_axi_arprot),
    .m_axi_arqos(m_axi_arqos), .m_axi_rvalid(m_axi_rvalid), .m_axi_rready(m_axi_rready),
    .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata), .m_axi_rresp(m_axi_rresp),
    .m_axi_rlast(m_axi_rlast), .m_axi_awvalid(m_axi_awvalid), .m_axi_awready(m_axi_awready),
    .m_axi_awid(m_axi_awid), .m_axi_awaddr(m_axi_awaddr), .m_axi_awlen(m_axi_awlen),
    .m_axi_awsize(m_axi_awsize), .m_axi_awburst(m_axi_awburst), .m_axi_awlock(m_axi_awlock),
    .m_axi_awcache(m_axi_awcache), .m_axi_awprot(m_axi_awprot), .m_axi_awqos(m_axi_awqos),
    .m_axi_wvalid(m_axi_wvalid), .m_axi_wready(m_axi_wready), .m_axi_wdata(m_axi_wdata),
    .m_axi_wstrb(m_axi_wstrb), .m_axi_wlast(m_axi_wlast), .m_axi_bvalid(m_axi_bvalid),
    .m_axi_bready(m_axi_bready), .m_axi_bid(m_axi_bid), .m_axi_bresp(m_axi_bresp)
  );

  // A board without a clock gate has the core on its own clock. A bus may be narrower than a
  // register for its addresses.
  wire unused = &{1'b0, core_clk_en, base};

endmodule

`default_nettype wire
