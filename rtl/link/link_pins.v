// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The pins of the serial line. The unit uart_receive gets a sample of the line in each clock; a bit
// of the unit uart_send stays on the line for divisor_i clocks. An idle line is high.
`default_nettype none

module link_pins (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire [11:0] divisor_i,
  // pins
  input  wire        rx_i,
  output wire        tx_o,
  // units
  output wire        sample_valid_o,
  input  wire        sample_ready_i,
  output wire        sample_data_o,
  input  wire        bit_valid_i,
  output wire        bit_ready_o,
  input  wire        bit_data_i
);

  hls_synchroniser #(.RESET(1)) rx_synchroniser (
    .clk_i(clk_i), .rst_ni(rst_ni), .data_i(rx_i), .data_o(sample_data_o)
  );
  assign sample_valid_o = rst_ni;

  reg        tx_q;
  reg [11:0] left_q; // clocks that the bit stays, less one
  reg        free_q; // the bit's time is over
  assign tx_o = tx_q;
  assign bit_ready_o = free_q;

  always @(posedge clk_i) begin
    if (free_q && bit_valid_i) begin
      tx_q <= bit_data_i;
      left_q <= divisor_i - 12'd2;
      free_q <= 1'b0;
    end else if (!free_q) begin
      left_q <= left_q - 12'd1;
      free_q <= left_q == 12'd0;
    end
    if (!rst_ni) begin
      tx_q <= 1'b1;
      free_q <= 1'b1;
    end
  end

`ifdef HLS_ASSERT
  // A sample that nobody takes is a byte that gets lost and is sent again.
  reg started_q = 1'b0;
  always @(posedge clk_i) begin
    started_q <= rst_ni && (started_q || sample_ready_i);
    if (rst_ni && started_q && !sample_ready_i) begin
      $display("%m: a sample of the line was not taken");
      $stop;
    end
  end
`else
  wire unused = &{1'b0, sample_ready_i};
`endif

endmodule

`default_nettype wire
