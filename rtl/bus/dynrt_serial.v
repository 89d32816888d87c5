// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A core whose host is at the end of a serial line and whose memory is behind AXI4: all of a board but
// its clock, its pins and its memory controller, which the board's top has (rtl/arty). The program
// renders on it as on any other board with a link, "--board serial:DEVICE".
//
// Reads have one id and are answered in order, and each write is a burst of one beat, as the host's
// and the core's take turns.
`default_nettype none
`include "dynrt_core.vh"
`include "dynrt_link.vh"

module dynrt_serial #(
  // Those of fast_port; another core takes its own.
  parameter PACKETS = 64,      // packets in flight of the core below
  parameter CACHE_LINES = 512, // lines of each of its caches
  parameter [351:0] NAME = "fast_port",
  parameter [31:0]  CLOCK_HZ = 32'd81250000,
  parameter [11:0]  DIVISOR = 12'd27,   // clocks of a bit on the line, 4 to 4095
  parameter ADDRESS_BITS = 28,          // of the memory's bus, 26 to 64
  parameter [63:0] MEMORY_BASE = 64'd0, // where the memory begins on it, a multiple of 32 MB
  parameter READS = 64,                 // in flight
  parameter WRITES = 16                 // in flight
) (
  input  wire clk_i,
  input  wire rst_ni,
  // pins
  input  wire serial_i,
  output wire serial_o,
  // state
  output wire busy_o, // the core works
  output wire irq_o,  // a frame is done, until IRQ_PENDING is cleared
  // memory, see axi_memory.v
  output wire m_axi_arvalid,
  input  wire m_axi_arready,
  output wire m_axi_arid,
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
  input  wire m_axi_rid,
  input  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES-1:0] m_axi_rdata,
  input  wire [1:0] m_axi_rresp,
  input  wire m_axi_rlast,
  output wire m_axi_awvalid,
  input  wire m_axi_awready,
  output wire m_axi_awid,
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
  input  wire m_axi_bid,
  input  wire [1:0] m_axi_bresp
);

  localparam ID_BITS = `DYNRT_CORE_MEMORY_ID_BITS;
  localparam BEAT_BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES;
  localparam DATA_BITS = 8 * BEAT_BYTES;
  localparam MASK_BITS = BEAT_BYTES / 2;

  // The host.
  wire                 bus_valid, bus_write, bus_ready, bus_rvalid;
  wire [25:0]          bus_addr;
  wire [31:0]          bus_wdata, bus_rdata;
  wire                 host_write_valid, host_write_ready, host_write_last;
  wire [24:0]          host_write_address;
  wire [DATA_BITS-1:0] host_write_data;
  wire [MASK_BITS-1:0] host_write_mask;
  wire                 host_read_valid, host_read_ready;
  wire [24:0]          host_read_address;
  wire [3:0]           host_read_last;
  wire                 host_beat_valid, host_beat_ready, host_beat_last;
  wire [ID_BITS-1:0]   beat_id;
  wire [DATA_BITS-1:0] beat_data;
  wire                 beat_last;
  board_link #(
    .CLOCK_HZ(CLOCK_HZ), .DIVISOR(DIVISOR), .MEMORY_BYTES(32'd33554432), .NAME(NAME)
  ) host (
    .clk_i(clk_i), .rst_ni(rst_ni), .rx_i(serial_i), .tx_o(serial_o),
    .write_valid_o(host_write_valid), .write_ready_i(host_write_ready),
    .write_data_o({host_write_last, host_write_mask, host_write_data, host_write_address}),
    .read_valid_o(host_read_valid), .read_ready_i(host_read_ready),
    .read_data_o({host_read_last, host_read_address}),
    .beat_valid_i(host_beat_valid), .beat_ready_o(host_beat_ready),
    .beat_data_i({host_beat_last, beat_data}),
    .bus_valid_o(bus_valid), .bus_write_o(bus_write), .bus_addr_o(bus_addr),
    .bus_wdata_o(bus_wdata), .bus_ready_i(bus_ready), .bus_rvalid_i(bus_rvalid),
    .bus_rdata_i(bus_rdata)
  );

  // The core.
  wire                 core_stop, core_idle, writes_idle;
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
  wire [63:0]          base;
  wire                 error, error_write;
  wire [1:0]           error_response;
  wire [24:0]          error_address;
  dynrt_port_board #(
    .PACKETS(PACKETS), .CACHE_LINES(CACHE_LINES), .MEMORY_BASE_BITS(ADDRESS_BITS),
    .MEMORY_BASE(MEMORY_BASE)
  ) core (
    .clk_i(clk_i), .core_clk_i(clk_i), .core_clk_en_o(busy_o), .rst_ni(rst_ni),
    .bus_valid_i(bus_valid), .bus_write_i(bus_write), .bus_addr_i(bus_addr),
    .bus_wdata_i(bus_wdata), .bus_ready_o(bus_ready), .bus_exists_o(), .bus_rvalid_o(bus_rvalid),
    .bus_rdata_o(bus_rdata), .irq_o(irq_o),
    .scan_clocks_o(), .scan_o(), .scan_shown_i(20'd0), .scan_frames_i(32'd0),
    .scan_missed_i(1'b0),
    .memory_read_valid_o(core_read_valid), .memory_read_ready_i(core_read_ready),
    .memory_read_id_o(core_read_id), .memory_read_address_o(core_read_address),
    .memory_read_last_o(core_read_last),
    .memory_beat_valid_i(core_beat_valid), .memory_beat_ready_o(core_beat_ready),
    .memory_beat_id_i(beat_id), .memory_beat_data_i(beat_data), .memory_beat_last_i(beat_last),
    .memory_write_valid_o(core_write_valid), .memory_write_ready_i(core_write_ready),
    .memory_write_address_o(core_write_address), .memory_write_data_o(core_write_data),
    .memory_write_mask_o(core_write_mask), .memory_write_left_o(core_write_left),
    .memory_idle_i(core_idle), .memory_stop_o(core_stop), .memory_base_o(base),
    .memory_error_i(error), .memory_error_write_i(error_write),
    .memory_error_response_i(error_response), .memory_error_address_i(error_address)
  );

  // The memory. There is no display.
  wire                 read_valid, read_ready, all_valid, all_ready, all_last;
  wire [ID_BITS+1:0]   read_id, all_id;
  wire [24:0]          read_address;
  wire [3:0]           read_last;
  wire [DATA_BITS-1:0] all_data;
  wire                 write_valid, write_ready;
  wire [24:0]          write_address;
  wire [DATA_BITS-1:0] write_data;
  wire [MASK_BITS-1:0] write_mask;
  memory_switch #(.ID_BITS(ID_BITS), .BEAT_BYTES(BEAT_BYTES)) switch (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .display_read_valid_i(1'b0), .display_read_ready_o(), .display_read_address_i(25'd0),
    .display_read_last_i(4'd0), .display_beat_valid_o(), .display_beat_ready_i(1'b1),
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

  // A read may take any way to the memory once the write before it is answered.
  localparam COUNT_BITS = $clog2(WRITES + 1);
  reg  [COUNT_BITS-1:0] under_way_q;
  wire begins = write_valid && write_ready;
  wire ends = m_axi_bvalid && m_axi_bready;
  assign writes_idle = under_way_q == {COUNT_BITS{1'b0}};
  always @(posedge clk_i) begin
    if (!rst_ni) under_way_q <= {COUNT_BITS{1'b0}};
    else if (begins && !ends) under_way_q <= under_way_q + 1'b1;
    else if (ends && !begins) under_way_q <= under_way_q - 1'b1;
  end

  // The host may move the memory while accesses of its own are under way: new ones wait until these
  // are answered. A write that the line has answered may not have come so far; a read waits for it.
  wire all_idle, moved_read_ready, moved_write_ready;
  reg  [ADDRESS_BITS-1:0] base_q;
  wire moves = base_q != base[ADDRESS_BITS-1:0];
  assign read_ready = moved_read_ready && !moves;
  assign write_ready = moved_write_ready && !moves;
  always @(posedge clk_i) begin
    if (!rst_ni) base_q <= MEMORY_BASE[ADDRESS_BITS-1:0];
    else if (all_idle) base_q <= base[ADDRESS_BITS-1:0];
  end

  // The switch drops what comes for a core in reset, so the memory never has to stop for it.
  axi_memory #(
    .ID_BITS(ID_BITS + 2), .BEAT_BYTES(BEAT_BYTES), .READ_BEATS(`DYNRT_CORE_MEMORY_READ_BEATS),
    .ADDRESS_BITS(ADDRESS_BITS), .READS(READS), .WRITES(WRITES), .READ_BITS(25),
    .IN_ORDER(1)
  ) memory (
    .clk_i(clk_i), .rst_ni(rst_ni), .base_i(base_q), .stop_i(1'b0),
    .idle_o(all_idle), .error_o(error), .error_write_o(error_write),
    .error_response_o(error_response), .error_address_o(error_address),
    .read_valid_i(read_valid && !moves), .read_ready_o(moved_read_ready), .read_id_i(read_id),
    .read_address_i(read_address), .read_last_i(read_last),
    .beat_valid_o(all_valid), .beat_ready_i(all_ready), .beat_id_o(all_id),
    .beat_data_o(all_data), .beat_last_o(all_last),
    .write_valid_i(write_valid && !moves), .write_ready_o(moved_write_ready),
    .write_address_i(write_address), .write_data_i(write_data), .write_mask_i(write_mask),
    .write_left_i(3'd0),
    .m_axi_arvalid(m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_arid(m_axi_arid),
    .m_axi_araddr(m_axi_araddr), .m_axi_arlen(m_axi_arlen), .m_axi_arsize(m_axi_arsize),
    .m_axi_arburst(m_axi_arburst), .m_axi_arlock(m_axi_arlock), .m_axi_arcache(m_axi_arcache),
    .m_axi_arprot(m_axi_arprot), .m_axi_arqos(m_axi_arqos), .m_axi_rvalid(m_axi_rvalid),
    .m_axi_rready(m_axi_rready), .m_axi_rid(m_axi_rid), .m_axi_rdata(m_axi_rdata),
    .m_axi_rresp(m_axi_rresp), .m_axi_rlast(m_axi_rlast), .m_axi_awvalid(m_axi_awvalid),
    .m_axi_awready(m_axi_awready), .m_axi_awid(m_axi_awid), .m_axi_awaddr(m_axi_awaddr),
    .m_axi_awlen(m_axi_awlen), .m_axi_awsize(m_axi_awsize), .m_axi_awburst(m_axi_awburst),
    .m_axi_awlock(m_axi_awlock), .m_axi_awcache(m_axi_awcache), .m_axi_awprot(m_axi_awprot),
    .m_axi_awqos(m_axi_awqos), .m_axi_wvalid(m_axi_wvalid), .m_axi_wready(m_axi_wready),
    .m_axi_wdata(m_axi_wdata), .m_axi_wstrb(m_axi_wstrb), .m_axi_wlast(m_axi_wlast),
    .m_axi_bvalid(m_axi_bvalid), .m_axi_bready(m_axi_bready), .m_axi_bid(m_axi_bid),
    .m_axi_bresp(m_axi_bresp)
  );

  wire unused = &{1'b0, host_write_last, core_write_left, base};

endmodule

`default_nettype wire
