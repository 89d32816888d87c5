// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Properties of hls_ram_1r1w, read inside the module. One row is watched, any of them, from when it
// is first written. A single row is at every address.
  (* anyconst *) wire [ADDR_WIDTH-1:0] watched;
  reg written_q = 1'b0;
  reg [WIDTH-1:0] value_q;
  reg read_q = 1'b0;  // the watched row was read last
  reg torn_q = 1'b0;  // in the clock that wrote it
  reg [WIDTH-1:0] expected_q;
  wire writes = write_en_i && (ROWS == 1 || write_addr_i == watched);
  wire reads = read_en_i && (ROWS == 1 || read_addr_i == watched);

  always @(posedge clk_i) begin
    if (writes) begin
      written_q <= 1'b1;
      value_q <= write_data_i;
    end
    if (read_en_i) begin
      read_q <= written_q && reads;
      torn_q <= writes && reads;
      expected_q <= value_q;
    end
  end

  always @* begin
    assume (watched < ROWS);
    if (TORN == 0 && ROWS != 1) assume (!(write_en_i && read_en_i && write_addr_i == read_addr_i));
  end

  // With TORN, bits of a row that nobody wrote while it was read, without the lowest.
  wire [WIDTH-1:0] differ = read_data_o ^ expected_q;
  wire whole = !torn_q || (TORN == 0 && ROWS == 1);
  always @* if (read_q && whole) last_written: assert (differ >> TORN == 0);
  always @* if (TORN != 0 && (read_q || torn_q)) tells: assert (read_data_o[0] == torn_q);

  // Why. The name of the array depends on the branch of the module that it lies in.
  generate
    if (TORN != 0) begin : in_torn
      always @* if (written_q) assert (torn.rows[watched] == value_q[WIDTH-1:1]);
    end
    if (TORN == 0 && ROWS == 1) begin : in_single
      always @* if (written_q) assert (single.row == value_q);
    end
    if (TORN == 0 && ROWS != 1) begin : in_exclusive
      genvar low;
      for (low = 0; low < WIDTH; low = low + COLUMN) begin : column
        wire [WIDTH-1:0] rest = value_q >> low;
        always @* if (written_q)
          assert (exclusive.column[low].rows[watched] == rest[exclusive.column[low].BITS-1:0]);
      end
    end
  endgenerate

  always @* begin
    reads_while_written: cover (read_q && writes);
    reads_older: cover (read_q && value_q != expected_q);
  end
