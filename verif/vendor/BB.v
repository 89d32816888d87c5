// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Model of the ECP5's pad of two directions, by the name of the vendor's library: driven while
// T is low.
`default_nettype none

module BB (
  input  wire I,
  input  wire T,
  output wire O,
  inout  wire B
);

  assign B = T ? 1'bz : I;
  assign O = B;

endmodule

`default_nettype wire
