// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of axi_memory, read inside the module: the rules of AXI4 (verif/bus/axi4_rules.v), of which
// those of the memory are assumed, and what the core relies on. A wire with the attribute hierconn is
// that of the instance in its name.
  localparam SLOT_BITS = 2; // of the bursts in flight; there are fewer than twice as many
  localparam SLOTS = 1 << SLOT_BITS;

  axi4_rules #(
    .ID_BITS(AXI_ID_BITS), .ADDRESS_BITS(ADDRESS_BITS), .BYTES(BEAT_BYTES), .READ_SLOTS_BITS(SLOT_BITS),
    .WRITE_SLOTS_BITS(SLOT_BITS), .SUBORDINATE_ASSUMED(1)
  ) rules (
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

  // Reads of the core that are not answered; where each has its id on the bus, by it.
  reg [ID_BITS+1:0]      reads_q = 0;
  reg [(1<<ID_BITS)-1:0] used_q = 0;
  // Bursts of writes: the number of the next to begin and of the next to be answered, their lengths.
  reg [SLOT_BITS:0]      begun_q = 0, answered_q = 0;
  reg [SLOTS*3-1:0]      lens_q;
  reg                    was_reset_q = 1'b0;
  reg                    stop_before_q = 1'b0, idle_before_q = 1'b1;
  reg [ADDRESS_BITS-1:0] base_before_q;
  wire read_taken = read_valid_i && !stop_i && read_ready_o;
  wire answered = m_axi_bvalid && m_axi_bready;

  always @(posedge clk_i) begin
    reads_q <= reads_q + read_taken - (r_taken && m_axi_rlast);
    if (r_taken && m_axi_rlast) used_q[beat_id_o] <= 1'b0;
    if (read_taken) used_q[read_id_i] <= 1'b1;
    if (taken && first) begin
      lens_q[begun_q[SLOT_BITS-1:0]*3 +: 3] <= write_left_i;
      begun_q <= begun_q + 1'b1;
    end
    if (answered) answered_q <= answered_q + 1'b1;
    stop_before_q <= stop_i;
    idle_before_q <= idle_o;
    base_before_q <= base_i;
    if (!rst_ni) begin
      reads_q <= 0;
      used_q <= 0;
      begun_q <= 0;
      answered_q <= 0;
      was_reset_q <= 1'b1;
      idle_before_q <= 1'b1;
    end
  end

  // The promises of the core: a burst lies in 64 aligned bytes, one that has begun goes on, no id is
  // used twice. Those of the board: a stop lasts until all is idle, and the base stays until then.
  wire [8:0] read_end = {3'd0, read_address_i[5:0]} + ({5'd0, read_last_i} + 9'd1) * BEAT_BYTES;
  wire [8:0] write_end = {3'd0, write_address_i[5:0]} + ({6'd0, write_left_i} + 9'd1) * BEAT_BYTES;
  always @* begin
    assume (rst_ni == was_reset_q);
    if (read_valid_i) begin
      assume (read_end <= 9'd64 && read_address_i[LOG2_BYTES-1:0] == 0);
      assume (read_last_i < READ_BEATS);
      if (IN_ORDER == 0) assume (!used_q[read_id_i]);
    end
    if (write_valid_i) begin
      if (first) assume (write_end <= 9'd64 && write_address_i[LOG2_BYTES-1:0] == 0);
      else assume (write_left_i == left_q - 3'd1);
    end
    if (stop_before_q && !idle_before_q) assume (stop_i);
    if (!idle_before_q) assume (base_i == base_before_q);
  end

  (* hierconn *) wire [DATA+HALVES:0] \w_buffer.data_i ;
  wire [SLOT_BITS:0] open_bursts = begun_q - answered_q;
  always @* if (was_reset_q) begin
    idle_if_all_is_answered: assert (idle_o == (reads_q == 0 && open_bursts == 0 && !open_q));
    if (m_axi_rvalid && !stop_i)
      answers_reach_the_core: assert (beat_valid_o && (IN_ORDER != 0 || used_q[beat_id_o]) &&
                                      (m_axi_rresp[1] || beat_data_o == m_axi_rdata));
    if (stop_i) nothing_comes_in_a_stop: assert (!beat_valid_o && m_axi_rready);
    if (ends) ended_without_a_write: assert (\w_buffer.data_i [DATA+HALVES-1:DATA] == 0);
  end

  reg r_error_q = 1'b0, b_error_q = 1'b0;
  always @(posedge clk_i) begin
    r_error_q <= rst_ni && r_taken && m_axi_rresp[1];
    b_error_q <= rst_ni && answered && m_axi_bresp[1];
  end
  always @* if (was_reset_q)
    errors_are_told: assert (error_o == (r_error_q || b_error_q) &&
                             (!error_o || error_write_o == !r_error_q));

  // Why they hold. What the buffers hold keeps the promises and is what is counted.
  (* hierconn *) wire \ar_buffer.valid_q ;
  (* hierconn *) wire \ar_buffer.full_q ;
  (* hierconn *) wire [ID_BITS+READ_BITS+3:0] \ar_buffer.data_q ;
  (* hierconn *) wire [ID_BITS+READ_BITS+3:0] \ar_buffer.second_q ;
  (* hierconn *) wire \aw_buffer.valid_q ;
  (* hierconn *) wire \aw_buffer.full_q ;
  (* hierconn *) wire [27:0] \aw_buffer.data_q ;
  (* hierconn *) wire [27:0] \aw_buffer.second_q ;
  (* hierconn *) wire \w_buffer.valid_q ;
  (* hierconn *) wire \w_buffer.full_q ;
  (* hierconn *) wire [DATA+HALVES:0] \w_buffer.data_q ;
  (* hierconn *) wire [DATA+HALVES:0] \w_buffer.second_q ;
  wire [1:0] ar_count = {1'b0, \ar_buffer.valid_q } + {1'b0, \ar_buffer.full_q };
  wire [1:0] aw_count = {1'b0, \aw_buffer.valid_q } + {1'b0, \aw_buffer.full_q };
  wire [1:0] w_count = {1'b0, \w_buffer.valid_q } + {1'b0, \w_buffer.full_q };
  wire [READ_BITS-1:0] ar_address_1 = \ar_buffer.data_q [READ_BITS+3:4];
  wire [READ_BITS-1:0] ar_address_2 = \ar_buffer.second_q [READ_BITS+3:4];
  wire [3:0]  ar_last_1 = \ar_buffer.data_q [3:0], ar_last_2 = \ar_buffer.second_q [3:0];
  wire [ID_BITS-1:0] ar_id_1 = \ar_buffer.data_q [ID_BITS+READ_BITS+3:READ_BITS+4];
  wire [ID_BITS-1:0] ar_id_2 = \ar_buffer.second_q [ID_BITS+READ_BITS+3:READ_BITS+4];
  wire [24:0] aw_address_1 = \aw_buffer.data_q [27:3], aw_address_2 = \aw_buffer.second_q [27:3];
  wire [2:0]  aw_left_1 = \aw_buffer.data_q [2:0], aw_left_2 = \aw_buffer.second_q [2:0];
  always @* if (was_reset_q) begin
    assert (\ar_buffer.valid_q || !\ar_buffer.full_q );
    assert (\aw_buffer.valid_q || !\aw_buffer.full_q );
    assert (\w_buffer.valid_q || !\w_buffer.full_q );
    if (\ar_buffer.valid_q )
      assert (ar_address_1[5:0] + (ar_last_1 + 9'd1) * BEAT_BYTES <= 9'd64 && ar_last_1 < READ_BEATS &&
              ar_address_1[LOG2_BYTES-1:0] == 0 && (IN_ORDER != 0 || used_q[ar_id_1]));
    if (\ar_buffer.full_q )
      assert (ar_address_2[5:0] + (ar_last_2 + 9'd1) * BEAT_BYTES <= 9'd64 && ar_last_2 < READ_BEATS &&
              ar_address_2[LOG2_BYTES-1:0] == 0 &&
              (IN_ORDER != 0 || (used_q[ar_id_2] && ar_id_1 != ar_id_2)));
    if (\aw_buffer.valid_q )
      assert (aw_address_1[5:0] + (aw_left_1 + 9'd1) * BEAT_BYTES <= 9'd64 &&
              aw_address_1[LOG2_BYTES-1:0] == 0);
    if (\aw_buffer.full_q )
      assert (aw_address_2[5:0] + (aw_left_2 + 9'd1) * BEAT_BYTES <= 9'd64 &&
              aw_address_2[LOG2_BYTES-1:0] == 0);
  end

  // Reads of several ids: each is used by one read, in the buffer or on the bus.
  (* hierconn *) wire [(1<<AXI_ID_BITS)*(SLOT_BITS+1)-1:0] \rules.reads_q ;
  wire [(1<<AXI_ID_BITS)*(SLOT_BITS+1)-1:0] on_bus = \rules.reads_q ;
  (* hierconn *) wire [(1<<AXI_ID_BITS)*8-1:0] \rules.beat_q ;
  (* hierconn *) wire [(1<<AXI_ID_BITS)*SLOTS*8-1:0] \rules.len_q ;
  (* hierconn *) wire [(1<<AXI_ID_BITS)*SLOT_BITS-1:0] \rules.oldest_q ;
  (* hierconn *) wire \in_order.in_flight_fifo.valid_q ;
  (* hierconn *) wire \in_order.in_flight_fifo.empty_q ;
  (* hierconn *) wire \in_order.in_flight_fifo.read_q ;
  (* hierconn *) wire \in_order.in_flight_fifo.write_q ;
  (* hierconn *) wire [2:0] \in_order.in_flight_fifo.space_q ;
  integer u;
  reg [ID_BITS+1:0] reads_on_bus;
  always @* begin
    reads_on_bus = 0;
    for (u = 0; u < 1 << AXI_ID_BITS; u = u + 1)
      reads_on_bus = reads_on_bus + on_bus[u*(SLOT_BITS+1) +: SLOT_BITS+1];
  end
  always @* if (was_reset_q) assert (reads_q == reads_on_bus + ar_count);
  generate
    if (IN_ORDER == 0) begin : several_ids
      integer k;
      always @* if (was_reset_q) begin
        for (k = 0; k < 1 << ID_BITS; k = k + 1)
          assert (on_bus[k*(SLOT_BITS+1) +: SLOT_BITS+1] ==
                  (used_q[k] && !(\ar_buffer.valid_q && ar_id_1 == k) &&
                   !(\ar_buffer.full_q && ar_id_2 == k)));
        assert (in_any_order.in_flight_q == reads_on_bus);
        // They have one beat.
        assert (\rules.beat_q == 0);
        for (k = 0; k < 1 << ID_BITS; k = k + 1)
          if (on_bus[k*(SLOT_BITS+1)])
            assert (\rules.len_q [(k*SLOTS + \rules.oldest_q [k*SLOT_BITS +: SLOT_BITS])*8 +: 8] == 0);
      end
    end else begin : one_id
      wire [1:0] rows = \in_order.in_flight_fifo.empty_q ? 2'd0
                        : \in_order.in_flight_fifo.write_q == \in_order.in_flight_fifo.read_q ? 2'd2
                        : 2'd1;
      always @* if (was_reset_q) begin
        assert (on_bus == reads_on_bus && on_bus <= READS);
        assert (rows + \in_order.in_flight_fifo.valid_q == on_bus);
        assert (\in_order.in_flight_fifo.valid_q == (on_bus != 0));
        if (\in_order.in_flight_fifo.empty_q )
          assert (\in_order.in_flight_fifo.write_q == \in_order.in_flight_fifo.read_q );
        assert (\in_order.in_flight_fifo.space_q == 3'd1 - on_bus[2:0]);
      end
    end
  endgenerate

  // Bursts of writes: what the rules know of them are the lengths that they began with, and the beats in
  // the buffer are those between the bus and the core.
  (* hierconn *) wire [SLOT_BITS:0] \rules.aws_q ;
  (* hierconn *) wire [SLOT_BITS:0] \rules.ws_q ;
  (* hierconn *) wire [7:0] \rules.w_beat_q ;
  (* hierconn *) wire [SLOTS*8-1:0] \rules.aw_len_q ;
  (* hierconn *) wire [SLOTS*8-1:0] \rules.w_len_q ;
  (* hierconn *) wire [SLOTS*AXI_ID_BITS-1:0] \rules.aw_id_q ;
  (* hierconn *) wire [(1<<AXI_ID_BITS)*(SLOT_BITS+1)-1:0] \rules.done_q ;
  (* hierconn *) wire [SLOT_BITS+1:0] \rules.open_q ;
  (* hierconn *) wire \write_fifo.valid_q ;
  (* hierconn *) wire \write_fifo.empty_q ;
  (* hierconn *) wire \write_fifo.read_q ;
  (* hierconn *) wire \write_fifo.write_q ;
  (* hierconn *) wire [2:0] \write_fifo.space_q ;
  wire [SLOT_BITS:0] aws = \rules.aws_q - answered_q, ws = \rules.ws_q - answered_q;
  function [2:0] len_of(input [SLOTS*3-1:0] lens, input [SLOT_BITS:0] burst);
    len_of = lens[burst[SLOT_BITS-1:0]*3 +: 3];
  endfunction
  // Places of beats: that at the bus, and those after the first and the second in the buffer.
  wire [SLOT_BITS:0] at_0 = \rules.ws_q , at_1, at_2;
  wire [7:0]         beat_0 = \rules.w_beat_q , beat_1, beat_2;
  wire               last_0 = beat_0 == {5'd0, len_of(lens_q, at_0)};
  wire               last_1 = beat_1 == {5'd0, len_of(lens_q, at_1)};
  assign at_1 = at_0 + last_0;
  assign beat_1 = last_0 ? 8'd0 : beat_0 + 8'd1;
  assign at_2 = at_1 + last_1;
  assign beat_2 = last_1 ? 8'd0 : beat_1 + 8'd1;
  wire [SLOT_BITS:0] at = w_count == 2 ? at_2 : w_count == 1 ? at_1 : at_0;
  wire [7:0]         beat = w_count == 2 ? beat_2 : w_count == 1 ? beat_1 : beat_0;
  wire [SLOT_BITS:0] begun_before = begun_q - 1'b1;
  wire [1:0] write_rows = \write_fifo.empty_q ? 2'd0
                          : \write_fifo.write_q == \write_fifo.read_q ? 2'd2 : 2'd1;
  integer s;
  always @* if (was_reset_q) begin
    assert (open_bursts <= WRITES && aws <= open_bursts && ws <= open_bursts);
    assert (aws + aw_count == open_bursts);
    if (\aw_buffer.valid_q ) assert (aw_left_1 == len_of(lens_q, \rules.aws_q ));
    if (\aw_buffer.full_q ) assert (aw_left_2 == len_of(lens_q, \rules.aws_q + 1'b1));
    if (\w_buffer.valid_q ) assert (\w_buffer.data_q [DATA+HALVES] == last_0);
    if (\w_buffer.full_q ) assert (\w_buffer.second_q [DATA+HALVES] == last_1);
    if (open_q) assert (open_bursts != 0 && at == begun_before && left_q != 0 &&
                        left_q <= len_of(lens_q, begun_before) &&
                        beat == {5'd0, len_of(lens_q, begun_before)} - {5'd0, left_q} + 8'd1);
    else assert (at == begun_q && beat == 0);
    assert (beat_0 <= (ws == open_bursts ? 8'd0 : {5'd0, len_of(lens_q, at_0)}));
    for (s = 0; s < SLOTS; s = s + 1) begin
      if (s >= ws && s < aws)
        assert (\rules.aw_len_q [((answered_q + s) % SLOTS)*8 +: 8] ==
                {5'd0, len_of(lens_q, answered_q + s)} &&
                \rules.aw_id_q [((answered_q + s) % SLOTS)*AXI_ID_BITS +: AXI_ID_BITS] == 0);
      if (s >= aws && s < ws)
        assert (\rules.w_len_q [((answered_q + s) % SLOTS)*8 +: 8] ==
                {5'd0, len_of(lens_q, answered_q + s)});
    end
    assert (\rules.done_q == (aws < ws ? aws : ws));
    assert (\rules.open_q == (aws < ws ? ws : aws));
    assert (write_rows + \write_fifo.valid_q == open_bursts);
    assert (\write_fifo.valid_q == (open_bursts != 0));
    if (\write_fifo.empty_q ) assert (\write_fifo.write_q == \write_fifo.read_q );
    assert (\write_fifo.space_q == 3'd1 - open_bursts);
  end

  always @* if (was_reset_q) begin
    reads_fly: cover (reads_on_bus == 2 && \ar_buffer.full_q );
    writes_fly: cover (open_bursts == WRITES && aws == 1 && ws == 0);
    data_lead: cover (aws == 0 && ws == 1 && \rules.w_beat_q == 1);
    ends_a_burst: cover (ends && w_count == 2);
    read_fails: cover (r_error_q && stop_before_q);
    write_fails: cover (b_error_q);
  end
