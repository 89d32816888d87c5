// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shares the six SRAM banks between the core, while a frame is being rendered, and the host's
// window at all other times. The core reads banks 0 to 2 and writes banks 3 to 5. Every pin has a
// register: an access is at the pins one clock after it was asked for, and the data read is handed
// on one clock after it came back, so a bank itself may take SRAM_LATENCY - 2 clocks (synchronous
// SRAM: 1).
module board_sram (
  input  wire             clk_i,
  input  wire             rst_ni,
  input  wire             core_owns_i,
  // core
  input  wire [5:0]       core_en_i,
  input  wire [6*20-1:0]  core_addr_i,
  input  wire [3*32-1:0]  core_wdata_i, // banks 3 to 5
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
    if (!rst_ni) begin
      sram_en_o <= 6'd0;
      sram_we_o <= 6'd0;
    end
  end

endmodule
