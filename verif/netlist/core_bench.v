// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Renders one frame on dynrt_core, or on a netlist of that name, and compares banks 3 to 5 word by
// word with those of the model. Runs in any simulator of Verilog-2005. The folder +folder=F has,
// from record_frame: frame.hex, the frame's registers; scene0.hex to scene2.hex; expected3.hex to
// expected5.hex, each as long as the macros say.
`include "dynrt_core.vh"
`include "sizes.vh"

module core_bench;
  localparam FRAME_WORDS = `DYNRT_CORE_FRAME_BITS / 32;
  localparam BANK_WORDS = 1 << 20;

  reg clk = 0;
  always #5 clk = !clk;

  reg [8*512-1:0] folder;
  reg [31:0] frame_words [0:FRAME_WORDS-1];
  reg [32*FRAME_WORDS-1:0] frame;
  reg [31:0] scene0 [0:BANK_WORDS-1];
  reg [31:0] scene1 [0:BANK_WORDS-1];
  reg [31:0] scene2 [0:BANK_WORDS-1];
  reg [31:0] expected3 [0:`PIXEL_WORDS-1];
  reg [31:0] expected4 [0:`HIT_WORDS-1];
  reg [31:0] expected5 [0:`HIT_WORDS-1];
  reg [31:0] written3 [0:`PIXEL_WORDS-1];
  reg [31:0] written4 [0:`HIT_WORDS-1];
  reg [31:0] written5 [0:`HIT_WORDS-1];

  reg         rst_n = 0;
  reg         start_valid = 0;
  wire        start_ready;
  reg  [9:0]  start_data = 0;
  wire        done_valid;
  wire [5:0]  en;
  wire [19:0] addr0, addr1, addr2, addr3, addr4, addr5;
  reg  [31:0] data0, data1, data2;
  wire [31:0] data3, data4, data5;

  dynrt_core core (
    .clk_i(clk), .rst_ni(rst_n),
    .start_valid_i(start_valid), .start_ready_o(start_ready), .start_data_i(start_data),
    .done_valid_o(done_valid), .done_ready_i(1'b1), .done_data_o(),
    .frame_i(frame),
    .bank0_en_o(en[0]), .bank0_addr_o(addr0), .bank0_data_i(data0),
    .bank1_en_o(en[1]), .bank1_addr_o(addr1), .bank1_data_i(data1),
    .bank2_en_o(en[2]), .bank2_addr_o(addr2), .bank2_data_i(data2),
    .bank3_en_o(en[3]), .bank3_addr_o(addr3), .bank3_data_o(data3),
    .bank4_en_o(en[4]), .bank4_addr_o(addr4), .bank4_data_o(data4),
    .bank5_en_o(en[5]), .bank5_addr_o(addr5), .bank5_data_o(data5),
    .counter_addr_i(8'd0), .counter_data_o(), .counter_clear_i(!rst_n)
  );

  // As the board's SRAM: an address takes SRAM_LATENCY = 3 clocks to its data.
  reg [19:0] pin0, pin1, pin2;
  reg [31:0] out0, out1, out2;
  always @(posedge clk) begin
    pin0 <= addr0;
    pin1 <= addr1;
    pin2 <= addr2;
    out0 <= scene0[pin0];
    out1 <= scene1[pin1];
    out2 <= scene2[pin2];
    data0 <= out0;
    data1 <= out1;
    data2 <= out2;
  end

  integer outside = 0; // words written where none is expected
  always @(posedge clk) if (rst_n) begin
    if (en[3]) begin
      if (addr3 < `PIXEL_WORDS) written3[addr3] <= data3; else outside <= outside + 1;
    end
    if (en[4]) begin
      if (addr4 < `HIT_WORDS) written4[addr4] <= data4; else outside <= outside + 1;
    end
    if (en[5]) begin
      if (addr5 < `HIT_WORDS) written5[addr5] <= data5; else outside <= outside + 1;
    end
  end

  // Gives one start token, once it is taken.
  task give(input [9:0] token);
    begin
      start_data = token;
      start_valid = 1;
      @(posedge clk);
      while (!start_ready) @(posedge clk);
      #1 start_valid = 0;
    end
  endtask

  integer i, clocks, different, compared;
  always @(posedge clk) clocks <= rst_n ? clocks + 1 : 0;

  task check(input [31:0] bank, input [31:0] word, input [31:0] is, input [31:0] expected);
    begin
      compared = compared + 1;
      if (is !== expected) begin
        if (different < 10) begin
          $display("bank %0d, word %0d: is %h, expected %h", bank, word, is, expected);
        end
        different = different + 1;
      end
    end
  endtask

  initial begin
    if (!$value$plusargs("folder=%s", folder)) begin
      $display("no folder; say +folder=F");
      $finish;
    end
    $readmemh({folder, "/frame.hex"}, frame_words);
    $readmemh({folder, "/scene0.hex"}, scene0);
    $readmemh({folder, "/scene1.hex"}, scene1);
    $readmemh({folder, "/scene2.hex"}, scene2);
    $readmemh({folder, "/expected3.hex"}, expected3);
    $readmemh({folder, "/expected4.hex"}, expected4);
    $readmemh({folder, "/expected5.hex"}, expected5);
    for (i = 0; i < FRAME_WORDS; i = i + 1) frame[32*i +: 32] = frame_words[i];
    for (i = 0; i < `DYNRT_CORE_RESET_CLOCKS; i = i + 1) @(posedge clk);
    #1 rst_n = 1;
    for (i = 0; i <= frame[`DYNRT_CORE_FRAME_LINE_MASK +: 9]; i = i + 1) give(i);
    for (i = 0; i < `DYNRT_CORE_START_PAUSE; i = i + 1) @(posedge clk);
    for (i = 0; i < frame[`DYNRT_CORE_FRAME_PACKETS +: 9]; i = i + 1) give(`DYNRT_CORE_FIRST_PACKET + i);
    while (!done_valid && clocks < `MAX_CLOCKS) @(posedge clk);
    if (!done_valid) begin
      $display("not done after %0d clocks", clocks);
    end else begin
      @(posedge clk);
      different = outside;
      compared = 0;
      for (i = 0; i < `PIXEL_WORDS; i = i + 1) check(3, i, written3[i], expected3[i]);
      for (i = 0; i < `HIT_WORDS; i = i + 1) check(4, i, written4[i], expected4[i]);
      for (i = 0; i < `HIT_WORDS; i = i + 1) check(5, i, written5[i], expected5[i]);
      $display("%0d words compared, %0d different, %0d clocks", compared, different, clocks);
      if (different == 0 && compared == `PIXEL_WORDS + 2 * `HIT_WORDS) $display("the same");
    end
    $finish;
  end
endmodule
