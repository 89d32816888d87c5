
  // The rows of the watched packet, as the RAMs hold them: {matrices, how many of them}.
  localparam ROW = COUNT + SLOTS * MATRIX;
  reg [ROW-1:0] objects_q;
  reg [ROW-1:0] triangles_q;
  reg read_objects_q = 1'b0;
  reg read_triangles_q = 1'b0;
  always @(posedge clk_i) begin
    if (objects_write_en_o && objects_write_addr_o == packet) objects_q <= objects_write_data_o;
    if (triangles_write_en_o && triangles_write_addr_o == packet) triangles_q <= triangles_write_data_o;
    read_objects_q <= objects_read_en_o && objects_read_addr_o == packet;
    read_triangles_q <= triangles_read_en_o && triangles_read_addr_o == packet;
  end
  always @* begin
    if (read_objects_q) assume (objects_row_i == objects_q);
    if (read_triangles_q) assume (triangles_row_i == triangles_q);
  end

  // Why it holds: what is in a slot was let through.
  wire [ROW-1:0] slots = level ? triangles_q : objects_q;
  wire holds_any = level ? entered_q[packet] : cleared_q[packet];
  integer s, later;
  reg pending;  // the watched one has come, and its row may be written before its tokens
  always @* begin
    pending = 1'b0;
    for (later = 1; later < LATENCY; later = later + 1) begin
      if (of_watched(entries[(ENTRY+1)*later+:ENTRY+1])) pending = 1'b1;
    end
  end
  always @* if (was_reset_q) begin
    has_two_slots: assert ($bits(objects_row_i) == ROW && $bits(triangles_row_i) == ROW);
    assert (!entered_q[packet] || cleared_q[packet]);
    for (s = 0; s < SLOTS; s = s + 1) begin
      if (holds_any && slots[COUNT-1:0] > s && slots[COUNT+MATRIX*s+:MATRIX] == matrix)
        assert (let_through_q || pending);
    end
  end
