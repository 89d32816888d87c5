// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs one frame: resets the core for RESET_CLOCKS, clears its counters, feeds the start tokens
// 0 .. last_token_i (each frees a packet and empties a line of every cache), and waits for the
// token that says the frame is complete. Between frames the core needs no clock.
module board_sequencer #(
  parameter RESET_CLOCKS = 64  // the core's register files have up to 64 rows to clear
) (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire        start_i,  // ignored while busy
  input  wire        reset_i,  // give up whatever is under way
  input  wire [9:0]  last_token_i,
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

  localparam [1:0] IDLE = 2'd0, RESET = 2'd1, FEED = 2'd2, RUN = 2'd3;
  localparam [9:0] LAST_RESET = RESET_CLOCKS[9:0] - 10'd1;

  reg [1:0] state_q;
  reg [9:0] count_q;  // clocks of reset, then tokens
  reg       render_q; // a frame follows the reset

  assign busy_o = state_q != IDLE;
  assign core_rst_no = rst_ni && state_q != RESET;
  assign counter_clear_o = state_q == RESET;
  assign start_valid_o = state_q == FEED;
  assign start_data_o = count_q;
  assign done_ready_o = state_q == FEED || state_q == RUN;
  assign done_o = done_ready_o && done_valid_i && !reset_i;

  always @(posedge clk_i) begin
    case (state_q)
      IDLE: begin
        count_q <= 10'd0;
        if (start_i) begin
          state_q <= RESET;
          render_q <= 1'b1;
        end
      end
      RESET: begin
        cycles_o <= 64'd0;
        count_q <= count_q + 10'd1;
        if (count_q == LAST_RESET) begin
          count_q <= 10'd0;
          state_q <= render_q ? FEED : IDLE;
        end
      end
      default: begin // FEED, RUN
        cycles_o <= cycles_o + 64'd1;
        if (start_valid_o && start_ready_i) begin
          count_q <= count_q + 10'd1;
          if (count_q == last_token_i) state_q <= RUN;
        end
        if (done_o) state_q <= IDLE;
      end
    endcase
    if (reset_i || !rst_ni) begin
      state_q <= RESET;
      render_q <= 1'b0;
      count_q <= 10'd0;
    end
    if (!rst_ni) cycles_o <= 64'd0;
  end

endmodule
