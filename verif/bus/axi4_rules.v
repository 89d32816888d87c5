// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the specification of AXI4 (IHI 0022) asks of both ends of a bus, as far as dynrt uses it:
// bursts INCR without exclusive accesses. Of strobes they ask that they are steady, but not that they
// lie in the lanes of a narrow or unaligned burst (A3.4.3): dynrt has none. Section numbers are those of its issue E. AXI4-Lite is
// the same with bursts of one beat, one id and LITE = 1.
//
// A simulation asserts the rules of both ends. A proof asserts those of the end that is proved and
// assumes those of the other.
`default_nettype none

// A rule of an end, in every clock: where the end is the environment of a proof it is an
// assumption.
`define RULE(name, environment, condition) \
  generate \
    if (environment) begin : name``_assumed \
      always @* if (checked) assume (condition); \
    end else begin : name``_asserted \
      always @(posedge clk_i) if (checked) name: assert (condition); \
    end \
  endgenerate

module axi4_rules #(
  parameter ID_BITS = 1,
  parameter ADDRESS_BITS = 32,
  parameter BYTES = 4,
  parameter READ_SLOTS_BITS = 2,  // 2^READ_SLOTS_BITS reads of an id are in flight at most
  parameter WRITE_SLOTS_BITS = 2, // and 2^WRITE_SLOTS_BITS writes
  parameter LITE = 0,
  parameter MANAGER_ASSUMED = 0,
  parameter SUBORDINATE_ASSUMED = 0
) (
  input wire                    clk_i,
  input wire                    rst_ni,
  input wire                    arvalid,
  input wire                    arready,
  input wire [ID_BITS-1:0]      arid,
  input wire [ADDRESS_BITS-1:0] araddr,
  input wire [7:0]              arlen,
  input wire [2:0]              arsize,
  input wire [1:0]              arburst,
  input wire                    arlock,
  input wire [3:0]              arcache,
  input wire [2:0]              arprot,
  input wire [3:0]              arqos,
  input wire                    rvalid,
  input wire                    rready,
  input wire [ID_BITS-1:0]      rid,
  input wire [8*BYTES-1:0]      rdata,
  input wire [1:0]              rresp,
  input wire                    rlast,
  input wire                    awvalid,
  input wire                    awready,
  input wire [ID_BITS-1:0]      awid,
  input wire [ADDRESS_BITS-1:0] awaddr,
  input wire [7:0]              awlen,
  input wire [2:0]              awsize,
  input wire [1:0]              awburst,
  input wire                    awlock,
  input wire [3:0]              awcache,
  input wire [2:0]              awprot,
  input wire [3:0]              awqos,
  input wire                    wvalid,
  input wire                    wready,
  input wire [8*BYTES-1:0]      wdata,
  input wire [BYTES-1:0]        wstrb,
  input wire                    wlast,
  input wire                    bvalid,
  input wire                    bready,
  input wire [ID_BITS-1:0]      bid,
  input wire [1:0]              bresp
);

  localparam IDS = 1 << ID_BITS;
  localparam READ_SLOTS = 1 << READ_SLOTS_BITS, WRITE_SLOTS = 1 << WRITE_SLOTS_BITS;
  localparam [1:0] INCR = 2'b01, EXOKAY = 2'b01;

  reg was_reset_q = 1'b0; // there has been a reset, so that there are rules
  always @(posedge clk_i) if (!rst_ni) was_reset_q <= 1'b1;
  wire checked = was_reset_q && rst_ni;

  wire ar_taken = arvalid && arready, r_taken = rvalid && rready;
  wire aw_taken = awvalid && awready, w_taken = wvalid && wready, b_taken = bvalid && bready;

  // A3.1.2: in the first clock after a reset no valid is high that a register of before has set.
  reg in_reset_q;
  always @(posedge clk_i) in_reset_q <= !rst_ni;
  `RULE(manager_quiet_after_reset, MANAGER_ASSUMED, !in_reset_q || !(arvalid || awvalid || wvalid))
  `RULE(subordinate_quiet_after_reset, SUBORDINATE_ASSUMED, !in_reset_q || !(rvalid || bvalid))

  // A3.2.1: a valid stays high until its ready, and its payload does not change.
  localparam A = ID_BITS + ADDRESS_BITS + 25;
  wire [A-1:0] ar = {arid, araddr, arlen, arsize, arburst, arlock, arcache, arprot, arqos};
  wire [A-1:0] aw = {awid, awaddr, awlen, awsize, awburst, awlock, awcache, awprot, awqos};
  wire [9*BYTES:0] w = {wdata, wstrb, wlast};
  wire [ID_BITS+8*BYTES+2:0] r = {rid, rdata, rresp, rlast};
  wire [ID_BITS+1:0] b = {bid, bresp};
  reg ar_waits_q, aw_waits_q, w_waits_q, r_waits_q, b_waits_q;
  reg [A-1:0] ar_q, aw_q;
  reg [9*BYTES:0] w_q;
  reg [ID_BITS+8*BYTES+2:0] r_q;
  reg [ID_BITS+1:0] b_q;
  always @(posedge clk_i) begin
    ar_waits_q <= rst_ni && arvalid && !arready;
    aw_waits_q <= rst_ni && awvalid && !awready;
    w_waits_q <= rst_ni && wvalid && !wready;
    r_waits_q <= rst_ni && rvalid && !rready;
    b_waits_q <= rst_ni && bvalid && !bready;
    ar_q <= ar;
    aw_q <= aw;
    w_q <= w;
    r_q <= r;
    b_q <= b;
  end
  `RULE(ar_steady, MANAGER_ASSUMED, !ar_waits_q || (arvalid && ar == ar_q))
  `RULE(aw_steady, MANAGER_ASSUMED, !aw_waits_q || (awvalid && aw == aw_q))
  `RULE(w_steady, MANAGER_ASSUMED, !w_waits_q || (wvalid && w == w_q))
  `RULE(r_steady, SUBORDINATE_ASSUMED, !r_waits_q || (rvalid && r == r_q))
  `RULE(b_steady, SUBORDINATE_ASSUMED, !b_waits_q || (bvalid && b == b_q))

  // A3.4.1: kinds of bursts and sizes; of AXI4-Lite the width of the bus and one beat (B1.1).
  localparam [31:0] LOG2_BYTES = $clog2(BYTES);
  wire [7:0] bytes_log2 = LOG2_BYTES[7:0];
  `RULE(ar_shape, MANAGER_ASSUMED, !arvalid || (arburst == INCR && {5'd0, arsize} <= bytes_log2))
  `RULE(aw_shape, MANAGER_ASSUMED, !awvalid || (awburst == INCR && {5'd0, awsize} <= bytes_log2))
  `RULE(ar_lite, MANAGER_ASSUMED,
        !LITE || !arvalid || (arlen == 8'd0 && {5'd0, arsize} == bytes_log2))
  `RULE(aw_lite, MANAGER_ASSUMED,
        !LITE || !awvalid || (awlen == 8'd0 && {5'd0, awsize} == bytes_log2))
  // A3.4.1: a burst does not cross a boundary of 4 KB. Its first beat may begin within its size.
  wire [15:0] ar_bytes = ({8'd0, arlen} + 16'd1) << arsize;
  wire [15:0] aw_bytes = ({8'd0, awlen} + 16'd1) << awsize;
  wire [15:0] ar_from = {4'd0, araddr[11:0]} & ~((16'd1 << arsize) - 16'd1);
  wire [15:0] aw_from = {4'd0, awaddr[11:0]} & ~((16'd1 << awsize) - 16'd1);
  `RULE(ar_within_4_kb, MANAGER_ASSUMED, !arvalid || ar_from + ar_bytes <= 16'd4096)
  `RULE(aw_within_4_kb, MANAGER_ASSUMED, !awvalid || aw_from + aw_bytes <= 16'd4096)
  // A4.4: bits 3:2 of AxCACHE ask for bit 1. A7.2: no exclusive accesses.
  `RULE(ar_attributes, MANAGER_ASSUMED,
        !arvalid || ((arcache[3:2] == 2'd0 || arcache[1]) && !arlock))
  `RULE(aw_attributes, MANAGER_ASSUMED,
        !awvalid || ((awcache[3:2] == 2'd0 || awcache[1]) && !awlock))
  `RULE(r_response, SUBORDINATE_ASSUMED, !rvalid || rresp != EXOKAY)
  `RULE(b_response, SUBORDINATE_ASSUMED, !bvalid || bresp != EXOKAY)

  // A3.3.1, A5.3: the beats of a read come after it, as many as it asks for, with last on the last
  // one; reads of one id are answered in their order.
  localparam RB = READ_SLOTS_BITS;
  reg [IDS*(RB+1)-1:0] reads_q;  // in flight, of each id
  reg [IDS*RB-1:0]     oldest_q; // the slot of the first of them
  reg [IDS*8-1:0]      beat_q;   // of it
  reg [IDS*READ_SLOTS*8-1:0] len_q;
  wire [RB:0]          reads = reads_q[rid*(RB+1) +: RB+1];
  wire [RB:0]          ar_reads = reads_q[arid*(RB+1) +: RB+1];
  wire [RB-1:0]        oldest = oldest_q[rid*RB +: RB];
  wire [RB-1:0]        newest = oldest_q[arid*RB +: RB] + ar_reads[RB-1:0];
  wire [7:0]           beat = beat_q[rid*8 +: 8];
  wire [7:0]           len = len_q[{rid, oldest}*8 +: 8];
  wire                 same = arid == rid;
  wire                 read_ends = r_taken && rlast;
  always @(posedge clk_i) begin
    if (ar_taken) len_q[{arid, newest}*8 +: 8] <= arlen;
    if (ar_taken && !(read_ends && same)) reads_q[arid*(RB+1) +: RB+1] <= ar_reads + 1'b1;
    if (read_ends && !(ar_taken && same)) reads_q[rid*(RB+1) +: RB+1] <= reads - 1'b1;
    if (read_ends) oldest_q[rid*RB +: RB] <= oldest + 1'b1;
    if (r_taken) beat_q[rid*8 +: 8] <= rlast ? 8'd0 : beat + 8'd1;
    if (!rst_ni) begin
      reads_q <= 0;
      oldest_q <= 0;
      beat_q <= 0;
    end
  end
  `RULE(reads_have_slots, MANAGER_ASSUMED,
        !arvalid || ar_reads != READ_SLOTS || (read_ends && same))
  `RULE(r_was_asked_for, SUBORDINATE_ASSUMED, !rvalid || reads != 0)
  `RULE(r_last, SUBORDINATE_ASSUMED, !rvalid || rlast == (beat == len))

  // A3.3.1, A3.4.1: bursts of data have the lengths of their addresses, in their order; either may
  // come first. What is known of the bursts in flight, by their numbers.
  localparam WB = WRITE_SLOTS_BITS;
  reg [WB:0]              aws_q, ws_q; // numbers of the next address and of the present data
  reg [7:0]               w_beat_q;
  reg [WRITE_SLOTS*8-1:0] aw_len_q;    // of addresses whose data have not ended
  reg [WRITE_SLOTS*8-1:0] w_len_q;     // of data whose addresses have not come
  reg [WRITE_SLOTS*ID_BITS-1:0] aw_id_q;
  wire [WB-1:0]           aw_slot = aws_q[WB-1:0], w_slot = ws_q[WB-1:0];
  wire [WB:0]             ahead = aws_q - ws_q; // of the data
  wire                    aw_leads = !ahead[WB] && ahead != 0;
  wire                    w_leads = ahead[WB];
  wire                    w_known = aw_leads || (ahead == 0 && awvalid);
  wire [7:0]              w_len = aw_leads ? aw_len_q[w_slot*8 +: 8] : awlen;
  wire                    w_ends = w_taken && wlast;
  always @(posedge clk_i) begin
    if (aw_taken) begin
      aw_len_q[aw_slot*8 +: 8] <= awlen;
      aw_id_q[aw_slot*ID_BITS +: ID_BITS] <= awid;
      aws_q <= aws_q + 1'b1;
    end
    if (w_taken) w_beat_q <= wlast ? 8'd0 : w_beat_q + 8'd1;
    if (w_ends) begin
      w_len_q[w_slot*8 +: 8] <= w_beat_q;
      ws_q <= ws_q + 1'b1;
    end
    if (!rst_ni) begin
      aws_q <= 0;
      ws_q <= 0;
      w_beat_q <= 8'd0;
    end
  end
  `RULE(w_last, MANAGER_ASSUMED, !wvalid || !w_known || wlast == (w_beat_q == w_len))
  `RULE(aw_length, MANAGER_ASSUMED,
        !awvalid || (w_leads ? awlen == w_len_q[aw_slot*8 +: 8] : ahead != 0 || awlen >= w_beat_q))

  // A3.3.1: a burst is answered after its address and its last data; A5.3: those of one id in
  // order.
  reg [IDS*(WB+1)-1:0] done_q; // not answered, of each id
  reg [WB+1:0]         open_q; // addresses or data whose burst is not answered
  wire                 both = (aw_taken && w_leads) || (w_ends && aw_leads) ||
                              (aw_taken && w_ends && ahead == 0);
  wire [ID_BITS-1:0]   done_id = w_ends && aw_leads ? aw_id_q[w_slot*ID_BITS +: ID_BITS] : awid;
  wire                 adds = (aw_taken && !w_leads) ||
                              (w_ends && (w_leads || (ahead == 0 && !aw_taken)));
  always @(posedge clk_i) begin
    if (both && !(b_taken && bid == done_id))
      done_q[done_id*(WB+1) +: WB+1] <= done_q[done_id*(WB+1) +: WB+1] + 1'b1;
    if (b_taken && !(both && bid == done_id))
      done_q[bid*(WB+1) +: WB+1] <= done_q[bid*(WB+1) +: WB+1] - 1'b1;
    open_q <= open_q + {{WB + 1{1'b0}}, adds} - {{WB + 1{1'b0}}, b_taken};
    if (!rst_ni) begin
      open_q <= 0;
      done_q <= 0;
    end
  end
  `RULE(writes_have_slots, MANAGER_ASSUMED, open_q <= WRITE_SLOTS)
  `RULE(b_was_asked_for, SUBORDINATE_ASSUMED, !bvalid || done_q[bid*(WB+1) +: WB+1] != 0)

endmodule

`default_nettype wire
