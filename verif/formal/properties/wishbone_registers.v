// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of wishbone_registers, read inside the module: the rules of Wishbone
// (verif/bus/wishbone_rules.v), of which those of the manager are assumed, and what the registers rely
// on. The manager may end a cycle before its answer.
  wishbone_rules #(
    .ADDRESS_BITS(12), .BYTES(4), .FLIGHT_BITS(3), .GIVES_UP(1), .SELECTS_NONE(1),
    .MANAGER_ASSUMED(1)
  ) rules (
    .clk_i(clk_i), .rst_ni(rst_ni), .cyc(s_wb_cyc_i), .stb(s_wb_stb_i), .we(s_wb_we_i),
    .adr(s_wb_adr_i), .dat_w(s_wb_dat_i), .sel(s_wb_sel_i), .stall(s_wb_stall_o), .ack(s_wb_ack_o),
    .err(s_wb_err_o)
  );

  reg        was_reset_q = 1'b0;
  reg        we_q;
  reg [11:0] adr_q;
  reg [31:0] dat_q, register_q;
  reg [3:0]  sel_q;
  reg        ok_q;   // the access had an effect
  reg        gone_q; // the cycle of the access has ended
  wire bus_taken = bus_valid_o && bus_ready_i;
  always @(posedge clk_i) begin
    if (taken) begin
      we_q <= s_wb_we_i;
      adr_q <= s_wb_adr_i;
      dat_q <= s_wb_dat_i;
      sel_q <= s_wb_sel_i;
    end
    gone_q <= !taken && (gone_q || !s_wb_cyc_i);
    if (done) ok_q <= bus_taken;
    if (bus_rvalid_i) register_q <= bus_rdata_i;
    if (!rst_ni) was_reset_q <= 1'b1;
  end

  // The bus answers reads, and nothing else.
  always @* begin
    assume (rst_ni == was_reset_q);
    assume (!bus_rvalid_i || reading_q);
  end

  wire answers = s_wb_ack_o || s_wb_err_o;
  always @* if (was_reset_q) begin
    if (bus_valid_o)
      does_what_was_asked_for: assert (bus_addr_o == {14'd0, adr_q[11:2], 2'd0} && bus_exists_i &&
                                       bus_write_o == we_q && bus_wdata_o == dat_q && sel_q == 4'd15);
    if (answers) tells_what_it_did: assert (s_wb_ack_o == ok_q && s_wb_err_o == !ok_q && !gone_q);
    if (s_wb_ack_o && !we_q) answers_with_the_register: assert (s_wb_dat_o == register_q);
  end

  // Why they hold.
  (* hierconn *) wire [2:0] \rules.flight_q ;
  always @* if (was_reset_q) begin
    assert (waits_q + reading_q + answer_q <= 1);
    assert (gone_q == left_q || (!waits_q && !reading_q));
    if (waits_q) assert (write_q == we_q && word_q == adr_q[11:2] && wdata_q == dat_q &&
                         whole_q == (sel_q == 4'd15));
    assert (\rules.flight_q == ((waits_q || reading_q || answer_q) && !gone_q));
    if (reading_q) assert (ok_q && !write_q && write_q == we_q && !error_q);
    if (answer_q) assert (error_q == !ok_q && (!gone_q && (error_q || we_q || rdata_q == register_q)));
  end

  always @* if (was_reset_q) begin
    refused: cover (s_wb_err_o);
    register_read: cover (s_wb_ack_o && !we_q);
    given_up: cover (reading_q && gone_q && s_wb_cyc_i && s_wb_stb_i);
  end
