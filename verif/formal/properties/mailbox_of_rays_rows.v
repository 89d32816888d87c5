
  // The rows of the watched packet and level, as the RAMs hold them: {rays that have met it, matrices},
  // and {triangles, objects}, how many slots are used.
  localparam ROW = SLOTS * (MATRIX + RAYS);
  localparam USED = 2 * COUNT;
  reg [ROW-1:0] items_q;
  reg [USED-1:0] used_q;
  reg read_items_q = 1'b0;
  reg read_used_q = 1'b0;
  always @(posedge clk_i) begin
    if (items_write_en_o && items_write_addr_o == {level, packet}) items_q <= items_write_data_o;
    if (used_write_en_o && used_write_addr_o == packet) used_q <= used_write_data_o;
    read_items_q <= items_read_en_o && items_read_addr_o == {level, packet};
    read_used_q <= used_read_en_o && used_read_addr_o == packet;
  end
  always @* begin
    if (read_items_q) assume (items_row_i == items_q);
    if (read_used_q) assume (used_row_i == used_q);
  end

  // Why it holds: what is in a slot was let through to the rays that have met it. The two rows are
  // written one after the other, so they agree while no entry of the packet is under way.
  wire [COUNT-1:0] count = level ? used_q[COUNT+:COUNT] : used_q[0+:COUNT];
  wire holds_any = level ? entered_q[packet] : cleared_q[packet];
  integer s, later;
  reg under_way;
  always @* begin
    under_way = 1'b0;
    for (later = 1; later < LATENCY; later = later + 1) begin
      if (entries[(ENTRY+1)*later+ENTRY] && entries[(ENTRY+1)*later+:PACKET] == packet)
        under_way = 1'b1;
    end
  end
  always @* if (was_reset_q) begin
    has_two_slots: assert ($bits(items_row_i) == ROW && $bits(used_row_i) == USED);
    assert (!entered_q[packet] || cleared_q[packet]);
    for (s = 0; s < SLOTS; s = s + 1) begin
      if (!under_way && holds_any && count > s && items_q[MATRIX*s+:MATRIX] == matrix &&
          items_q[MATRIX*SLOTS+RAYS*s+ray])
        assert (let_through_q);
    end
  end
