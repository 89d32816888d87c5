// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Top for an Arty A7-100T (constraints/arty_a7.xdc): dynrt_serial, and all that is this board's: its
// pins, its DDR3 and its clock. The host is at the USB bridge.
//
// The DDR3's controller is the vendor's, made by Vivado's Memory Interface Generator from the settings
// that the board's maker publishes (docs/how-to/arty.md). It makes the clock too: 325 MHz of the
// oscillator's 100 MHz for the chip, and a quarter of that, 81.25 MHz, for what stands behind its AXI4,
// here everything.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_arty (
  input  wire        clk_100mhz_i,
  input  wire        button_ni, // RESET
  input  wire        serial_i,
  output wire        serial_o,
  output wire [3:0]  led_o,
  output wire [13:0] ddr3_addr_o,
  output wire [2:0]  ddr3_bank_o,
  output wire        ddr3_ras_no,
  output wire        ddr3_cas_no,
  output wire        ddr3_we_no,
  output wire        ddr3_reset_no,
  output wire        ddr3_ck_p_o,
  output wire        ddr3_ck_n_o,
  output wire        ddr3_cke_o,
  output wire        ddr3_cs_no,
  output wire [1:0]  ddr3_dm_o,
  output wire        ddr3_odt_o,
  inout  wire [15:0] ddr3_dq_io,
  inout  wire [1:0]  ddr3_dqs_p_io,
  inout  wire [1:0]  ddr3_dqs_n_io
);

  localparam ADDRESS_BITS = 28; // 256 MB
  localparam BEAT_BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES;
  localparam ID_BITS = 4;

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (BEAT_BYTES != 16) begin : bad_beat
      dynrt_arty_needs_a_core_with_beats_of_16_bytes stop ();
    end
  endgenerate

  // The controller resets what is behind it until its clock runs, and the core has to wait until the
  // chip is calibrated.
  wire clk, controller_rst, reference_clk, calibrated;
  reg  controller_rst_nq, rst_nq;
  always @(posedge clk) begin
    controller_rst_nq <= !controller_rst;
    rst_nq <= !controller_rst && calibrated;
  end

  wire                    arvalid, arready, arid, arlock, rvalid, rready, rlast;
  wire                    awvalid, awready, awid, awlock, wvalid, wready, wlast, bvalid, bready;
  wire [ADDRESS_BITS-1:0] araddr, awaddr;
  wire [7:0]              arlen, awlen;
  wire [2:0]              arsize, awsize, arprot, awprot;
  wire [1:0]              arburst, awburst, rresp, bresp;
  wire [3:0]              arcache, awcache, arqos, awqos;
  wire [ID_BITS-1:0]      rid, bid;
  wire [8*BEAT_BYTES-1:0] rdata, wdata;
  wire [BEAT_BYTES-1:0]   wstrb;

  wire busy, irq;
  dynrt_serial #(
    .CLOCK_HZ(32'd81250000), .DIVISOR(12'd27), // 3.009 Mbaud
    .ADDRESS_BITS(ADDRESS_BITS)
  ) board (
    .clk_i(clk), .rst_ni(rst_nq), .serial_i(serial_i), .serial_o(serial_o), .busy_o(busy),
    .irq_o(irq), .m_axi_arvalid(arvalid), .m_axi_arready(arready), .m_axi_arid(arid),
    .m_axi_araddr(araddr), .m_axi_arlen(arlen), .m_axi_arsize(arsize), .m_axi_arburst(arburst),
    .m_axi_arlock(arlock), .m_axi_arcache(arcache), .m_axi_arprot(arprot), .m_axi_arqos(arqos),
    .m_axi_rvalid(rvalid), .m_axi_rready(rready), .m_axi_rid(rid[0]), .m_axi_rdata(rdata),
    .m_axi_rresp(rresp), .m_axi_rlast(rlast), .m_axi_awvalid(awvalid), .m_axi_awready(awready),
    .m_axi_awid(awid), .m_axi_awaddr(awaddr), .m_axi_awlen(awlen), .m_axi_awsize(awsize),
    .m_axi_awburst(awburst), .m_axi_awlock(awlock), .m_axi_awcache(awcache),
    .m_axi_awprot(awprot), .m_axi_awqos(awqos), .m_axi_wvalid(wvalid), .m_axi_wready(wready),
    .m_axi_wdata(wdata), .m_axi_wstrb(wstrb), .m_axi_wlast(wlast), .m_axi_bvalid(bvalid),
    .m_axi_bready(bready), .m_axi_bid(bid[0]), .m_axi_bresp(bresp)
  );

  mig_7series_0 controller (
    .sys_clk_i(clk_100mhz_i), .clk_ref_i(reference_clk), .sys_rst(button_ni), .ui_clk(clk),
    .ui_clk_sync_rst(controller_rst), .ui_addn_clk_0(reference_clk),
    .init_calib_complete(calibrated), .aresetn(controller_rst_nq), .app_sr_req(1'b0),
    .app_ref_req(1'b0), .app_zq_req(1'b0),
    .ddr3_addr(ddr3_addr_o), .ddr3_ba(ddr3_bank_o), .ddr3_ras_n(ddr3_ras_no),
    .ddr3_cas_n(ddr3_cas_no), .ddr3_we_n(ddr3_we_no), .ddr3_reset_n(ddr3_reset_no),
    .ddr3_ck_p(ddr3_ck_p_o), .ddr3_ck_n(ddr3_ck_n_o), .ddr3_cke(ddr3_cke_o),
    .ddr3_cs_n(ddr3_cs_no), .ddr3_dm(ddr3_dm_o), .ddr3_odt(ddr3_odt_o), .ddr3_dq(ddr3_dq_io),
    .ddr3_dqs_p(ddr3_dqs_p_io), .ddr3_dqs_n(ddr3_dqs_n_io),
    .s_axi_arid({3'd0, arid}), .s_axi_araddr(araddr), .s_axi_arlen(arlen), .s_axi_arsize(arsize),
    .s_axi_arburst(arburst), .s_axi_arlock(arlock), .s_axi_arcache(arcache),
    .s_axi_arprot(arprot), .s_axi_arqos(arqos), .s_axi_arvalid(arvalid),
    .s_axi_arready(arready), .s_axi_rid(rid), .s_axi_rdata(rdata), .s_axi_rresp(rresp),
    .s_axi_rlast(rlast), .s_axi_rvalid(rvalid), .s_axi_rready(rready),
    .s_axi_awid({3'd0, awid}), .s_axi_awaddr(awaddr), .s_axi_awlen(awlen), .s_axi_awsize(awsize),
    .s_axi_awburst(awburst), .s_axi_awlock(awlock), .s_axi_awcache(awcache),
    .s_axi_awprot(awprot), .s_axi_awqos(awqos), .s_axi_awvalid(awvalid),
    .s_axi_awready(awready), .s_axi_wdata(wdata), .s_axi_wstrb(wstrb), .s_axi_wlast(wlast),
    .s_axi_wvalid(wvalid), .s_axi_wready(wready), .s_axi_bid(bid), .s_axi_bresp(bresp),
    .s_axi_bvalid(bvalid), .s_axi_bready(bready)
  );

  // LD7: the memory is calibrated; LD6: the core works; LD5: the host has an interrupt to see.
  assign led_o = {calibrated, busy, irq, 1'b0};

  wire unused = &{1'b0, rid, bid};

endmodule

`default_nettype wire
