// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Models of the ECP5's block RAM and multiplier, as far as synth_ecp5 and scripts/place use them:
// Yosys ships models of every other cell that a netlist of ours has (ecp5/cells_sim.v), and these two
// as black boxes.
// Lattice TN-02204 "ECP5 Memory Usage Guide" and TN-02205 "sysDSP Usage Guide". A use beyond that
// ends the simulation.

// 18 by 18 bits, without registers or with one behind the product.
module MULT18X18D (
  input A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0,
  input B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0,
  input C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0,
  input SIGNEDA, SIGNEDB, SOURCEA, SOURCEB,
  input CLK0, CE0, RST0,
  output P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18,
    P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
);
  parameter REG_INPUTA_CLK = "NONE";
  parameter REG_INPUTB_CLK = "NONE";
  parameter REG_PIPELINE_CLK = "NONE";
  parameter REG_OUTPUT_CLK = "NONE";
  parameter REG_OUTPUT_CE = "CE0";
  parameter REG_OUTPUT_RST = "RST0";
  wire [17:0] a =
    {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b =
    {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};
  wire signed [18:0] a_wide = {SIGNEDA & A17, a};
  wire signed [18:0] b_wide = {SIGNEDB & B17, b};
  wire signed [37:0] product = a_wide * b_wide;
  reg [35:0] product_q;
  always @(posedge CLK0) if (CE0) product_q <= RST0 ? 36'd0 : product[35:0];
  assign
    {P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18,
      P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0}
    = REG_OUTPUT_CLK == "CLK0" ? product_q : product[35:0];
  initial begin
    if (REG_INPUTA_CLK != "NONE" || REG_INPUTB_CLK != "NONE" || REG_PIPELINE_CLK != "NONE" ||
        (REG_OUTPUT_CLK != "NONE" && REG_OUTPUT_CLK != "CLK0") || REG_OUTPUT_CE != "CE0" ||
        REG_OUTPUT_RST != "RST0") begin
      $display("%m: a multiplier with these registers is not modelled");
      $finish;
    end
  end
endmodule

// 18 Kbit, two ports of 9 or 18 bits each, or one that writes and one that reads 36 bits, on one
// clock, each with or without a register behind its data. In pairs of 18-bit words the lower is on
// the A pins.
//
// Values that Yosys does not promise are unknown, so that a picture that needs them is wrong: a
// word before it is written, and one that a port reads while the other writes it.
module ecp5_block_ram (
  input DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5,
    DIA4, DIA3, DIA2, DIA1, DIA0,
  input ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0,
  input CEA, OCEA, CLKA, WEA, RSTA, CSA2, CSA1, CSA0,
  output DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5,
    DOA4, DOA3, DOA2, DOA1, DOA0,
  input DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5,
    DIB4, DIB3, DIB2, DIB1, DIB0,
  input ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0,
  input CEB, OCEB, CLKB, WEB, RSTB, CSB2, CSB1, CSB0,
  output DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5,
    DOB4, DOB3, DOB2, DOB1, DOB0
);
  parameter DATA_WIDTH_A = 18;
  parameter DATA_WIDTH_B = 18;
  parameter REGMODE_A = "NOREG";
  parameter REGMODE_B = "NOREG";
  parameter RESETMODE = "SYNC";
  parameter ASYNC_RESET_RELEASE = "SYNC";
  parameter CSDECODE_A = "0b000";
  parameter CSDECODE_B = "0b000";
  parameter WRITEMODE_A = "NORMAL";
  parameter WRITEMODE_B = "NORMAL";
  parameter CLKAMUX = "CLKA";
  parameter CLKBMUX = "CLKB";
  parameter GSR = "ENABLED";
  localparam WIDTH = DATA_WIDTH_A; // of both ports

  reg [17:0] words [0:1023];
  wire [13:0] address_a =
    {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0};
  wire [13:0] address_b =
    {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0};
  wire [17:0] in_a =
    {DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4,
      DIA3, DIA2, DIA1, DIA0};
  wire [17:0] in_b =
    {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4,
      DIB3, DIB2, DIB1, DIB0};
  reg [17:0] out_a, out_b;
  reg [17:0] low_b; // of a port B of 36 bits
  wire [17:0] data_a = WIDTH == 36 ? low_b : out_a;
  reg [17:0] data_a_q, out_b_q;
  always @(posedge CLKA) if (OCEA) data_a_q <= data_a;
  always @(posedge CLKB) if (OCEB) out_b_q <= out_b;
  assign
    {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4,
      DOA3, DOA2, DOA1, DOA0} = REGMODE_A == "OUTREG" ? data_a_q : data_a;
  assign
    {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4,
      DOB3, DOB2, DOB1, DOB0} = REGMODE_B == "OUTREG" ? out_b_q : out_b;

  wire writes_a = CEA && WEA &&
    (WIDTH == 9 || (WIDTH == 18 ? |address_a[1:0] : |address_a[3:0]));
  wire writes_b = CEB && WEB && WIDTH != 36 && (WIDTH == 9 || |address_b[1:0]);
  wire reads_a = CEA && WIDTH != 36 && (!WEA || WRITEMODE_A == "READBEFOREWRITE");
  wire reads_b = CEB && (WIDTH == 36 || !WEB || WRITEMODE_B == "READBEFOREWRITE");
  wire [10:0] differ = address_a[13:3] ^ address_b[13:3];
  wire same = WIDTH == 9 ? differ == 0 : WIDTH == 18 ? differ[10:1] == 0 : differ[10:2] == 0;

  // Writes the bytes of `data` that `enable` names to an 18-bit word.
  task write(input [9:0] word, input [1:0] enable, input [17:0] data);
    begin
      if (enable[0]) words[word][8:0] <= data[8:0];
      if (enable[1]) words[word][17:9] <= data[17:9];
    end
  endtask
  function [17:0] read(input [13:0] address);
    read = WIDTH == 9 ? words[address[13:4]][9 * address[3] +: 9] : words[address[13:4]];
  endfunction

  always @(posedge CLKA) begin
    if (writes_a) begin
      case (WIDTH)
        9: write(address_a[13:4], address_a[3] ? 2'b10 : 2'b01, {2{in_a[8:0]}});
        18: write(address_a[13:4], address_a[1:0], in_a);
        default: begin
          write({address_a[13:5], 1'b0}, address_a[1:0], in_a);
          write({address_a[13:5], 1'b1}, address_a[3:2], in_b);
        end
      endcase
    end
    if (reads_a) out_a <= same && writes_b ? 18'bx : read(address_a);
  end
  always @(posedge CLKB) begin
    if (writes_b) begin
      if (WIDTH == 9) write(address_b[13:4], address_b[3] ? 2'b10 : 2'b01, {2{in_b[8:0]}});
      else write(address_b[13:4], address_b[1:0], in_b);
    end
    if (reads_b) begin
      out_b <= same && writes_a ? 18'bx :
        WIDTH == 36 ? words[{address_b[13:5], 1'b1}] : read(address_b);
      low_b <= same && writes_a ? 18'bx : words[{address_b[13:5], 1'b0}];
    end
  end

  always @(posedge CLKA) begin
    if (!(WIDTH == 9 || WIDTH == 18 || WIDTH == 36) || DATA_WIDTH_B != WIDTH || CLKA !== CLKB ||
        CLKAMUX != "CLKA" || CLKBMUX != "CLKB" ||
        (REGMODE_A != "NOREG" && REGMODE_A != "OUTREG") ||
        (REGMODE_B != "NOREG" && REGMODE_B != "OUTREG") || (WIDTH == 36 && REGMODE_A != REGMODE_B) ||
        WRITEMODE_A == "WRITETHROUGH" || WRITEMODE_B == "WRITETHROUGH" ||
        {RSTA, RSTB, CSA2, CSA1, CSA0, CSB2, CSB1, CSB0} !== 8'd0) begin
      $display("%m: a block RAM in a mode that is not modelled");
      $finish;
    end
  end
endmodule
