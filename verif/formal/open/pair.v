// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where a unit and the same unit of another clock are put together (pair.py).
`default_nettype none

module pair (
    input wire clk_i,
    input wire rst_ni
);

endmodule

`default_nettype wire
