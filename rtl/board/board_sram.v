// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shares the six SRAM banks between the core, while a frame is being rendered, and the host's
// window at all other times. The core reads banks 0 to 2 and writes banks 3 to 5. In bank 3, the
// framebuffer's, the scan-out has priority: it must get its pixel in time, at most every other
// clock. A pixel that the core writes in the same clock is held for the next one; the core writes
// one in two clocks at most (hls/units/shading.h), so one register is enough and the core never
// waits. The host waits: it must not use the window in a clock of the scan-out. Every pin has a
// register: an access is at the pins one clock after it was asked for, and the data read is handed
// on one clock after it came back, so a bank itself may take SRAM_LATENCY - 2 clocks (synchronous
// SRAM: 1).
`default_nettype none

module board_sram (
  input  wire             clk_i,
  input  wire             rst_ni,
  input  wire             core_owns_i,
  // core
  input  wire [5:0]       core_en_i,
  input  wire [6*20-1:0]  core_addr_i,
  input  wire [3*32-1:0]  core_wdata_i, // banks 3 to 5
  // scan-out, reads bank 3
  input  wire             scan_en_i,
  input  wire [19:0]      scan_addr_i,
  // host
  input  wire [5:0]       window_en_i,
  input  wire             window_we_i,
  input  wire [19:0]      window_addr_i,
  input  wire [31:0]      window_wdata_i,
  output reg  [6*32-1:0]  rdata_o,
  // pins
  output reg  [5:0]       sram_en_o,
  output reg  [5:0]       sram_we_o,
  output reg  [6*20-1:0]  sram_addr_o,
  output reg  [6*32-1:0]  sram_wdata_o,
  input  wire [6*32-1:0]  sram_rdata_i
);

  // The core's write to bank 3, of this clock or held.
  reg         held_q;
  reg  [19:0] held_addr_q;
  reg  [31:0] held_data_q;
  wire        frame_now = core_owns_i && core_en_i[3];
  wire        frame_en = frame_now || held_q;
  wire [19:0] frame_addr = held_q ? held_addr_q : core_addr_i[79:60];
  wire [31:0] frame_data = held_q ? held_data_q : core_wdata_i[31:0];

  always @(posedge clk_i) begin
    rdata_o <= sram_rdata_i;
    if (core_owns_i) begin
      sram_en_o <= core_en_i;
      sram_we_o <= {core_en_i[5:3], 3'b000};
      sram_addr_o <= core_addr_i;
      sram_wdata_o <= {core_wdata_i, 96'd0};
    end else begin
      sram_en_o <= window_en_i;
      sram_we_o <= window_en_i & {6{window_we_i}};
      sram_addr_o <= {6{window_addr_i}};
      sram_wdata_o <= {6{window_wdata_i}};
    end
    if (scan_en_i || frame_en) begin
      sram_en_o[3] <= 1'b1;
      sram_we_o[3] <= !scan_en_i;
      sram_addr_o[79:60] <= scan_en_i ? scan_addr_i : frame_addr;
      sram_wdata_o[127:96] <= frame_data;
    end
    held_q <= scan_en_i && frame_en;
    held_addr_q <= frame_addr;
    held_data_q <= frame_data;
    if (!rst_ni) begin
      sram_en_o <= 6'd0;
      sram_we_o <= 6'd0;
      held_q <= 1'b0;
    end
  end

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (rst_ni && held_q && frame_now) begin
      $display("%m: a pixel was written while another was held");
      $stop;
    end
    if (rst_ni && scan_en_i && |window_en_i) begin
      $display("%m: the window was used in a clock of the scan-out");
      $stop;
    end
  end
`endif

endmodule

`default_nettype wire
