// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// For a module of several clocks: a step of the proof is an edge of some of them, any. The wire of a
// clock says whether this step is an edge of it; a register that has none keeps its value.
(* techmap_celltype = "$dff" *)
module two_clocks_register (CLK, D, Q);
  parameter WIDTH = 1;
  parameter CLK_POLARITY = 1;
  input CLK;
  input [WIDTH-1:0] D;
  output [WIDTH-1:0] Q;
  \$ff #(.WIDTH(WIDTH)) _TECHMAP_REPLACE_ (.D(CLK ? D : Q), .Q(Q));
endmodule
