// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt_axi beside a memory. The registers go to whatever has the processor.
`default_nettype none
`include "dynrt_core.vh"

module axi_system (
  input  wire clk_i,
  input  wire rst_ni,
  output wire irq_o,
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
  output wire [1:0] s_axil_rresp
);

  localparam BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES;
  localparam ID_BITS = `DYNRT_CORE_MEMORY_READ_BEATS > 1 ? 1 : `DYNRT_CORE_MEMORY_ID_BITS;
  wire               arvalid, arready, rvalid, rready, rlast;
  wire               awvalid, awready, wvalid, wready, wlast, bvalid, bready;
  wire [ID_BITS-1:0] arid, rid, awid, bid;
  wire [31:0]        araddr, awaddr;
  wire [7:0]         arlen;
  wire [8*BYTES-1:0] rdata, wdata;
  wire [BYTES-1:0]   wstrb;

  dynrt_axi #(.MEMORY_BASE(64'h4000_0000)) renderer (
    .clk_i(clk_i), .rst_ni(rst_ni), .irq_o(irq_o), .s_axil_awvalid(s_axil_awvalid),
    .s_axil_awready(s_axil_awready), .s_axil_awaddr(s_axil_awaddr), .s_axil_awprot(s_axil_awprot),
    .s_axil_wvalid(s_axil_wvalid), .s_axil_wready(s_axil_wready), .s_axil_wdata(s_axil_wdata),
    .s_axil_wstrb(s_axil_wstrb), .s_axil_bvalid(s_axil_bvalid), .s_axil_bready(s_axil_bready),
    .s_axil_bresp(s_axil_bresp), .s_axil_arvalid(s_axil_arvalid), .s_axil_arready(s_axil_arready),
    .s_axil_araddr(s_axil_araddr), .s_axil_arprot(s_axil_arprot), .s_axil_rvalid(s_axil_rvalid),
    .s_axil_rready(s_axil_rready), .s_axil_rdata(s_axil_rdata), .s_axil_rresp(s_axil_rresp),
    .m_axi_arvalid(arvalid), .m_axi_arready(arready), .m_axi_arid(arid), .m_axi_araddr(araddr),
    .m_axi_arlen(arlen), .m_axi_rvalid(rvalid), .m_axi_rready(rready), .m_axi_rid(rid),
    .m_axi_rdata(rdata), .m_axi_rlast(rlast), .m_axi_awvalid(awvalid), .m_axi_awready(awready),
    .m_axi_awid(awid), .m_axi_awaddr(awaddr), .m_axi_wvalid(wvalid), .m_axi_wready(wready),
    .m_axi_wdata(wdata), .m_axi_wstrb(wstrb), .m_axi_wlast(wlast), .m_axi_bvalid(bvalid),
    .m_axi_bready(bready), .m_axi_bid(bid), .m_axi_rresp(2'd0), .m_axi_bresp(2'd0),
    .m_axi_arsize(), .m_axi_arburst(), .m_axi_arlock(), .m_axi_arcache(), .m_axi_arprot(),
    .m_axi_arqos(), .m_axi_awlen(), .m_axi_awsize(), .m_axi_awburst(), .m_axi_awlock(),
    .m_axi_awcache(), .m_axi_awprot(), .m_axi_awqos()
  );

  axi_ram #(.BYTES(BYTES), .ID_BITS(ID_BITS)) memory (
    .clk_i(clk_i), .rst_ni(rst_ni), .arvalid(arvalid), .arready(arready), .arid(arid),
    .araddr(araddr), .arlen(arlen), .rvalid(rvalid), .rready(rready), .rid(rid), .rdata(rdata),
    .rlast(rlast), .awvalid(awvalid), .awready(awready), .awid(awid), .awaddr(awaddr),
    .wvalid(wvalid), .wready(wready), .wdata(wdata), .wstrb(wstrb), .wlast(wlast), .bvalid(bvalid),
    .bready(bready), .bid(bid)
  );

endmodule

`default_nettype wire
