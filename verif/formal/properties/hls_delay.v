// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_delay, read inside the module. One word is followed, any of them.
  (* anyseq *) wire follow;
  reg followed_q = 1'b0;
  reg [31:0] age_q = 0;
  reg [WIDTH-1:0] word_q;
  reg [ADDR_WIDTH-1:0] place_q;
  reg was_reset_q = 1'b0;

  always @(posedge clk_i) begin
    was_reset_q <= was_reset_q || !rst_ni;
    age_q <= age_q + 1;
    if (was_reset_q && !followed_q && follow) begin
      followed_q <= 1'b1;
      age_q <= 1;
      word_q <= data_i;
      place_q <= row_q;
    end else if (age_q == CLOCKS) followed_q <= 1'b0;
  end

  always @* assume (rst_ni == was_reset_q);

  always @* if (followed_q && age_q == CLOCKS) comes_out_in_time: assert (data_o == word_q);

  // Why.
  wire [31:0] since = row_q >= place_q ? row_q - place_q : row_q + (CLOCKS - 1) - place_q;
  always @* if (was_reset_q) assert (row_q < CLOCKS - 1);
  always @* if (followed_q) begin
    assert (was_reset_q);
    assert (place_q < CLOCKS - 1 && age_q >= 1 && age_q <= CLOCKS);
    if (age_q < CLOCKS) assert (rows[place_q] == word_q);
    if (age_q < CLOCKS) assert (since == (age_q == CLOCKS - 1 ? 0 : age_q));
  end

  always @* begin
    comes_out: cover (followed_q && age_q == CLOCKS && word_q != 0);
  end
