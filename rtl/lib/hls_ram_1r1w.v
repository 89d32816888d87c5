// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// RAM with a write port and a synchronous read port: data comes the clock after the address. A row
// that is read while it is written may be any data in an FPGA. Either the user promises that this
// never happens, and only the assertion of that promise uses the reset; or the lowest bit that is
// read is one then and zero else, whatever was written there. More than 2,048 rows lie in memories
// of 4 bits, of which a block RAM of ECP5 holds 4,096 rows: synthesis would take blocks of 2,048
// rows and a multiplexer behind them, and a stage behind that cannot be the register in a block. A
// single row lies in registers: addresses are not looked at, and if it is written while it is read,
// the data are those before.
//
// Parameters:
//   WIDTH       bits of a row, of which TORN takes one; at least 1
//   ROWS        number of rows, at least 1
//   BLOCK       1 asks for block RAM, 0 leaves it to synthesis; 0 to 1
//   TORN        1 for the lowest bit that tells, 0 for the promise; 0 to 1
//   COLUMN      bits of a row in one memory, without TORN; at least 1
//   ADDR_WIDTH  bits of an address; follows from ROWS, leave it as it is
//
// Ports:
//   clk_i, rst_ni                           clock and synchronous reset, active low
//   write_en_i, write_addr_i, write_data_i  write port
//   read_en_i, read_addr_i                  read port; without read_en_i the data do not change
//   read_data_o                             the row, a clock after its address
`default_nettype none

module hls_ram_1r1w #(
    parameter WIDTH = 8,
    parameter ROWS = 16,
    parameter BLOCK = 0,
    parameter TORN = 0,
    parameter COLUMN = ROWS > 2048 && WIDTH > 4 ? 4 : WIDTH,
    parameter ADDR_WIDTH = ROWS > 1 ? $clog2(ROWS) : 1
) (
    input  wire                  clk_i,
    input  wire                  rst_ni,
    input  wire                  write_en_i,
    input  wire [ADDR_WIDTH-1:0] write_addr_i,
    input  wire [     WIDTH-1:0] write_data_i,
    input  wire                  read_en_i,
    input  wire [ADDR_WIDTH-1:0] read_addr_i,
    output wire [     WIDTH-1:0] read_data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1 + TORN) begin : bad_width
      hls_ram_1r1w_WIDTH_must_be_at_least_1_beside_TORN stop ();
    end
    if (ROWS < 1) begin : bad_rows
      hls_ram_1r1w_ROWS_must_be_at_least_1 stop ();
    end
    if (BLOCK != 0 && BLOCK != 1) begin : bad_block
      hls_ram_1r1w_BLOCK_must_be_0_or_1 stop ();
    end
    if (TORN != 0 && TORN != 1) begin : bad_torn
      hls_ram_1r1w_TORN_must_be_0_or_1 stop ();
    end
    if (COLUMN < 1 && WIDTH >= 1) begin : bad_column
      hls_ram_1r1w_COLUMN_must_be_at_least_1 stop ();
    end
    if (ADDR_WIDTH != (ROWS > 1 ? $clog2(ROWS) : 1)) begin : bad_addr_width
      hls_ram_1r1w_ADDR_WIDTH_must_follow_from_ROWS stop ();
    end
  endgenerate

  // verilator lint_off UNUSEDPARAM
  localparam STYLE = BLOCK != 0 ? "block" : "auto";
  // verilator lint_on UNUSEDPARAM

  // Three conditions and no else, as that would change the names of the branches in synthesis.
  generate
    if (TORN != 0) begin : torn
      (* no_rw_check, ram_style = STYLE *)
      reg [WIDTH-1:1] rows[0:ROWS-1];
      reg [WIDTH-1:1] row_q;
      reg torn_q;
      always @(posedge clk_i) begin
        if (write_en_i) rows[write_addr_i] <= write_data_i[WIDTH-1:1];
        if (read_en_i) begin
          row_q <= rows[read_addr_i];
          torn_q <= write_en_i && write_addr_i == read_addr_i;
        end
      end
      assign read_data_o = {row_q, torn_q};
      wire unused = &{1'b0, write_data_i[0]};
    end
    if (TORN == 0 && ROWS == 1) begin : single
      reg [WIDTH-1:0] row;
      reg [WIDTH-1:0] row_q;
      always @(posedge clk_i) begin
        if (write_en_i) row <= write_data_i;
        if (read_en_i) row_q <= row;
      end
      assign read_data_o = row_q;
      wire unused = &{1'b0, write_addr_i, read_addr_i};
    end
    if (TORN == 0 && ROWS != 1) begin : exclusive
      localparam STEP = COLUMN < 1 ? WIDTH : COLUMN;  // the loop ends for a bad one too
      genvar low;
      for (low = 0; low < WIDTH; low = low + STEP) begin : column
        localparam BITS = low + STEP > WIDTH ? WIDTH - low : STEP;
        (* no_rw_check, ram_style = STYLE *)
        reg [BITS-1:0] rows[0:ROWS-1];
        reg [BITS-1:0] row_q;
        always @(posedge clk_i) begin
          if (write_en_i) rows[write_addr_i] <= write_data_i[low+:BITS];
          if (read_en_i) row_q <= rows[read_addr_i];
        end
        assign read_data_o[low+:BITS] = row_q;
      end
    end
  endgenerate

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (TORN == 0 && ROWS != 1 && rst_ni && write_en_i && read_en_i &&
        write_addr_i == read_addr_i) begin
      $display("%m: row %0d is written while it is read", write_addr_i);
      $stop;
    end
  end
`else
  wire unused = &{1'b0, rst_ni};
`endif

endmodule

`default_nettype wire
