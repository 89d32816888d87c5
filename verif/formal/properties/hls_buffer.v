// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_buffer, read inside the module. One token is followed, any of them.
  (* anyseq *) wire follow;
  reg followed_q = 1'b0;
  reg before_q = 1'b0;  // one token is before the one that is followed
  reg [1:0] count_q;  // tokens inside
  reg [WIDTH-1:0] token_q;
  reg [WIDTH-1:0] offered_q;
  reg waiting_q = 1'b0;
  reg was_reset_q = 1'b0;
  wire push = valid_i && ready_o;
  wire pop = valid_o && ready_i;

  always @(posedge clk_i) begin
    count_q <= count_q + push - pop;
    if (push && follow && !followed_q) begin
      followed_q <= 1'b1;
      before_q <= count_q != 0 && !pop;
      token_q <= data_i;
    end else if (followed_q && pop) begin
      if (!before_q) followed_q <= 1'b0;
      before_q <= 1'b0;
    end
    waiting_q <= rst_ni && valid_o && !ready_i;
    offered_q <= data_o;
    if (!rst_ni) begin
      count_q <= 0;
      followed_q <= 1'b0;
      was_reset_q <= 1'b1;
    end
  end

  always @* assume (rst_ni == was_reset_q);

  always @* if (was_reset_q) begin
    kept: assert (valid_o == (count_q != 0));
    if (followed_q && !before_q) in_order: assert (data_o == token_q);
    ready_with_room: assert (ready_o == (count_q < 2));
    if (waiting_q) steady: assert (valid_o && data_o == offered_q);
  end

  // Why they hold: where the tokens lie.
  always @* if (was_reset_q) begin
    assert (count_q == valid_q + full_q && (valid_q || !full_q));
    if (followed_q) assert (before_q ? full_q && second_q == token_q : valid_q);
  end

  always @* if (was_reset_q) begin
    gets_full: cover (full_q);
    followed_to_the_end: cover (followed_q && !before_q && pop);
    waits: cover (waiting_q && followed_q && before_q);
  end
