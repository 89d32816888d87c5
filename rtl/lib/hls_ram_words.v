// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// RAM whose rows are written whole and read a word at a time: word w of row r is read at {w, r}, and
// data come the clock after the address. Word w is written w clocks after its row came. Until the
// last word is written no other row may come and no word of this row may be read: an FPGA may give
// any data.
//
// Waiting rows have no enable, so RAMs with the same write port share one after synthesis.
//
// Parameters:
//   WIDTH      bits of a word, at least 1
//   WORDS      words of a row, at least 2
//   ROWS       number of rows, a power of two
//   ROW_BITS   bits of the number of a row; follows from ROWS, leave it as it is
//   WORD_BITS  bits of the number of a word; follows from WORDS, leave it as it is
//
// Ports:
//   clk_i, rst_ni                           clock and synchronous reset, active low
//   write_en_i, write_addr_i, write_data_i  write port, word 0 in the lowest bits
//   read_en_i, read_addr_i                  read port; without read_en_i the data do not change
//   read_data_o                             the word, a clock after its address
`default_nettype none

module hls_ram_words #(
    parameter WIDTH = 8,
    parameter WORDS = 3,
    parameter ROWS = 16,
    parameter ROW_BITS = ROWS > 1 ? $clog2(ROWS) : 1,
    parameter WORD_BITS = WORDS > 1 ? $clog2(WORDS) : 1
) (
    input  wire                          clk_i,
    input  wire                          rst_ni,
    input  wire                          write_en_i,
    input  wire [          ROW_BITS-1:0] write_addr_i,
    input  wire [       WORDS*WIDTH-1:0] write_data_i,
    input  wire                          read_en_i,
    input  wire [ROW_BITS+WORD_BITS-1:0] read_addr_i,
    output reg  [             WIDTH-1:0] read_data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_ram_words_WIDTH_must_be_at_least_1 stop ();
    end
    if (WORDS < 2) begin : bad_words
      hls_ram_words_WORDS_must_be_at_least_2 stop ();
    end
    if (ROWS < 1 || (ROWS & (ROWS - 1)) != 0) begin : bad_rows
      hls_ram_words_ROWS_must_be_a_power_of_two stop ();
    end
    if (ROW_BITS != (ROWS > 1 ? $clog2(ROWS) : 1)) begin : bad_row_bits
      hls_ram_words_ROW_BITS_must_follow_from_ROWS stop ();
    end
    if (WORD_BITS != (WORDS > 1 ? $clog2(WORDS) : 1)) begin : bad_word_bits
      hls_ram_words_WORD_BITS_must_follow_from_WORDS stop ();
    end
  endgenerate

  // In these vectors, part w belongs to the row of w clocks ago: whether one came, its number, its
  // word w.
  reg  [           WORDS-2:0] late_q;
  reg  [(WORDS-1)*ROW_BITS-1:0] rows_q;
  wire [           WORDS-1:0] came = {late_q, write_en_i};
  wire [  WORDS*ROW_BITS-1:0] row = {rows_q, write_addr_i};
  wire [     WORDS*WIDTH-1:0] word;

  always @(posedge clk_i) begin
    late_q <= came[WORDS-2:0] & {(WORDS - 1) {rst_ni}};
    rows_q <= row[(WORDS-1)*ROW_BITS-1:0];
  end

  genvar w;
  generate
    for (w = 1; w < WORDS; w = w + 1) begin : waiting
      reg  [    w*WIDTH-1:0] line_q;
      wire [(w+1)*WIDTH-1:0] line = {line_q, write_data_i[w*WIDTH+:WIDTH]};
      assign word[w*WIDTH+:WIDTH] = line[w*WIDTH+:WIDTH];
      always @(posedge clk_i) line_q <= line[w*WIDTH-1:0];
    end
  endgenerate
  assign word[WIDTH-1:0] = write_data_i[WIDTH-1:0];

  reg [ROW_BITS+WORD_BITS-1:0] to;
  reg [WIDTH-1:0] data;
  integer i;
  always @* begin
    to = {{WORD_BITS{1'b0}}, write_addr_i};
    data = word[WIDTH-1:0];
    for (i = 1; i < WORDS; i = i + 1) begin
      if (came[i]) begin
        to = {i[WORD_BITS-1:0], row[i*ROW_BITS+:ROW_BITS]};
        data = word[i*WIDTH+:WIDTH];
      end
    end
  end

  (* no_rw_check *)
  reg [WIDTH-1:0] rows[0:WORDS*ROWS-1];
  always @(posedge clk_i) begin
    if (|came) rows[to] <= data;
    if (read_en_i) read_data_o <= rows[read_addr_i];
  end

`ifdef HLS_ASSERT
  integer k;
  always @(posedge clk_i) if (rst_ni) begin
    if (write_en_i && |late_q) begin
      $display("%m: row %0d comes while another is being written", write_addr_i);
      $stop;
    end
    for (k = 0; k < WORDS; k = k + 1) begin
      if (read_en_i && came[k] && row[k*ROW_BITS+:ROW_BITS] == read_addr_i[ROW_BITS-1:0]) begin
        $display("%m: row %0d is read while it is being written", row[k*ROW_BITS+:ROW_BITS]);
        $stop;
      end
    end
  end
`endif

endmodule

`default_nettype wire
