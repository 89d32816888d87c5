// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_synchroniser, read inside the module.
  reg [1:0] before_q;     // the signal, of the last two clocks
  reg [1:0] since_q = 0;  // clocks since the reset, at most 2
  reg was_reset_q = 1'b0;

  always @(posedge clk_i) begin
    was_reset_q <= was_reset_q || !rst_ni;
    before_q <= {before_q[0], data_i};
    if (was_reset_q && since_q != 2) since_q <= since_q + 1;
  end

  always @* assume (rst_ni == was_reset_q);

  always @* if (was_reset_q) begin
    if (since_q == 2) two_clocks_later: assert (data_o == before_q[1]);
    if (since_q != 2) in_reset: assert (data_o == RESET);
  end

  // Why.
  always @* if (was_reset_q) begin
    assert (since_q <= 2);
    if (since_q == 0) assert (data_q == {2{RESET != 0}});
    if (since_q != 0) assert (data_q[0] == before_q[0]);
  end

  always @* if (was_reset_q) begin
    follows: cover (since_q == 2 && data_o != before_q[0]);
  end
