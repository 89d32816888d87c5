// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_fifo, read inside the module. One token is followed, any of them, from when it
// comes: how many are before it and where it lies.
  (* anyseq *) wire follow;
  reg followed_q = 1'b0;
  reg [ADDR_WIDTH+1:0] count_q;  // tokens inside
  reg [ADDR_WIDTH+1:0] before_q;  // of them, those before the one that is followed
  reg [WIDTH-1:0] token_q;
  reg [ADDR_WIDTH-1:0] row_q;
  reg [ADDR_WIDTH+1:0] late_q;  // tokens that came since ready_o is low
  reg [WIDTH-1:0] offered_q;
  reg waiting_q = 1'b0;
  reg was_reset_q = 1'b0;

  always @(posedge clk_i) begin
    count_q <= count_q + push - pop;
    late_q <= ready_o ? 0 : late_q + push;
    if (push && follow && !followed_q) begin
      followed_q <= 1'b1;
      before_q <= count_q - pop;
      token_q <= data_i;
      row_q <= write_q;
    end else if (followed_q && pop) begin
      if (before_q == 0) followed_q <= 1'b0;
      before_q <= before_q - 1'b1;
    end
    waiting_q <= rst_ni && valid_o && !ready_i;
    offered_q <= data_o;
    if (!rst_ni) begin
      count_q <= 0;
      late_q <= 0;
      followed_q <= 1'b0;
      was_reset_q <= 1'b1;
    end
  end

  // The promise of the writer.
  always @* begin
    assume (rst_ni == was_reset_q);
    if (MARGIN > 0) assume (!(valid_i && !ready_o && late_q >= MARGIN));
    if (BOUNDED != 0) assume (!(push && !pop && count_q == DEPTH));
  end

  always @* if (was_reset_q) begin
    kept: assert (valid_o == (count_q != 0));
    if (followed_q && before_q == 0) in_order: assert (data_o == token_q);
    never_overfull: assert (count_q <= DEPTH);
    if (BOUNDED == 0) ready_with_room: assert (ready_o == (count_q + MARGIN < DEPTH));
    if (waiting_q) steady: assert (valid_o && data_o == offered_q);
  end

  // Why they hold: how the counters hang together, and where the token lies.
  wire [31:0] from_read = row_q >= read_q ? row_q - read_q : row_q + DEPTH - read_q;
  wire [31:0] used_rows = empty_q ? 0 : write_q > read_q ? write_q - read_q : write_q + DEPTH - read_q;
  always @* if (was_reset_q) begin
    assert (used_rows + valid_q == count_q);
    assert (empty_q == (write_q == read_q));
    assert (write_q < DEPTH && read_q < DEPTH);
    assert (space_q == SPACE[ADDR_WIDTH+1:0] - count_q);
    if (BOUNDED == 0 && !ready_o) assert (late_q <= MARGIN && count_q <= DEPTH - MARGIN + late_q);
    if (followed_q) assert (before_q < count_q);
    if (followed_q && before_q != 0) begin
      assert (row_q < DEPTH && before_q == from_read + 1);
      assert (rows[row_q] == token_q);
    end
  end

  // The FIFO gets full, and a token that found it so far leaves it.
  always @* if (was_reset_q) begin
    gets_full: cover (count_q == DEPTH);
    followed_to_the_end: cover (followed_q && before_q == 0 && pop);
    waits: cover (waiting_q && followed_q && before_q != 0);
  end
