// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of axi_lite_registers, read inside the module: the rules of AXI4-Lite
// (verif/bus/axi4_rules.v), of which those of the manager are assumed, and what the registers rely on.
  axi4_rules #(
    .ID_BITS(1), .ADDRESS_BITS(12), .BYTES(4), .READ_SLOTS_BITS(2), .WRITE_SLOTS_BITS(2), .LITE(1),
    .MANAGER_ASSUMED(1)
  ) rules (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .arvalid(s_axil_arvalid), .arready(s_axil_arready), .arid(1'b0), .araddr(s_axil_araddr),
    .arlen(8'd0), .arsize(3'd2), .arburst(2'd1), .arlock(1'b0), .arcache(4'd0),
    .arprot(s_axil_arprot), .arqos(4'd0),
    .rvalid(s_axil_rvalid), .rready(s_axil_rready), .rid(1'b0), .rdata(s_axil_rdata),
    .rresp(s_axil_rresp), .rlast(1'b1),
    .awvalid(s_axil_awvalid), .awready(s_axil_awready), .awid(1'b0), .awaddr(s_axil_awaddr),
    .awlen(8'd0), .awsize(3'd2), .awburst(2'd1), .awlock(1'b0), .awcache(4'd0),
    .awprot(s_axil_awprot), .awqos(4'd0),
    .wvalid(s_axil_wvalid), .wready(s_axil_wready), .wdata(s_axil_wdata), .wstrb(s_axil_wstrb),
    .wlast(1'b1), .bvalid(s_axil_bvalid), .bready(s_axil_bready), .bid(1'b0), .bresp(s_axil_bresp)
  );

  // What the manager has asked for last, and clocks that it has waited for since the bus was ready.
  reg        was_reset_q = 1'b0;
  reg [11:0] awaddr_q, araddr_q;
  reg [31:0] wdata_q;
  reg [3:0]  wstrb_q;
  reg        ok_q;          // the write that waits for its answer had an effect
  reg        read_ok_q;     // the read likewise
  reg [31:0] rdata_before_q;
  wire aw_taken = s_axil_awvalid && s_axil_awready, w_taken = s_axil_wvalid && s_axil_wready;
  wire ar_taken = s_axil_arvalid && s_axil_arready;
  wire bus_taken = bus_valid_o && bus_ready_i;

  always @(posedge clk_i) begin
    if (aw_taken) awaddr_q <= s_axil_awaddr;
    if (ar_taken) araddr_q <= s_axil_araddr;
    if (w_taken) wdata_q <= s_axil_wdata;
    if (w_taken) wstrb_q <= s_axil_wstrb;
    if (written) ok_q <= bus_taken;
    if (asked) read_ok_q <= bus_taken;
    if (bus_rvalid_i) rdata_before_q <= bus_rdata_i;
    if (!rst_ni) was_reset_q <= 1'b1;
  end

  // The bus answers reads, and nothing else.
  always @* begin
    assume (rst_ni == was_reset_q);
    assume (!bus_rvalid_i || reading_q);
  end

  always @* if (was_reset_q) begin
    if (bus_valid_o && bus_write_o)
      writes_what_was_asked_for: assert (bus_addr_o == {14'd0, awaddr_q[11:2], 2'd0} &&
                                         bus_wdata_o == wdata_q && wstrb_q == 4'd15 && bus_exists_i);
    if (bus_valid_o && !bus_write_o)
      reads_what_was_asked_for: assert (bus_addr_o == {14'd0, araddr_q[11:2], 2'd0} && bus_exists_i);
    if (s_axil_bvalid) tells_what_a_write_did: assert (s_axil_bresp == (ok_q ? 2'd0 : 2'd2));
    if (s_axil_rvalid)
      answers_with_the_register: assert (read_ok_q
                                         ? s_axil_rresp == 2'd0 && s_axil_rdata == rdata_before_q
                                         : s_axil_rresp == 2'd2 && s_axil_rdata == 32'd0);
  end
  // One that waits, and before which another one has gone.
  reg read_passed_q = 1'b0, write_passed_q = 1'b0;
  always @(posedge clk_i) begin
    read_passed_q <= rst_ni && read_waits && !asked && (read_passed_q || written);
    write_passed_q <= rst_ni && write_waits && !written && (write_passed_q || asked);
  end
  always @* if (was_reset_q)
    takes_turns: assert (!(read_passed_q && written) && !(write_passed_q && asked));

  // Why they hold: what the rules count is what is kept here.
  (* hierconn *) wire [5:0] \rules.reads_q ;
  (* hierconn *) wire [5:0] \rules.done_q ;
  (* hierconn *) wire [2:0] \rules.aws_q ;
  (* hierconn *) wire [2:0] \rules.ws_q ;
  (* hierconn *) wire [3:0] \rules.open_q ;
  (* hierconn *) wire [15:0] \rules.beat_q ;
  (* hierconn *) wire [63:0] \rules.len_q ;
  (* hierconn *) wire [3:0] \rules.oldest_q ;
  (* hierconn *) wire [3:0] \rules.aw_id_q ;
  (* hierconn *) wire [31:0] \rules.aw_len_q ;
  (* hierconn *) wire [31:0] \rules.w_len_q ;
  (* hierconn *) wire [7:0] \rules.w_beat_q ;
  integer k;
  always @* if (was_reset_q) begin
    assert (\rules.reads_q == ar_q + reading_q + r_q);
    assert (!(reading_q && r_q));
    assert (!read_passed_q || (read_waits && !turn_q));
    assert (!write_passed_q || (write_waits && turn_q));
    assert (\rules.done_q == b_q + (aw_q && w_q));
    assert (\rules.aws_q == \rules.ws_q + aw_q - w_q);
    assert (\rules.open_q == b_q + (aw_q || w_q));
    assert (\rules.beat_q == 0 && \rules.w_beat_q == 0);
    if (aw_q) assert (aw_word_q == awaddr_q[11:2]);
    if (w_q) assert (w_data_q == wdata_q && w_whole_q == (wstrb_q == 4'd15));
    if (ar_q) assert (ar_word_q == araddr_q[11:2]);
    if (b_q) assert (b_error_q == !ok_q);
    if (r_q) assert (r_error_q == !read_ok_q && r_data_q == (read_ok_q ? rdata_before_q : 32'd0));
    if (reading_q) assert (read_ok_q && !r_error_q);
    for (k = 0; k < 4; k = k + 1)
      if (k < \rules.reads_q )
        assert (\rules.len_q [((\rules.oldest_q [1:0] + k) % 4)*8 +: 8] == 0);
    // Nothing else than bursts of one beat and the id 0 has come.
    if (aw_q && !w_q)
      assert (\rules.aw_len_q [\rules.ws_q [1:0]*8 +: 8] == 0 && !\rules.aw_id_q [\rules.ws_q [1:0]]);
    if (w_q && !aw_q) assert (\rules.w_len_q [\rules.aws_q [1:0]*8 +: 8] == 0);
  end

  always @* if (was_reset_q) begin
    data_first: cover (w_q && !aw_q && s_axil_awvalid);
    write_refused: cover (s_axil_bvalid && b_error_q);
    both_wait: cover (read_passed_q && write_waits && bus_valid_o);
    read_waits_for_the_manager: cover (s_axil_rvalid && !s_axil_rready && ar_q);
  end
