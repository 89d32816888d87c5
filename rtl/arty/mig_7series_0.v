// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ports of the DDR3's controller that Vivado's Memory Interface Generator makes for dynrt_arty
// (UG586), for tools that have not the controller itself. Vivado does not read this file.
`default_nettype none

(* blackbox *)
module mig_7series_0 (
  input  wire         sys_clk_i, // 100 MHz
  input  wire         clk_ref_i, // 200 MHz, for the delays of its pins
  input  wire         sys_rst,   // active low
  output wire         ui_clk,
  output wire         ui_clk_sync_rst,
  output wire         ui_addn_clk_0, // 200 MHz
  output wire         init_calib_complete,
  input  wire         aresetn,
  input  wire         app_sr_req,
  input  wire         app_ref_req,
  input  wire         app_zq_req,
  output wire [13:0]  ddr3_addr,
  output wire [2:0]   ddr3_ba,
  output wire         ddr3_ras_n,
  output wire         ddr3_cas_n,
  output wire         ddr3_we_n,
  output wire         ddr3_reset_n,
  output wire         ddr3_ck_p,
  output wire         ddr3_ck_n,
  output wire         ddr3_cke,
  output wire         ddr3_cs_n,
  output wire [1:0]   ddr3_dm,
  output wire         ddr3_odt,
  inout  wire [15:0]  ddr3_dq,
  inout  wire [1:0]   ddr3_dqs_p,
  inout  wire [1:0]   ddr3_dqs_n,
  input  wire [3:0]   s_axi_arid,
  input  wire [27:0]  s_axi_araddr,
  input  wire [7:0]   s_axi_arlen,
  input  wire [2:0]   s_axi_arsize,
  input  wire [1:0]   s_axi_arburst,
  input  wire         s_axi_arlock,
  input  wire [3:0]   s_axi_arcache,
  input  wire [2:0]   s_axi_arprot,
  input  wire [3:0]   s_axi_arqos,
  input  wire         s_axi_arvalid,
  output wire         s_axi_arready,
  output wire [3:0]   s_axi_rid,
  output wire [127:0] s_axi_rdata,
  output wire [1:0]   s_axi_rresp,
  output wire         s_axi_rlast,
  output wire         s_axi_rvalid,
  input  wire         s_axi_rready,
  input  wire [3:0]   s_axi_awid,
  input  wire [27:0]  s_axi_awaddr,
  input  wire [7:0]   s_axi_awlen,
  input  wire [2:0]   s_axi_awsize,
  input  wire [1:0]   s_axi_awburst,
  input  wire         s_axi_awlock,
  input  wire [3:0]   s_axi_awcache,
  input  wire [2:0]   s_axi_awprot,
  input  wire [3:0]   s_axi_awqos,
  input  wire         s_axi_awvalid,
  output wire         s_axi_awready,
  input  wire [127:0] s_axi_wdata,
  input  wire [15:0]  s_axi_wstrb,
  input  wire         s_axi_wlast,
  input  wire         s_axi_wvalid,
  output wire         s_axi_wready,
  output wire [3:0]   s_axi_bid,
  output wire [1:0]   s_axi_bresp,
  output wire         s_axi_bvalid,
  input  wire         s_axi_bready
);

endmodule

`default_nettype wire
