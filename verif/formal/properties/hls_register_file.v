// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_register_file, read inside the module. One row is watched, any of them.
  localparam [ADDR_WIDTH:0] CLEARING = {1'b1, {ADDR_WIDTH{1'b0}}};  // clocks
  (* anyconst *) wire [ADDR_WIDTH-1:0] watched;
  reg [ADDR_WIDTH:0] resets_q = 0;  // clocks of the reset, as far as they count
  reg [WIDTH-1:0] value_q = 0;  // the value that the row should have
  reg cleared_q = 1'b0;
  reg released_q = 1'b0;

  always @(posedge clk_i) begin
    released_q <= released_q || rst_ni;
    if (!rst_ni && resets_q != CLEARING) resets_q <= resets_q + 1'b1;
    if (!rst_ni && clear_q == watched) cleared_q <= 1'b1;
    if (rst_ni && write_en_i && write_addr_i == watched) value_q <= write_data_i;
  end

  // There is one reset, long enough.
  always @* begin
    assume (watched < ROWS);
    if (released_q) assume (rst_ni);
    if (rst_ni) assume (resets_q == CLEARING);
  end

  always @* begin
    if (rst_ni && read_addr_i == watched) last_written: assert (read_data_o == value_q);
  end

  // Why.
  always @* begin
    if (released_q) assert (resets_q == CLEARING);
    if (!released_q) assert (value_q == 0);
    if (resets_q != CLEARING) assert (clear_q == resets_q[ADDR_WIDTH-1:0]);
    if (resets_q != CLEARING) assert (cleared_q == (watched < clear_q));
    assert (resets_q <= CLEARING);
    if (resets_q == CLEARING) assert (cleared_q);
    if (cleared_q) assert (rows[watched] == value_q);
  end

  reg written_q = 1'b0;
  always @(posedge clk_i) written_q <= written_q || (rst_ni && write_en_i && write_addr_i == watched);
  always @* begin
    reads_zero: cover (rst_ni && !written_q && read_addr_i == watched);
    reads_written: cover (rst_ni && written_q && read_addr_i == watched && value_q != 0);
  end
