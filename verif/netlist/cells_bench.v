// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Holds the module `cells` against its netlist, `gates`, with random inputs. A row that is read while
// it is written must be unknown in the netlist, and its lowest bit tell where it may be torn.
module cells_bench;
  localparam CLOCKS = 20000;
  localparam FILLED = 2000; // clocks after which every row that is read was written

  reg clk = 0, rst_n = 0, write_en, read_en, collides = 0, collided = 0;
  reg [10:0] write_addr, read_addr;
  reg [35:0] write_data;
  reg [17:0] a, b;
  wire [35:0] wide0, wide1, exclusive0, exclusive1, signed0, signed1, registered0, registered1;
  wire [35:0] registered_wide0, registered_wide1;
  wire [8:0] narrow0, narrow1, registered_narrow0, registered_narrow1;
  wire [31:0] unsigned0, unsigned1;
  wire [13:0] small0, small1; // of the distributed RAMs
  cells rtl (clk, rst_n, write_en, read_en, write_addr, read_addr, write_data, wide0, exclusive0,
             narrow0, registered_wide0, registered_narrow0, a, b, signed0, unsigned0,
             registered0, small0[0], small0[1], small0[9:2], small0[13:10]);
  gates net (clk, rst_n, write_en, read_en, write_addr, read_addr, write_data, wide1, exclusive1,
             narrow1, registered_wide1, registered_narrow1, a, b, signed1, unsigned1,
             registered1, small1[0], small1[1], small1[9:2], small1[13:10]);

  integer i, different = 0, compared = 0, collisions = 0;
  initial begin
    for (i = 0; i < CLOCKS; i = i + 1) begin
      rst_n = i > 1;
      {write_en, read_en} = $random;
      write_addr = $random & 63;
      read_addr = $random & 63;
      write_data = {$random, $random};
      a = $random;
      b = $random;
      collided = collides; // in the clock of the row that the registers behind hold
      if (read_en) collides = write_en && write_addr == read_addr;
      #5 clk = 1;
      #5 clk = 0;
      #1 if (i >= FILLED) begin
        compared = compared + (^{wide0, narrow0} !== 1'bx);
        collisions = collisions + collides;
        different = different +
          ({signed0, unsigned0, registered0} !== {signed1, unsigned1, registered1}) +
          (small0 !== small1) +
          ({wide1[0], narrow1[0]} !== {2{collides}}) +
          ({wide1[35:1], narrow1[8:1], exclusive1} !==
           (collides ? 79'bx : {wide0[35:1], narrow0[8:1], exclusive0})) +
          ({registered_wide1, registered_narrow1} !==
           (collided ? 45'bx : {registered_wide0, registered_narrow0}));
      end
    end
    $display("%0d clocks compared, %0d different, %0d collisions", compared, different, collisions);
    if (different == 0 && compared == CLOCKS - FILLED && collisions > 0) $display("the same");
    $finish;
  end
endmodule
