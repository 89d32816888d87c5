// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Model of the ECP5's output cell of double data rate (ECP5 High-Speed I/O Interface,
// FPGA-TN-02035): takes two bits at the rising edge of its clock, and sends D0 while the clock is
// high, D1 while it is low. The real cell sends them some clocks later, all of its kind alike.
`default_nettype none

module ODDRX1F #(
  parameter GSR = "ENABLED"
) (
  input  wire SCLK,
  input  wire RST, // at any time: the output falls
  input  wire D0,
  input  wire D1,
  output reg  Q
);

  reg second_q;

  always @(posedge SCLK or negedge SCLK or posedge RST) begin
    if (RST) begin
      Q <= 1'b0;
      second_q <= 1'b0;
    end else if (SCLK) begin
      Q <= D0;
      second_q <= D1;
    end else Q <= second_q;
  end


endmodule

`default_nettype wire
