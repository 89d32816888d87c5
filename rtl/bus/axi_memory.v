// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core's memory port as an AXI4 manager (IHI 0022). Signals of the bus have the names of the
// specification; those that it lets out (REGION, USER) are left out.
//
// A read of the port is one burst, and so is a burst of writes. Neither crosses a boundary of 4 KB:
// the core's bursts lie within 64 aligned bytes (hls/units/memory_port.h), and base_i is a multiple
// of 32 MB.
//
// Where every read has one beat, ARID is the core's id, so that the memory may answer in any order.
// Beats of longer answers might come interleaved, which the core cannot sort. So all reads then have
// one id, are answered in order, and the core's ids wait in a FIFO. IN_ORDER does the same where
// reads are short, for a memory that has few ids or answers in order anyway.
//
// In place of an answer with an error the core gets data that end its path through the scene
// (memory_filler.v), so that the frame ends; the first error's address goes to the registers.
//
// While stop_i is high, the core is in reset: its answers are dropped, and a burst of writes that it
// has begun is completed with beats that write nothing. stop_i stays high until idle_o is.
//
// Parameters:
//   ID_BITS, BEAT_BYTES, READ_BEATS  of the core's port, as its dynrt_core.vh has them
//   ADDRESS_BITS  of the bus, 26 to 64
//   READS         reads in flight where all have one id, at least 1
//   WRITES        bursts of writes in flight, at least 1
//   CACHE, PROT   AxCACHE and AxPROT of all accesses
//   READ_BITS     of an address that is read, 24 or, where more than the core reads, 25
//   IN_ORDER      one id for all reads; 1 where READ_BEATS is more than 1
//   AXI_ID_BITS   follows from the others, leave it as it is
`default_nettype none

module axi_memory #(
  parameter ID_BITS = 10,
  parameter BEAT_BYTES = 16,
  parameter READ_BEATS = 1,
  parameter ADDRESS_BITS = 32,
  parameter READS = 64,
  parameter WRITES = 16,
  parameter [3:0] CACHE = 4'b0010,
  parameter [2:0] PROT = 3'b000,
  parameter READ_BITS = 24,
  parameter IN_ORDER = READ_BEATS > 1 ? 1 : 0,
  parameter AXI_ID_BITS = IN_ORDER != 0 ? 1 : ID_BITS
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire [ADDRESS_BITS-1:0] base_i, // changes only while idle_o is high
  input  wire                    stop_i,
  output wire                    idle_o, // nothing is in flight
  // an answer with an error, a pulse
  output reg                     error_o,
  output reg                     error_write_o,
  output reg  [1:0]              error_response_o,
  output wire [24:0]             error_address_o, // that its burst begins at, in the core's memory
  // the core's port
  input  wire                    read_valid_i,
  output wire                    read_ready_o,
  input  wire [ID_BITS-1:0]      read_id_i,
  input  wire [READ_BITS-1:0]    read_address_i,
  input  wire [3:0]              read_last_i,
  output wire                    beat_valid_o,
  input  wire                    beat_ready_i,
  output wire [ID_BITS-1:0]      beat_id_o,
  output wire [8*BEAT_BYTES-1:0] beat_data_o,
  output wire                    beat_last_o,
  input  wire                    write_valid_i,
  output wire                    write_ready_o,
  input  wire [24:0]             write_address_i,
  input  wire [8*BEAT_BYTES-1:0] write_data_i,
  input  wire [BEAT_BYTES/2-1:0] write_mask_i,
  input  wire [2:0]              write_left_i,
  // AXI4
  output wire                    m_axi_arvalid,
  input  wire                    m_axi_arready,
  output wire [AXI_ID_BITS-1:0]  m_axi_arid,
  output wire [ADDRESS_BITS-1:0] m_axi_araddr,
  output wire [7:0]              m_axi_arlen,
  output wire [2:0]              m_axi_arsize,
  output wire [1:0]              m_axi_arburst,
  output wire                    m_axi_arlock,
  output wire [3:0]              m_axi_arcache,
  output wire [2:0]              m_axi_arprot,
  output wire [3:0]              m_axi_arqos,
  input  wire                    m_axi_rvalid,
  output wire                    m_axi_rready,
  input  wire [AXI_ID_BITS-1:0]  m_axi_rid,
  input  wire [8*BEAT_BYTES-1:0] m_axi_rdata,
  input  wire [1:0]              m_axi_rresp,
  input  wire                    m_axi_rlast,
  output wire                    m_axi_awvalid,
  input  wire                    m_axi_awready,
  output wire [AXI_ID_BITS-1:0]  m_axi_awid,
  output wire [ADDRESS_BITS-1:0] m_axi_awaddr,
  output wire [7:0]              m_axi_awlen,
  output wire [2:0]              m_axi_awsize,
  output wire [1:0]              m_axi_awburst,
  output wire                    m_axi_awlock,
  output wire [3:0]              m_axi_awcache,
  output wire [2:0]              m_axi_awprot,
  output wire [3:0]              m_axi_awqos,
  output wire                    m_axi_wvalid,
  input  wire                    m_axi_wready,
  output wire [8*BEAT_BYTES-1:0] m_axi_wdata,
  output wire [BEAT_BYTES-1:0]   m_axi_wstrb,
  output wire                    m_axi_wlast,
  input  wire                    m_axi_bvalid,
  output wire                    m_axi_bready,
  input  wire [AXI_ID_BITS-1:0]  m_axi_bid,
  input  wire [1:0]              m_axi_bresp
);

  localparam DATA = 8 * BEAT_BYTES, HALVES = BEAT_BYTES / 2;
  localparam [31:0] LOG2_BYTES = $clog2(BEAT_BYTES);
  localparam [2:0] SIZE = LOG2_BYTES[2:0];
  localparam [1:0] INCR = 2'b01;

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (BEAT_BYTES != 2 && BEAT_BYTES != 4 && BEAT_BYTES != 8 && BEAT_BYTES != 16 &&
        BEAT_BYTES != 32) begin : bad_beat
      axi_memory_BEAT_BYTES_must_be_2_4_8_16_or_32 stop ();
    end
    if (ADDRESS_BITS < 26 || ADDRESS_BITS > 64) begin : bad_address
      axi_memory_ADDRESS_BITS_must_be_26_to_64 stop ();
    end
    if (READ_BITS != 24 && READ_BITS != 25) begin : bad_read
      axi_memory_READ_BITS_must_be_24_or_25 stop ();
    end
    if (READ_BEATS > 1 && IN_ORDER == 0) begin : bad_order
      axi_memory_IN_ORDER_must_be_1_where_reads_have_several_beats stop ();
    end
    if (AXI_ID_BITS != (IN_ORDER != 0 ? 1 : ID_BITS)) begin : bad_id
      axi_memory_AXI_ID_BITS_must_follow_from_the_others stop ();
    end
  endgenerate

  wire reads_idle, writes_idle;
  assign idle_o = reads_idle && writes_idle;

  // Reads. A read that has been offered to the bus has to stay, whatever becomes of the core.
  wire               ar_waits;
  wire [ID_BITS-1:0] ar_id;
  wire [READ_BITS-1:0] ar_address;
  wire [3:0]         ar_last;
  wire               ar_room; // for what is kept of it
  wire               ar_taken = m_axi_arvalid && m_axi_arready;
  wire               r_taken = m_axi_rvalid && m_axi_rready;
  hls_buffer #(.WIDTH(ID_BITS + READ_BITS + 4)) ar_buffer (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(read_valid_i && !stop_i), .ready_o(read_ready_o),
    .data_i({read_id_i, read_address_i, read_last_i}), .valid_o(ar_waits),
    .ready_i(m_axi_arready && ar_room), .data_o({ar_id, ar_address, ar_last})
  );
  assign m_axi_arvalid = ar_waits && ar_room;
  assign m_axi_araddr = {base_i[ADDRESS_BITS-1:25], {25 - READ_BITS{1'b0}}, ar_address};
  assign m_axi_arlen = {4'd0, ar_last};
  assign m_axi_arsize = SIZE;
  assign m_axi_arburst = INCR;
  assign m_axi_arlock = 1'b0;
  assign m_axi_arcache = CACHE;
  assign m_axi_arprot = PROT;
  assign m_axi_arqos = 4'd0;

  // Their answers; and of one with an error the address, a clock later.
  assign m_axi_rready = beat_ready_i || stop_i;
  assign beat_valid_o = m_axi_rvalid && !stop_i;
  assign beat_last_o = m_axi_rlast;
  wire [READ_BITS-1:0] r_address_next;
  generate
    if (IN_ORDER != 0) begin : in_order
      wire in_flight;
      wire [READ_BITS-1:0] address;
      reg  [READ_BITS-1:0] address_q;
      hls_fifo #(.WIDTH(ID_BITS + READ_BITS), .DEPTH(READS)) in_flight_fifo (
        .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(ar_taken), .ready_o(ar_room),
        .data_i({ar_id, ar_address}), .valid_o(in_flight), .ready_i(r_taken && m_axi_rlast),
        .data_o({beat_id_o, address})
      );
      always @(posedge clk_i) address_q <= address;
      assign m_axi_arid = 1'b0;
      assign reads_idle = !ar_waits && !in_flight;
      assign r_address_next = address_q;
      wire unused = &{1'b0, m_axi_rid};
    end else begin : in_any_order
      localparam [ID_BITS:0] ONE = 1;
      reg [ID_BITS:0] in_flight_q;
      hls_ram_1r1w #(.WIDTH(READ_BITS), .ROWS(1 << ID_BITS)) address_ram (
        .clk_i(clk_i), .rst_ni(rst_ni), .write_en_i(ar_taken), .write_addr_i(ar_id),
        .write_data_i(ar_address), .read_en_i(r_taken), .read_addr_i(m_axi_rid),
        .read_data_o(r_address_next)
      );
      always @(posedge clk_i) begin
        if (ar_taken != r_taken) in_flight_q <= ar_taken ? in_flight_q + ONE : in_flight_q - ONE;
        if (!rst_ni) in_flight_q <= {ID_BITS + 1{1'b0}};
      end
      assign ar_room = 1'b1;
      assign m_axi_arid = ar_id;
      assign beat_id_o = m_axi_rid;
      assign reads_idle = !ar_waits && in_flight_q == {ID_BITS + 1{1'b0}};
    end
  endgenerate
  memory_filler #(.ID_BITS(ID_BITS), .BEAT_BYTES(BEAT_BYTES)) filler (
    .clk_i(clk_i), .rst_ni(rst_ni), .taken_i(r_taken), .id_i(beat_id_o), .last_i(m_axi_rlast),
    .error_i(m_axi_rresp[1]), .data_i(m_axi_rdata), .data_o(beat_data_o)
  );

  // Writes. Data and, of the first beat of a burst, its address take their own ways to the bus.
  reg        open_q; // a burst has begun and not ended
  reg  [2:0] left_q; // its beats that follow
  wire       first = !open_q;
  wire       w_room, aw_room, aw_kept_room;
  wire       ends = stop_i && open_q; // for the core
  wire       offered = (write_valid_i && !stop_i) || ends;
  wire [2:0] left = ends ? left_q - 3'd1 : write_left_i;
  wire       room = w_room && (open_q || (aw_room && aw_kept_room));
  wire       taken = offered && room;
  assign write_ready_o = room;
  always @(posedge clk_i) begin
    if (taken) begin
      open_q <= left != 3'd0;
      left_q <= left;
    end
    if (!rst_ni) open_q <= 1'b0;
  end

  wire              w_last;
  wire [HALVES-1:0] w_mask;
  hls_buffer #(.WIDTH(1 + HALVES + DATA)) w_buffer (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(offered && room), .ready_o(w_room),
    .data_i({left == 3'd0, ends ? {HALVES{1'b0}} : write_mask_i, write_data_i}),
    .valid_o(m_axi_wvalid), .ready_i(m_axi_wready), .data_o({w_last, w_mask, m_axi_wdata})
  );
  assign m_axi_wlast = w_last;
  genvar h;
  generate
    for (h = 0; h < HALVES; h = h + 1) begin : strobe
      assign m_axi_wstrb[2*h +: 2] = {2{w_mask[h]}};
    end
  endgenerate

  wire [24:0] aw_address;
  wire [2:0]  aw_left;
  hls_buffer #(.WIDTH(28)) aw_buffer (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(taken && first), .ready_o(aw_room),
    .data_i({write_address_i, write_left_i}), .valid_o(m_axi_awvalid), .ready_i(m_axi_awready),
    .data_o({aw_address, aw_left})
  );
  assign m_axi_awid = {AXI_ID_BITS{1'b0}};
  assign m_axi_awaddr = {base_i[ADDRESS_BITS-1:25], aw_address};
  assign m_axi_awlen = {5'd0, aw_left};
  assign m_axi_awsize = SIZE;
  assign m_axi_awburst = INCR;
  assign m_axi_awlock = 1'b0;
  assign m_axi_awcache = CACHE;
  assign m_axi_awprot = PROT;
  assign m_axi_awqos = 4'd0;

  // Bursts of one id are answered in their order.
  wire        b_waits;
  wire [24:0] b_address;
  hls_fifo #(.WIDTH(25), .DEPTH(WRITES)) write_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(taken && first), .ready_o(aw_kept_room),
    .data_i(write_address_i), .valid_o(b_waits), .ready_i(m_axi_bvalid), .data_o(b_address)
  );
  assign m_axi_bready = 1'b1;
  assign writes_idle = !b_waits && !open_q;

  // Errors: of two in one clock, that of the read.
  wire r_error = r_taken && m_axi_rresp[1];
  reg  [24:0] b_address_q;
  always @(posedge clk_i) begin
    error_o <= r_error || (m_axi_bvalid && m_axi_bresp[1]);
    error_write_o <= !r_error;
    error_response_o <= r_error ? m_axi_rresp : m_axi_bresp;
    b_address_q <= b_address;
    if (!rst_ni) error_o <= 1'b0;
  end
  assign error_address_o = error_write_o ? b_address_q : {{25 - READ_BITS{1'b0}}, r_address_next};

  // The lowest bits of the base are zero, and all writes have one id.
  wire unused = &{1'b0, base_i[24:0], m_axi_bid};

endmodule

`default_nettype wire
