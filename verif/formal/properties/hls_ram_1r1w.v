// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_ram_1r1w, read inside the module. One row is watched, any of them, from when it
// is first written.
  (* anyconst *) wire [ADDR_WIDTH-1:0] watched;
  reg written_q = 1'b0;
  reg [WIDTH-1:0] value_q;
  reg read_q = 1'b0;  // the watched row was read last
  reg [WIDTH-1:0] expected_q;
  wire writes = write_en_i && write_addr_i == watched;

  always @(posedge clk_i) begin
    if (writes) begin
      written_q <= 1'b1;
      value_q <= write_data_i;
    end
    if (read_en_i) begin
      read_q <= written_q && read_addr_i == watched;
      expected_q <= value_q;
    end
  end

  always @* begin
    assume (watched < ROWS);
    if (EXCLUSIVE != 0) assume (!(write_en_i && read_en_i && write_addr_i == read_addr_i));
  end

  always @* if (read_q) last_written: assert (read_data_o == expected_q);

  // Why. The name of the array depends on the branch of the module that it lies in.
  generate
    if (EXCLUSIVE != 0) begin : in_exclusive
      always @* if (written_q) assert (exclusive.rows[watched] == value_q);
    end else begin : in_any
      always @* if (written_q) assert (any.rows[watched] == value_q);
    end
  endgenerate

  always @* begin
    reads_while_written: cover (read_q && writes);
    reads_older: cover (read_q && value_q != expected_q);
  end
