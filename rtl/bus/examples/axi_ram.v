// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The smallest memory on AXI4 that dynrt_axi can have: on-chip RAM, one burst at a time,
// incrementing and as wide as the bus. It stands for the controller of a real memory.
`default_nettype none

module axi_ram #(
  parameter BYTES = 16,   // of a beat
  parameter ID_BITS = 10,
  parameter ROWS_LOG2 = 12
) (
  input  wire               clk_i,
  input  wire               rst_ni,
  input  wire               arvalid,
  output wire               arready,
  input  wire [ID_BITS-1:0] arid,
  input  wire [31:0]        araddr,
  input  wire [7:0]         arlen,
  output reg                rvalid,
  input  wire               rready,
  output reg  [ID_BITS-1:0] rid,
  output reg  [8*BYTES-1:0] rdata,
  output reg                rlast,
  input  wire               awvalid,
  output wire               awready,
  input  wire [ID_BITS-1:0] awid,
  input  wire [31:0]        awaddr,
  input  wire               wvalid,
  output wire               wready,
  input  wire [8*BYTES-1:0] wdata,
  input  wire [BYTES-1:0]   wstrb,
  input  wire               wlast,
  output reg                bvalid,
  input  wire               bready,
  output reg  [ID_BITS-1:0] bid
);

  localparam LOW = $clog2(BYTES);
  reg [8*BYTES-1:0]   rows [0:(1<<ROWS_LOG2)-1];
  reg                 reading_q, writing_q;
  reg [ROWS_LOG2-1:0] read_q, write_q;
  reg [7:0]           left_q;
  assign arready = !reading_q && !rvalid;
  assign awready = !writing_q && !bvalid;
  assign wready = writing_q;

  integer i;
  always @(posedge clk_i) begin
    if (reading_q && (!rvalid || rready)) begin
      rdata <= rows[read_q];
      read_q <= read_q + 1'b1;
      left_q <= left_q - 8'd1;
    end
    for (i = 0; i < BYTES; i = i + 1)
      if (wvalid && wready && wstrb[i]) rows[write_q][8*i +: 8] <= wdata[8*i +: 8];
    if (wvalid && wready) write_q <= write_q + 1'b1;
    if (arvalid && arready) begin
      rid <= arid;
      read_q <= araddr[LOW +: ROWS_LOG2];
      left_q <= arlen;
    end
    if (awvalid && awready) begin
      bid <= awid;
      write_q <= awaddr[LOW +: ROWS_LOG2];
    end
  end
  always @(posedge clk_i) begin
    if (!rvalid || rready) rvalid <= reading_q;
    if (!rvalid || rready) rlast <= left_q == 8'd0;
    if (arvalid && arready) reading_q <= 1'b1;
    else if ((!rvalid || rready) && left_q == 8'd0) reading_q <= 1'b0;
    writing_q <= (awvalid && awready) || (writing_q && !(wvalid && wlast));
    bvalid <= (wvalid && wready && wlast) || (bvalid && !bready);
    if (!rst_ni) begin
      rvalid <= 1'b0;
      reading_q <= 1'b0;
      writing_q <= 1'b0;
      bvalid <= 1'b0;
    end
  end

  wire unused = &{1'b0, araddr, awaddr};

endmodule

`default_nettype wire
