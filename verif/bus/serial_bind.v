// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Holds the bus of dynrt_serial to the rules in every simulation.
`default_nettype none
`include "dynrt_core.vh"

bind dynrt_serial axi4_rules #(
  .ID_BITS(1), .ADDRESS_BITS(ADDRESS_BITS), .BYTES(`DYNRT_CORE_MEMORY_BEAT_BYTES),
  .READ_SLOTS_BITS(7), .WRITE_SLOTS_BITS(6)
) memory_rules (
  .clk_i(clk_i), .rst_ni(rst_ni),
  .arvalid(m_axi_arvalid), .arready(m_axi_arready), .arid(m_axi_arid), .araddr(m_axi_araddr),
  .arlen(m_axi_arlen), .arsize(m_axi_arsize), .arburst(m_axi_arburst), .arlock(m_axi_arlock),
  .arcache(m_axi_arcache), .arprot(m_axi_arprot), .arqos(m_axi_arqos),
  .rvalid(m_axi_rvalid), .rready(m_axi_rready), .rid(m_axi_rid), .rdata(m_axi_rdata),
  .rresp(m_axi_rresp), .rlast(m_axi_rlast),
  .awvalid(m_axi_awvalid), .awready(m_axi_awready), .awid(m_axi_awid), .awaddr(m_axi_awaddr),
  .awlen(m_axi_awlen), .awsize(m_axi_awsize), .awburst(m_axi_awburst), .awlock(m_axi_awlock),
  .awcache(m_axi_awcache), .awprot(m_axi_awprot), .awqos(m_axi_awqos),
  .wvalid(m_axi_wvalid), .wready(m_axi_wready), .wdata(m_axi_wdata), .wstrb(m_axi_wstrb),
  .wlast(m_axi_wlast), .bvalid(m_axi_bvalid), .bready(m_axi_bready), .bid(m_axi_bid),
  .bresp(m_axi_bresp)
);

`default_nettype wire
