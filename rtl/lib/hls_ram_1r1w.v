// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// RAM with a write port and a synchronous read port: data comes the clock after the address. A row
// that is written while it is read gives its old data. With EXCLUSIVE the user promises that this
// never happens, which saves logic around block RAM: an FPGA may then give any data. Only the
// assertion of that promise uses the reset.
//
// Parameters:
//   WIDTH       bits of a row, at least 1
//   ROWS        number of rows, at least 1
//   EXCLUSIVE   1: the user promises never to read a row in the clock that writes it; else 0
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
    parameter EXCLUSIVE = 0,
    parameter ADDR_WIDTH = ROWS > 1 ? $clog2(ROWS) : 1
) (
    input  wire                  clk_i,
    input  wire                  rst_ni,
    input  wire                  write_en_i,
    input  wire [ADDR_WIDTH-1:0] write_addr_i,
    input  wire [     WIDTH-1:0] write_data_i,
    input  wire                  read_en_i,
    input  wire [ADDR_WIDTH-1:0] read_addr_i,
    output reg  [     WIDTH-1:0] read_data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_ram_1r1w_WIDTH_must_be_at_least_1 stop ();
    end
    if (ROWS < 1) begin : bad_rows
      hls_ram_1r1w_ROWS_must_be_at_least_1 stop ();
    end
    if (EXCLUSIVE != 0 && EXCLUSIVE != 1) begin : bad_exclusive
      hls_ram_1r1w_EXCLUSIVE_must_be_0_or_1 stop ();
    end
    if (ADDR_WIDTH != (ROWS > 1 ? $clog2(ROWS) : 1)) begin : bad_addr_width
      hls_ram_1r1w_ADDR_WIDTH_must_follow_from_ROWS stop ();
    end
  endgenerate

  generate
    if (EXCLUSIVE != 0) begin : exclusive
      (* no_rw_check *)
      reg [WIDTH-1:0] rows[0:ROWS-1];
      always @(posedge clk_i) begin
        if (write_en_i) rows[write_addr_i] <= write_data_i;
        if (read_en_i) read_data_o <= rows[read_addr_i];
      end
    end else begin : any
      reg [WIDTH-1:0] rows[0:ROWS-1];
      always @(posedge clk_i) begin
        if (write_en_i) rows[write_addr_i] <= write_data_i;
        if (read_en_i) read_data_o <= rows[read_addr_i];
      end
    end
  endgenerate

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (EXCLUSIVE != 0 && rst_ni && write_en_i && read_en_i && write_addr_i == read_addr_i) begin
      $display("%m: row %0d is written while it is read", write_addr_i);
      $stop;
    end
  end
`else
  wire unused = &{1'b0, rst_ni};
`endif

endmodule

`default_nettype wire
