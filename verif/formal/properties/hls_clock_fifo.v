// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_clock_fifo, read inside the module. A step is an edge of one clock, of the other
// or of both (verif/formal/two_clocks.v). One token is followed, any of them, from when it comes.
  (* anyseq *) wire follow;
  reg [2:0] steps_q = 0;        // of the reset, at first
  reg written_q = 1'b0, taken_q = 1'b0;  // each side has left its reset
  wire pushed = clk_i && rst_ni && push;
  wire popped = read_clk_i && read_rst_ni && pop;

  wire [BITS:0] writes = write_next_q - 1'b1, reads = read_next_q - 1'b1;  // since the reset
  reg followed_q = 1'b0;
  reg [BITS:0] place_q;         // of the token, by the writes before it
  reg [WIDTH-1:0] token_q;
  reg [1:0] seen_q;             // edges of the reader since it came, 3 at most
  reg [1:0] calm_q = 0;         // edges of the writer since a token left, 3 at most
  reg [BITS:0] last_write_q, last_read_q;

  always @($global_clock) begin
    if (steps_q != 4) steps_q <= steps_q + 1;
    written_q <= written_q || rst_ni;
    taken_q <= taken_q || read_rst_ni;
    last_write_q <= write_gray_q;
    last_read_q <= read_gray_q;
    if (pushed && follow && !followed_q) begin
      followed_q <= 1'b1;
      place_q <= writes;
      token_q <= data_i;
      seen_q <= 0;
    end else if (followed_q) begin
      if (popped && place_q == reads) followed_q <= 1'b0;
      if (read_clk_i && read_rst_ni && seen_q != 3) seen_q <= seen_q + 1;
    end
    calm_q <= popped ? 0 : clk_i && rst_ni && calm_q != 3 ? calm_q + 1 : calm_q;
  end

  // Both resets at once for four edges of each clock; then each ends, once.
  always @* begin
    assume (steps_q == 4 || (!rst_ni && !read_rst_ni && clk_i && read_clk_i));
    assume (rst_ni || !written_q);
    assume (read_rst_ni || !taken_q);
  end
  wire running = steps_q == 4;

  wire [BITS:0] used = writes - reads;
  wire head = followed_q && place_q == reads;
  wire [BITS:0] write_changes = write_gray_q ^ last_write_q;
  wire [BITS:0] read_changes = read_gray_q ^ last_read_q;

  always @* if (running) begin
    kept: assert (!valid_o || used != 0);
    if (head && valid_o) in_order: assert (data_o == token_q);
    never_overfull: assert (used <= DEPTH);
    if (head && seen_q == 3) arrives: assert (valid_o);
    if (calm_q == 3 && used < DEPTH) frees: assert (ready_o);
    one_bit: assert ((write_changes & (write_changes - 1'b1)) == 0 &&
                     (read_changes & (read_changes - 1'b1)) == 0);
  end

  // Why they hold: each side sees the other's count late, and the token lies in its row.
  function [BITS:0] binary(input [BITS:0] gray);
    integer b;
    begin
      binary[BITS] = gray[BITS];
      for (b = BITS - 1; b >= 0; b = b - 1) binary[b] = binary[b+1] ^ gray[b];
    end
  endfunction
  wire [BITS:0] early_used = binary(write_early_q) - reads;
  wire [BITS:0] seen_used = binary(write_seen_q) - reads;
  wire [BITS:0] early_full = writes - binary(read_early_q);
  wire [BITS:0] seen_full = writes - binary(read_seen_q);
  wire [BITS:0] ahead = place_q - reads;
  always @* if (running) begin
    assert (binary(write_gray_q) == writes && binary(read_gray_q) == reads);
    assert (write_q == writes[BITS-1:0] && read_q == reads[BITS-1:0]);
    assert (binary(write_next_gray_q) == write_next_q && binary(read_next_gray_q) == read_next_q);
    assert (seen_used <= early_used && early_used <= used);
    assert (used <= early_full && early_full <= seen_full && seen_full <= DEPTH);
    if (calm_q != 0) assert (read_early_q == read_gray_q);
    if (calm_q >= 2) assert (read_seen_q == read_gray_q);
    assert (!ready_q || seen_full != DEPTH);
    assert (!valid_q || seen_used != 0);
    if (followed_q) assert (ahead < used && rows[place_q[BITS-1:0]] == token_q);
    if (followed_q && seen_q != 0) assert (ahead < early_used);
    if (followed_q && seen_q >= 2) assert (ahead < seen_used);
    if (!written_q) assert (writes == 0 && read_early_q == 0 && read_seen_q == 0 && ready_q);
    if (!taken_q) assert (reads == 0 && write_early_q == 0 && write_seen_q == 0 && !valid_q);
    if (!taken_q && followed_q) assert (seen_q == 0);
    assert (binary(last_write_q) == writes || binary(last_write_q) + 1'b1 == writes);
    assert (binary(last_read_q) == reads || binary(last_read_q) + 1'b1 == reads);
  end
  always @* begin
    assert (steps_q <= 4);
    if (!running) assert (!followed_q && calm_q == 0 && !written_q && !taken_q);
    if (!running && steps_q >= 1)
      assert ({write_q, write_gray_q, write_early_q, write_seen_q, read_q, read_gray_q, read_early_q,
               read_seen_q, valid_q} == 0 && ready_q);
    if (!running && steps_q >= 1)
      assert (write_next_q == 1 && write_next_gray_q == 1 && read_next_q == 1 && read_next_gray_q == 1);
    if (!running && steps_q >= 2) assert ({last_write_q, last_read_q} == 0);
  end

  always @* if (running) begin
    gets_full: cover (used == DEPTH);
    followed_to_the_end: cover (followed_q && head && popped && last_write_q != write_gray_q);
    both_at_once: cover (pushed && popped);
    sees_late: cover (used == DEPTH && seen_used == 0);
  end
