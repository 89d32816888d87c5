// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_ram_words, read inside the module. One row is followed, any of them.
  (* anyconst *) wire [ROW_BITS-1:0] follow;
  reg [WORDS*WIDTH-1:0] written_q;
  reg known_q = 1'b0;
  reg [WORDS*WIDTH-1:0] expected_q;
  reg [WORD_BITS-1:0] read_word_q;
  reg read_q = 1'b0;
  reg was_reset_q = 1'b0;

  wire mine = write_en_i && write_addr_i == follow;
  wire [WORDS-1:0] mine_came;
  generate
    for (w = 0; w < WORDS; w = w + 1) begin : follows
      assign mine_came[w] = came[w] && row[w*ROW_BITS+:ROW_BITS] == follow;
    end
  endgenerate
  wire looks = read_en_i && read_addr_i[ROW_BITS-1:0] == follow;

  always @(posedge clk_i) begin
    if (mine) written_q <= write_data_i;
    if (mine) known_q <= 1'b1;
    read_q <= known_q && looks && read_addr_i[ROW_BITS+:WORD_BITS] < WORDS;
    read_word_q <= read_addr_i[ROW_BITS+:WORD_BITS];
    expected_q <= written_q;
    if (!rst_ni) begin
      known_q <= 1'b0;
      read_q <= 1'b0;
      was_reset_q <= 1'b1;
    end
  end

  // The promises of writer and reader.
  always @* begin
    assume (rst_ni == was_reset_q);
    if (|late_q) assume (!write_en_i);
    if (|mine_came) assume (!looks);
  end

  always @* if (was_reset_q && read_q)
    last_written: assert (read_data_o == expected_q[read_word_q*WIDTH+:WIDTH]);

  // Why it holds: at most one row waits, and each word of the followed one waits or is in its place.
  always @* if (was_reset_q) assert ((late_q & (late_q - 1'b1)) == 0);
  genvar k;
  generate
    for (w = 0; w < WORDS; w = w + 1) begin : place
      wire [WIDTH-1:0] value = written_q[w*WIDTH+:WIDTH];
      wire [WIDTH-1:0] stored = rows[{w[WORD_BITS-1:0], follow}];
      if (w == 0) begin : first
        always @* if (was_reset_q && known_q) assert (stored == value);
      end else begin : later
        always @* if (was_reset_q && known_q && !(|mine_came[w:1])) assert (stored == value);
        for (k = 1; k <= w; k = k + 1) begin : waits
          always @* if (was_reset_q && mine_came[k])
            assert (known_q && waiting[w].line[k*WIDTH+:WIDTH] == value);
        end
      end
    end
  endgenerate

  // Each word is read after the row was written twice.
  reg twice_q = 1'b0;
  always @(posedge clk_i) if (mine && known_q) twice_q <= 1'b1;
  always @* if (was_reset_q) begin
    lowest: cover (read_q && twice_q && read_word_q == 0);
    highest: cover (read_q && twice_q && read_word_q == WORDS - 1);
  end
