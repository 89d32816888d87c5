// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of wishbone_memory, read inside the module: the rules of Wishbone
// (verif/bus/wishbone_rules.v), of which those of the memory are assumed, and what the core relies on. A
// wire with the attribute hierconn is that of the instance in its name.
  localparam FLIGHT_BITS = 2; // fewer than 2^FLIGHT_BITS accesses are in flight

  wishbone_rules #(
    .ADDRESS_BITS(ADDRESS_BITS), .BYTES(BEAT_BYTES), .FLIGHT_BITS(FLIGHT_BITS), .SUBORDINATE_ASSUMED(1)
  ) rules (
    .clk_i(clk_i), .rst_ni(rst_ni), .cyc(m_wb_cyc_o), .stb(m_wb_stb_o), .we(m_wb_we_o),
    .adr(m_wb_adr_o), .dat_w(m_wb_dat_o), .sel(m_wb_sel_o), .stall(m_wb_stall_i), .ack(m_wb_ack_i),
    .err(m_wb_err_i)
  );

  reg                    was_reset_q = 1'b0;
  reg                    stop_before_q = 1'b0, idle_before_q = 1'b1;
  reg [ADDRESS_BITS-1:0] base_before_q;
  reg                    failed_q = 1'b0;
  // Accesses that went to the pins and are not answered, and those of them that read; beats that wait.
  reg [FLIGHT_BITS-1:0]  flight_q = 0, reads_q = 0, beats_q = 0;
  always @(posedge clk_i) begin
    flight_q <= flight_q + goes - answered;
    reads_q <= reads_q + read_goes - read_answered;
    beats_q <= beats_q + read_answered - beat_taken;
    stop_before_q <= stop_i;
    idle_before_q <= idle_o;
    base_before_q <= base_i;
    failed_q <= rst_ni && m_wb_err_i;
    if (!rst_ni) begin
      flight_q <= 0;
      reads_q <= 0;
      beats_q <= 0;
      was_reset_q <= 1'b1;
      idle_before_q <= 1'b1;
    end
  end

  // The promises of the board: a stop lasts until all is idle, and the base stays until then. That of
  // the FIFO for accesses: it holds reads and writes as they went to the pins.
  always @* begin
    assume (rst_ni == was_reset_q);
    if (stop_before_q && !idle_before_q) assume (stop_i);
    if (!idle_before_q) assume (base_i == base_before_q);
    assume (!a_we || flight_q != reads_q);
    assume (a_we || reads_q != 0 || flight_q == 0);
  end

  always @* if (was_reset_q) begin
    idle_if_all_is_answered: assert (idle_o == (!r_valid && !w_valid && flight_q == 0 && beats_q == 0));
    room_for_every_beat: assert (reads_q + beats_q <= FLIGHT);
    if (stop_i) nothing_comes_in_a_stop: assert (!beat_valid_o);
    if (goes) others_get_the_bus: assert (turn_q < TURN);
    errors_are_told: assert (error_o == failed_q);
  end

  // Why they hold: what the FIFOs hold is what is counted.
  (* hierconn *) wire [FLIGHT_BITS-1:0] \rules.flight_q ;
  (* hierconn *) wire \flight_fifo.empty_q ;
  (* hierconn *) wire \flight_fifo.read_q ;
  (* hierconn *) wire \flight_fifo.write_q ;
  (* hierconn *) wire [2:0] \flight_fifo.space_q ;
  (* hierconn *) wire \beat_fifo.empty_q ;
  (* hierconn *) wire \beat_fifo.read_q ;
  (* hierconn *) wire \beat_fifo.write_q ;
  wire [1:0] flight_rows = \flight_fifo.empty_q ? 2'd0
                           : \flight_fifo.write_q == \flight_fifo.read_q ? 2'd2 : 2'd1;
  wire [1:0] beat_rows = \beat_fifo.empty_q ? 2'd0
                         : \beat_fifo.write_q == \beat_fifo.read_q ? 2'd2 : 2'd1;
  always @* if (was_reset_q) begin
    assert (flight_q <= FLIGHT && reads_q <= flight_q);
    assert (flight_q == \rules.flight_q + stb_q);
    assert (in_flight == (flight_q != 0) && flight_rows + in_flight == flight_q);
    if (\flight_fifo.empty_q ) assert (\flight_fifo.write_q == \flight_fifo.read_q );
    assert (\flight_fifo.space_q == 3'd1 - {1'b0, flight_q});
    assert (beat_waits == (beats_q != 0) && beat_rows + beat_waits == beats_q);
    if (\beat_fifo.empty_q ) assert (\beat_fifo.write_q == \beat_fifo.read_q );
    assert (credits_q == FLIGHT - reads_q - beats_q);
    if (stb_q) assert (mask_q != 0);
    assert (turn_q <= TURN && rests_q == (turn_q == TURN));
  end

  always @* if (was_reset_q) begin
    flies: cover (flight_q == FLIGHT && reads_q == 1);
    rests: cover (rests_q && flight_q == 0);
    beats_wait: cover (beats_q == FLIGHT);
    fails: cover (error_o && error_write_o);
    is_stopped: cover (stop_before_q && beat_waits);
  end
