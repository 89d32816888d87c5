
// Properties of a mailbox, read inside the unit with its RAMs opened. One matrix of one packet and
// level is watched, any of them, and where the mailbox knows a packet's rays apart, one ray. An entry is
// {last, matrix, active, clear, level, packet}, a job that is let through {matrix, active, kind, packet,
// repeat}. The file of its rows says why they hold.
  localparam ENTRY = $bits(entry_data_i);
  localparam FRESH = $bits(fresh_data_o);
  localparam PACKET = PACKET_BITS;  // of a packet's number
  localparam PACKETS = 1 << PACKET;
  localparam MATRIX = FRESH - PACKET - 10;
  localparam SLOTS = 2;
  localparam COUNT = 2;
  localparam RAYS = 4;
  (* anyconst *) wire [PACKET-1:0] packet;
  (* anyconst *) wire level;
  (* anyconst *) wire [MATRIX-1:0] matrix;
  (* anyconst *) wire [1:0] ray;
  (* anyconst *) wire [511:0] frame;
  reg was_reset_q = 1'b0;

  // Transactions, up to the one whose tokens are being written.
  reg [(ENTRY+1)*(LATENCY-1)-1:0] entries_q = 0;
  wire fired = fire_o && rst_ni;
  wire [(ENTRY+1)*LATENCY-1:0] entries = {entries_q, fired, entry_data_i};
  wire [ENTRY:0] done = entries[(ENTRY+1)*LATENCY-1-:ENTRY+1];
  wire done_fired = done[ENTRY];
  wire [PACKET-1:0] done_packet = done[PACKET-1:0];
  wire done_level = done[PACKET];
  wire done_clear = done[PACKET+1];
  wire [MATRIX-1:0] done_matrix = done[PACKET+6+:MATRIX];
  function of_watched(input [ENTRY:0] entry);
    of_watched = entry[ENTRY] && !entry[PACKET+1] && entry[PACKET-1:0] == packet &&
        entry[PACKET] == level && entry[PACKET+6+:MATRIX] == matrix &&
        (!KNOWS_RAYS || entry[PACKET+2+ray]);
  endfunction
  wire is_watched = of_watched(done);

  wire fresh_valid = WRITTEN_VALID(fresh);
  wire [FRESH-1:0] fresh = WRITTEN_DATA(fresh);
  wire [RAYS-1:0] fresh_rays = fresh[PACKET+6+:RAYS];
  wire lets_through = fresh_valid && (!KNOWS_RAYS || fresh_rays[ray]);
  wire seen_valid = WRITTEN_VALID(seen);
  wire start_valid = WRITTEN_VALID(start);

  reg let_through_q;  // the watched one, since the mailbox forgot
  reg [PACKETS-1:0] cleared_q = 0;
  reg [PACKETS-1:0] entered_q = 0;  // packets that are in an object
  always @(posedge clk_i) begin
    was_reset_q <= was_reset_q || !rst_ni;
    entries_q <= rst_ni ? entries : 0;
    if (done_fired && done_clear) begin
      cleared_q[done_packet] <= 1'b1;
      entered_q[done_packet] <= 1'b0;
      if (done_packet == packet) let_through_q <= 1'b0;
    end
    if (done_fired && fresh_valid) begin
      if (!done_level) entered_q[done_packet] <= 1'b1;
      if (!done_level && done_packet == packet && level) let_through_q <= 1'b0;
      if (is_watched && lets_through) let_through_q <= 1'b1;
    end
  end

  // A packet is in one place at a time. It starts with a clear, and meets triangles in an object.
  integer n;
  always @* begin
    assume (rst_ni == was_reset_q);
    assume (frame_i == frame);
    if (fired) begin
      for (n = 1; n < LATENCY; n = n + 1) begin
        assume (!entries[(ENTRY+1)*n+ENTRY] ||
                entries[(ENTRY+1)*n+:PACKET] != entry_data_i[PACKET-1:0]);
      end
      if (!entry_data_i[PACKET+1]) begin
        assume (cleared_q[entry_data_i[PACKET-1:0]]);
        assume (!entry_data_i[PACKET] || entered_q[entry_data_i[PACKET-1:0]]);
      end
    end
  end

  always @* if (was_reset_q) begin
    if (is_watched && !let_through_q) never_drops_what_is_new: assert (lets_through);
    if (fresh_valid) lets_through_what_came: assert (done_fired && !done_clear &&
        fresh[FRESH-1-:MATRIX] == done_matrix &&
        (!KNOWS_RAYS || (fresh_rays & ~done[PACKET+2+:RAYS]) == 0));
    one_of_three: assert ({1'b0, fresh_valid} + seen_valid + start_valid == {1'b0, done_fired});
  end

  always @* begin
    drops_what_it_has_seen: cover (was_reset_q && is_watched && seen_valid && level);
    forgets: cover (was_reset_q && is_watched && !let_through_q && level && entries[ENTRY]);
  end
