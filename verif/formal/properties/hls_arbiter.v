// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_arbiter, read inside the module. One writer is watched, any of them.
  (* anyconst *) wire [7:0] watched;
  reg [7:0] others_q = 0;  // tokens of others that left since the watched writer waits
  reg [INPUTS-1:0] held_q = 0;  // inputs that wait
  reg [INPUTS*WIDTH-1:0] held_data_q;
  reg waiting_q = 1'b0;
  reg idle_q = 1'b0;  // the reader was ready and a token waited, but none left
  reg [WIDTH-1:0] offered_data_q;
  reg was_reset_q = 1'b0;

  integer n;
  reg [7:0] granted;
  reg [INPUTS-1:0] changed;
  reg wants;  // the watched writer
  reg served;
  reg held;
  reg [WIDTH-1:0] watched_data;
  always @* begin
    granted = 0;
    wants = 1'b0;
    served = 1'b0;
    held = 1'b0;
    watched_data = 0;
    for (n = 0; n < INPUTS; n = n + 1) begin
      if (grant_q[n]) granted = n;
      changed[n] = data_i[n*WIDTH+:WIDTH] != held_data_q[n*WIDTH+:WIDTH];
      if (watched == n) begin
        wants = valid_i[n];
        served = valid_i[n] && ready_o[n];
        held = held_q[n];
        watched_data = data_i[n*WIDTH+:WIDTH];
      end
    end
  end

  always @(posedge clk_i) begin
    others_q <= !wants || served ? 0 : others_q + (valid_o && ready_i);
    held_q <= valid_i & ~ready_o;
    held_data_q <= data_i;
    waiting_q <= valid_o && !ready_i;
    idle_q <= ready_i && |valid_i && !valid_o;
    offered_data_q <= data_o;
    if (!rst_ni) begin
      others_q <= 0;
      held_q <= 0;
      waiting_q <= 1'b0;
      idle_q <= 1'b0;
      was_reset_q <= 1'b1;
    end
  end

  // Writers keep an offered token.
  always @* begin
    assume (rst_ni == was_reset_q);
    assume (watched < INPUTS);
    assume ((held_q & ~valid_i) == 0 && (held_q & changed) == 0);
  end

  always @* if (was_reset_q) begin
    one_at_a_time: assert ((ready_o & (ready_o - ONE)) == 0);
    kept: assert ((valid_o && ready_i) == ((valid_i & ready_o) != 0));
    if (idle_q) idle_for_one_clock: assert (valid_o);
    if (served) its_own_data: assert (data_o == watched_data);
    starves_no_one: assert (others_q < INPUTS);
    if (waiting_q) steady: assert (valid_o && data_o == offered_data_q);
  end

  // Why: every clock in which the reader is ready brings the grant, which goes round, nearer to the
  // watched writer, if that waits.
  wire [7:0] turns = watched >= granted ? watched - granted : watched + INPUTS - granted;
  always @* if (was_reset_q) begin
    assert (grant_q != 0 && (grant_q & (grant_q - ONE)) == 0);
    if (idle_q) assert ((grant_q & held_q) != 0);
    if (waiting_q) assert ((grant_q & held_q) != 0 && offered_data_q == data_o);
    if (held) assert (others_q + turns < INPUTS);
    else assert (others_q == 0);
  end

  always @* if (was_reset_q) begin
    waits_longest: cover (served && others_q == INPUTS - 1);
    all_wait: cover (waiting_q && ready_i && held_q == {INPUTS{1'b1}});
    comes_without_the_grant: cover (idle_q);
  end
