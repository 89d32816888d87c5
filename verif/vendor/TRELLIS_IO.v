// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Model of the ECP5's pad (Yosys and nextpnr call it so): driven while T is low.
`default_nettype none

module TRELLIS_IO #(
  parameter DIR = "INPUT"
) (
  inout  wire B,
  input  wire I,
  input  wire T,
  output wire O
);

  generate
    if (DIR != "INPUT") begin : driven
      assign B = T ? 1'bz : I;
    end else begin : read
      wire unused = &{1'b0, I, T};
    end
  endgenerate
  assign O = B;

endmodule

`default_nettype wire
