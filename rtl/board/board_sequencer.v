// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs one frame: resets the core for RESET_CLOCKS, and on until ready_i, and clears its counters;
// makes it empty the lines 0 .. last_line_i of every cache, waits PAUSE_CLOCKS until this is done,
// frees the packets 0 .. last_packet_i (start tokens FIRST_PACKET and up); and waits for the token
// of the complete frame. Between frames the core needs no clock. The numbers come from
// hls/units/start.h.
`default_nettype none
`include "dynrt_core.vh"

module board_sequencer #(
  parameter RESET_CLOCKS = `DYNRT_CORE_RESET_CLOCKS,
  parameter PAUSE_CLOCKS = `DYNRT_CORE_START_PAUSE,
  parameter FIRST_PACKET = `DYNRT_CORE_FIRST_PACKET
) (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire        start_i,  // ignored while busy
  input  wire        reset_i,  // give up the current frame
  input  wire        ready_i,  // nothing is on its way to the core that it asked for before its reset
  input  wire [8:0]  last_line_i,
  input  wire [8:0]  last_packet_i,
  output wire        busy_o,
  output wire        done_o,   // the clock in which the frame becomes complete
  output reg  [63:0] cycles_o, // clocks since the core left its reset, until done
  // core
  output wire        core_rst_no,
  output wire        counter_clear_o,
  output wire        start_valid_o,
  input  wire        start_ready_i,
  output wire [9:0]  start_data_o,
  input  wire        done_valid_i,
  output wire        done_ready_o
);

  localparam [2:0] IDLE = 3'd0, RESET = 3'd1, LINES = 3'd2, PAUSE = 3'd3, PACKETS = 3'd4,
                   RUN = 3'd5;
  localparam [8:0] LAST_RESET = RESET_CLOCKS[8:0] - 9'd1;
  localparam [8:0] LAST_PAUSE = PAUSE_CLOCKS[8:0] - 9'd1;

  reg [2:0] state_q;
  reg [8:0] count_q;  // clocks or tokens of this state
  reg       render_q; // a frame follows the reset

  assign busy_o = state_q != IDLE;
  assign core_rst_no = rst_ni && state_q != RESET;
  assign counter_clear_o = state_q == RESET;
  assign start_valid_o = state_q == LINES || state_q == PACKETS;
  assign start_data_o = {1'b0, count_q} | (state_q == PACKETS ? FIRST_PACKET[9:0] : 10'd0);
  assign done_ready_o = state_q == PACKETS || state_q == RUN;
  assign done_o = done_ready_o && done_valid_i && !reset_i;

  // Whether the state goes on with its count, which was its last, and what follows.
  reg       step, last;
  reg [2:0] next;
  always @* begin
    step = 1'b1;
    last = 1'b0;
    next = RUN;
    case (state_q)
      RESET: begin
        last = count_q == LAST_RESET;
        step = !last || ready_i;
        next = render_q ? LINES : IDLE;
      end
      LINES: begin
        step = start_ready_i;
        last = count_q == last_line_i;
        next = PAUSE;
      end
      PAUSE: begin
        last = count_q == LAST_PAUSE;
        next = PACKETS;
      end
      PACKETS: begin
        step = start_ready_i;
        last = count_q == last_packet_i;
      end
      default: step = 1'b0; // IDLE, RUN
    endcase
  end

  always @(posedge clk_i) begin
    if (step) count_q <= last ? 9'd0 : count_q + 9'd1;
    if (step && last) state_q <= next;
    if (done_o) state_q <= IDLE;
    if (state_q == RESET) cycles_o <= 64'd0;
    else if (state_q != IDLE) cycles_o <= cycles_o + 64'd1;
    if (state_q == IDLE && start_i) begin
      state_q <= RESET;
      count_q <= 9'd0;
      render_q <= 1'b1;
    end
    if (reset_i || !rst_ni) begin
      state_q <= RESET;
      count_q <= 9'd0;
      render_q <= 1'b0;
    end
    if (!rst_ni) cycles_o <= 64'd0;
  end

`ifdef HLS_ASSERT
  // A reset clears a row of the register files a clock; they have a row for each packet.
  always @(posedge clk_i) begin
    if (rst_ni && state_q == PACKETS && last_packet_i > LAST_RESET) begin
      $display("%m: a reset of %0d clocks clears the rows of fewer packets than %0d", RESET_CLOCKS,
               last_packet_i + 9'd1);
      $stop;
    end
  end
`endif

endmodule

`default_nettype wire
