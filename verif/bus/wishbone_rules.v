// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the specification of Wishbone, revision B4, asks of both ends of a pipelined bus, with the
// numbers of its rules and sections; and that an access which is stalled stays as it is, as every
// interconnect expects.
//
// A simulation asserts the rules of both ends. A proof asserts those of the end that is proved and
// assumes those of the other.
`default_nettype none

`define RULE(name, environment, condition) \
  generate \
    if (environment) begin : name``_assumed \
      always @* if (checked) assume (condition); \
    end else begin : name``_asserted \
      always @(posedge clk_i) if (checked) name: assert (condition); \
    end \
  endgenerate

module wishbone_rules #(
  parameter ADDRESS_BITS = 32,
  parameter BYTES = 4,
  parameter FLIGHT_BITS = 8, // fewer than 2^FLIGHT_BITS accesses are in flight
  parameter GIVES_UP = 0,    // the manager may end a cycle before its answers
  parameter SELECTS_NONE = 0, // an access may select no byte
  parameter MANAGER_ASSUMED = 0,
  parameter SUBORDINATE_ASSUMED = 0
) (
  input wire                    clk_i,
  input wire                    rst_ni,
  input wire                    cyc,
  input wire                    stb,
  input wire                    we,
  input wire [ADDRESS_BITS-1:0] adr,
  input wire [8*BYTES-1:0]      dat_w,
  input wire [BYTES-1:0]        sel,
  input wire                    stall,
  input wire                    ack,
  input wire                    err
);

  reg was_reset_q = 1'b0; // there has been a reset, so that there are rules
  always @(posedge clk_i) if (!rst_ni) was_reset_q <= 1'b1;
  wire checked = was_reset_q && rst_ni;

  // Rule 3.20: CYC and STB are low in the clock after a reset.
  reg in_reset_q;
  always @(posedge clk_i) in_reset_q <= !rst_ni;
  `RULE(quiet_after_reset, MANAGER_ASSUMED, !in_reset_q || !(cyc || stb))

  // Rule 3.25: CYC is high while STB is, and until the last answer (3.2.2).
  reg [FLIGHT_BITS-1:0] flight_q; // accesses that are not answered
  wire taken = cyc && stb && !stall;
  wire answered = ack || err;
  always @(posedge clk_i) begin
    flight_q <= flight_q + {{FLIGHT_BITS - 1{1'b0}}, taken} - {{FLIGHT_BITS - 1{1'b0}}, answered};
    if (!rst_ni || !cyc) flight_q <= {FLIGHT_BITS{1'b0}};
  end
  `RULE(stb_within_cyc, MANAGER_ASSUMED, !stb || cyc)
  `RULE(cyc_until_answered, MANAGER_ASSUMED, GIVES_UP || flight_q == 0 || cyc)
  `RULE(flight_is_bounded, MANAGER_ASSUMED, !stb || flight_q != {FLIGHT_BITS{1'b1}})

  // 3.1.3.2: STALL holds an access.
  localparam A = 1 + ADDRESS_BITS + 9 * BYTES;
  wire [A-1:0] access = {we, adr, dat_w, sel};
  reg          waits_q;
  reg [A-1:0]  access_q;
  always @(posedge clk_i) begin
    waits_q <= rst_ni && cyc && stb && stall;
    access_q <= access;
  end
  `RULE(stalled_is_steady, MANAGER_ASSUMED,
        !waits_q || (GIVES_UP && !cyc) || (stb && access == access_q))
  `RULE(some_byte_selected, MANAGER_ASSUMED, SELECTS_NONE || !stb || sel != 0)

  // Rule 3.35, 3.45: ACK and ERR answer an access, one of them.
  `RULE(answer_was_asked_for, SUBORDINATE_ASSUMED, !answered || (cyc && (flight_q != 0 || taken)))
  `RULE(one_answer, SUBORDINATE_ASSUMED, !(ack && err))

endmodule

`default_nettype wire
