// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's registers as an AXI4-Lite subordinate (IHI 0022) of 4 KB and 32 bits. An address and
// its data come in any order; one write and one read are under way at a time, and where both wait
// for the bus of board_registers they take turns. An access to an address that has no register, or
// a write of less than a whole word, has no effect and gets SLVERR.
`default_nettype none

module axi_lite_registers (
  input  wire        clk_i,
  input  wire        rst_ni,
  // AXI4-Lite
  input  wire        s_axil_awvalid,
  output wire        s_axil_awready,
  input  wire [11:0] s_axil_awaddr,
  input  wire [2:0]  s_axil_awprot,
  input  wire        s_axil_wvalid,
  output wire        s_axil_wready,
  input  wire [31:0] s_axil_wdata,
  input  wire [3:0]  s_axil_wstrb,
  output wire        s_axil_bvalid,
  input  wire        s_axil_bready,
  output wire [1:0]  s_axil_bresp,
  input  wire        s_axil_arvalid,
  output wire        s_axil_arready,
  input  wire [11:0] s_axil_araddr,
  input  wire [2:0]  s_axil_arprot,
  output wire        s_axil_rvalid,
  input  wire        s_axil_rready,
  output wire [31:0] s_axil_rdata,
  output wire [1:0]  s_axil_rresp,
  // board_registers
  output wire        bus_valid_o,
  output wire        bus_write_o,
  output wire [25:0] bus_addr_o,
  output wire [31:0] bus_wdata_o,
  input  wire        bus_ready_i,
  input  wire        bus_exists_i, // of bus_addr_o, in the same clock
  input  wire        bus_rvalid_i,
  input  wire [31:0] bus_rdata_i
);

  // What has been taken from the channels and waits for the bus.
  reg        aw_q, w_q, ar_q;
  reg [9:0]  aw_word_q, ar_word_q;
  reg [31:0] w_data_q;
  reg        w_whole_q;
  // What waits for the manager.
  reg        b_q, b_error_q;
  reg        r_q, r_error_q;
  reg [31:0] r_data_q;
  reg        reading_q; // the bus has yet to answer
  reg        turn_q;    // a write goes first

  assign s_axil_awready = !aw_q;
  assign s_axil_wready = !w_q;
  assign s_axil_arready = !ar_q;
  assign s_axil_bvalid = b_q;
  assign s_axil_bresp = {b_error_q, 1'b0};
  assign s_axil_rvalid = r_q;
  assign s_axil_rresp = {r_error_q, 1'b0};
  assign s_axil_rdata = r_data_q;

  wire write_waits = aw_q && w_q && !b_q;
  wire read_waits = ar_q && !reading_q && !r_q;
  assign bus_write_o = write_waits && (turn_q || !read_waits);
  assign bus_addr_o = {14'd0, bus_write_o ? aw_word_q : ar_word_q, 2'b00};
  assign bus_wdata_o = w_data_q;
  wire allowed = bus_exists_i && (!bus_write_o || w_whole_q);
  assign bus_valid_o = (write_waits || read_waits) && allowed;
  wire done = (write_waits || read_waits) && (bus_ready_i || !allowed);
  wire written = done && bus_write_o;
  wire asked = done && !bus_write_o;

  always @(posedge clk_i) begin
    if (s_axil_awvalid && s_axil_awready) aw_word_q <= s_axil_awaddr[11:2];
    if (s_axil_wvalid && s_axil_wready) w_data_q <= s_axil_wdata;
    if (s_axil_wvalid && s_axil_wready) w_whole_q <= &s_axil_wstrb;
    if (s_axil_arvalid && s_axil_arready) ar_word_q <= s_axil_araddr[11:2];
    if (written) b_error_q <= !allowed;
    if (asked) r_error_q <= !allowed;
    if (!r_q) r_data_q <= reading_q ? bus_rdata_i : 32'd0;
  end
  always @(posedge clk_i) begin
    if (done) turn_q <= !bus_write_o;
    aw_q <= (aw_q && !written) || (s_axil_awvalid && s_axil_awready);
    w_q <= (w_q && !written) || (s_axil_wvalid && s_axil_wready);
    b_q <= (b_q && !s_axil_bready) || written;
    ar_q <= (ar_q && !asked) || (s_axil_arvalid && s_axil_arready);
    reading_q <= (reading_q && !bus_rvalid_i) || (asked && allowed);
    r_q <= (r_q && !s_axil_rready) || (asked && !allowed) || (reading_q && bus_rvalid_i);
    if (!rst_ni) begin
      turn_q <= 1'b0;
      aw_q <= 1'b0;
      w_q <= 1'b0;
      b_q <= 1'b0;
      ar_q <= 1'b0;
      reading_q <= 1'b0;
      r_q <= 1'b0;
    end
  end

  // Whoever has the bus may reach every register, and the lowest bits of an address tell nothing.
  wire unused = &{1'b0, s_axil_awprot, s_axil_arprot, s_axil_awaddr[1:0], s_axil_araddr[1:0]};

endmodule

`default_nettype wire
