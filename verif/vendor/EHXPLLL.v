// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Model of the ECP5's PLL (sysCLOCK PLL Design and Usage Guide, FPGA-TN-02200; limits of the ECP5
// Family Data Sheet, FPGA-DS-02012). It measures the clock at CLKI, checks that it and all that
// follows from it is within the limits, and says in a sentence what is not. Its oscillator (VCO) then
// runs at CLKI / CLKI_DIV * CLKFB_DIV * the divider of the output that is fed back; each output
// divides that. Edges are computed from the beginning, so that outputs do not drift apart.
//
// CPHASE and FPHASE delay an output by whole periods and eighths of a period of the VCO, against the
// output that is fed back, whose edges are those of CLKI. It locks after LOCK_CYCLES periods of
// CLKI; the real one takes up to 15 ms. Not in the model: phases that change while it runs, standby,
// a feedback from outside (USERCLOCK), jitter.
`timescale 1ps / 1ps
`default_nettype none

module EHXPLLL #(
  parameter CLKI_DIV = 1,
  parameter CLKFB_DIV = 1,
  parameter CLKOP_DIV = 8,
  parameter CLKOS_DIV = 8,
  parameter CLKOS2_DIV = 8,
  parameter CLKOS3_DIV = 8,
  parameter CLKOP_ENABLE = "ENABLED",
  parameter CLKOS_ENABLE = "DISABLED",
  parameter CLKOS2_ENABLE = "DISABLED",
  parameter CLKOS3_ENABLE = "DISABLED",
  parameter CLKOP_CPHASE = 0,
  parameter CLKOS_CPHASE = 0,
  parameter CLKOS2_CPHASE = 0,
  parameter CLKOS3_CPHASE = 0,
  parameter CLKOP_FPHASE = 0,
  parameter CLKOS_FPHASE = 0,
  parameter CLKOS2_FPHASE = 0,
  parameter CLKOS3_FPHASE = 0,
  parameter FEEDBK_PATH = "CLKOP",
  parameter CLKOP_TRIM_POL = "RISING",
  parameter CLKOP_TRIM_DELAY = 0,
  parameter CLKOS_TRIM_POL = "RISING",
  parameter CLKOS_TRIM_DELAY = 0,
  parameter OUTDIVIDER_MUXA = "DIVA",
  parameter OUTDIVIDER_MUXB = "DIVB",
  parameter OUTDIVIDER_MUXC = "DIVC",
  parameter OUTDIVIDER_MUXD = "DIVD",
  parameter PLL_LOCK_MODE = 0,
  parameter PLL_LOCK_DELAY = 200,
  parameter STDBY_ENABLE = "DISABLED",
  parameter REFIN_RESET = "DISABLED",
  parameter SYNC_ENABLE = "DISABLED",
  parameter INT_LOCK_STICKY = "ENABLED",
  parameter DPHASE_SOURCE = "DISABLED",
  parameter PLLRST_ENA = "DISABLED",
  parameter INTFB_WAKE = "DISABLED",
  parameter LOCK_CYCLES = 64 // of the model alone
) (
  input  wire CLKI,
  input  wire CLKFB,
  input  wire PHASESEL1,
  input  wire PHASESEL0,
  input  wire PHASEDIR,
  input  wire PHASESTEP,
  input  wire PHASELOADREG,
  input  wire STDBY,
  input  wire PLLWAKESYNC,
  input  wire RST,
  input  wire ENCLKOP,
  input  wire ENCLKOS,
  input  wire ENCLKOS2,
  input  wire ENCLKOS3,
  output wire CLKOP,
  output wire CLKOS,
  output wire CLKOS2,
  output wire CLKOS3,
  output wire LOCK,
  output wire INTLOCK,
  output wire REFCLK,
  output wire CLKINTFB
);

  // The output that is fed back, and whether that happens inside.
  localparam INSIDE = FEEDBK_PATH == "INT_OP" || FEEDBK_PATH == "INT_OS" ||
                      FEEDBK_PATH == "INT_OS2" || FEEDBK_PATH == "INT_OS3";
  localparam integer FEEDBACK =
      FEEDBK_PATH == "CLKOP" || FEEDBK_PATH == "INT_OP" ? 0 :
      FEEDBK_PATH == "CLKOS" || FEEDBK_PATH == "INT_OS" ? 1 :
      FEEDBK_PATH == "CLKOS2" || FEEDBK_PATH == "INT_OS2" ? 2 :
      FEEDBK_PATH == "CLKOS3" || FEEDBK_PATH == "INT_OS3" ? 3 : 4;
  localparam [3:0] ENABLED = {CLKOS3_ENABLE == "ENABLED", CLKOS2_ENABLE == "ENABLED",
                              CLKOS_ENABLE == "ENABLED", CLKOP_ENABLE == "ENABLED"};

  function integer divider(input integer out);
    divider = out == 0 ? CLKOP_DIV : out == 1 ? CLKOS_DIV : out == 2 ? CLKOS2_DIV : CLKOS3_DIV;
  endfunction
  // Eighths of a period of the VCO.
  function integer phase(input integer out);
    phase = out == 0 ? 8 * CLKOP_CPHASE + CLKOP_FPHASE : out == 1 ? 8 * CLKOS_CPHASE + CLKOS_FPHASE :
            out == 2 ? 8 * CLKOS2_CPHASE + CLKOS2_FPHASE : 8 * CLKOS3_CPHASE + CLKOS3_FPHASE;
  endfunction

  localparam integer FEEDBACK_DIVIDER = divider(FEEDBACK);

  reg         running_q;
  reg         locked_q;
  reg  [31:0] rises_q; // of CLKI
  real        first;   // the time of the first, in ps
  real        input_period;
  real        vco_period;
  real        began;   // the time from which edges are counted
  wire        stopped = (PLLRST_ENA == "ENABLED" && RST) || (STDBY_ENABLE == "ENABLED" && STDBY);
  wire [3:0]  clock;

  assign {CLKOS3, CLKOS2, CLKOS, CLKOP} = clock;
  assign CLKINTFB = INSIDE && clock[FEEDBACK % 4];
  assign LOCK = locked_q;
  assign INTLOCK = locked_q;
  assign REFCLK = CLKI;

  // The time of an edge of an output; even numbers rise.
  function real edge_time(input integer out, input real number);
    integer delay;
    begin
      delay = (phase(out) - phase(FEEDBACK)) % (8 * divider(out));
      if (delay < 0) delay = delay + 8 * divider(out);
      edge_time = began + (4.0 * number * divider(out) + delay) * vco_period / 8.0;
    end
  endfunction

  localparam integer INPUT = 4, DIVIDED = 5, VCO = 6;

  // The clock of an output, or one of those above.
  task check_clock(input integer which, input real mhz, input real least, input real most);
    if (mhz < least || mhz > most) begin
      case (which)
        INPUT: $write("%m: the clock at CLKI");
        DIVIDED: $write("%m: the clock at CLKI divided by CLKI_DIV, %0d,", CLKI_DIV);
        VCO: $write("%m: the VCO's clock, CLKI / %0d * %0d * %0d (CLKI_DIV, CLKFB_DIV, divider fed back),",
                    CLKI_DIV, CLKFB_DIV, FEEDBACK_DIVIDER);
        default: $write("%m: the clock of output %0d, the VCO's divided by %0d,", which,
                        divider(which));
      endcase
      $display(" is %0.3f MHz and must be %0.3f to %0.3f MHz", mhz, least, most);
      $stop;
    end
  endtask

  task check_clocks;
    integer out;
    begin
      check_clock(INPUT, 1.0e6 / input_period, 8.0, 400.0);
      check_clock(DIVIDED, 1.0e6 / (input_period * CLKI_DIV), 10.0, 400.0);
      check_clock(VCO, 1.0e6 / vco_period, 400.0, 800.0);
      for (out = 0; out < 4; out = out + 1) begin
        if (ENABLED[out[1:0]])
          check_clock(out, 1.0e6 / (vco_period * divider(out)), 3.125, 400.0);
      end
    end
  endtask

  task check_divider(input integer given);
    if (given < 1 || given > 128) begin
      $display("%m: a divider is %0d and must be 1 to 128", given);
      $stop;
    end
  endtask

  task check_parameters;
    integer out;
    begin
      check_divider(CLKI_DIV);
      check_divider(CLKFB_DIV);
      for (out = 0; out < 4; out = out + 1) if (ENABLED[out[1:0]]) check_divider(divider(out));
      if (FEEDBACK == 4) begin
        $display("%m: FEEDBK_PATH must be CLKOP, CLKOS, CLKOS2 or CLKOS3, or INT_OP to INT_OS3");
        $stop;
      end else if (!ENABLED[FEEDBACK % 4]) begin
        $display("%m: FEEDBK_PATH names output %0d, which is not ENABLED", FEEDBACK);
        $stop;
      end
    end
  endtask

  initial begin
    running_q = 1'b0;
    locked_q = 1'b0;
    rises_q = 32'd0;
    check_parameters;
  end

  always @(posedge CLKI or posedge stopped) begin
    if (stopped) begin
      running_q <= 1'b0;
      locked_q <= 1'b0;
      rises_q <= 32'd0;
    end else begin
      rises_q <= rises_q + 32'd1;
      if (rises_q == 32'd0) first = $realtime;
      if (rises_q == LOCK_CYCLES) begin
        input_period = ($realtime - first) / LOCK_CYCLES;
        vco_period = input_period * CLKI_DIV / (CLKFB_DIV * FEEDBACK_DIVIDER);
        check_clocks;
        began = $realtime + input_period;
        running_q <= 1'b1;
      end
      if (rises_q == LOCK_CYCLES + 8) locked_q <= 1'b1;
    end
  end

  genvar o;
  generate
    for (o = 0; o < 4; o = o + 1) begin : out
      reg  clock_q;
      real number;
      assign clock[o] = clock_q;
      initial begin
        clock_q = 1'b0;
        if (ENABLED[o]) forever begin
          wait (running_q);
          number = 0.0;
          while (running_q) begin
            #(edge_time(o, number) - $realtime) clock_q = running_q && !clock_q;
            number = number + 1.0;
          end
          clock_q = 1'b0;
        end
      end
    end
  endgenerate

  // Once it runs, CLKFB must be the output that FEEDBK_PATH names.
  always @(clock) begin
    if (locked_q && !INSIDE && FEEDBACK != 4) begin
      #1;
      if (CLKFB !== clock[FEEDBACK % 4]) begin
        $display("%m: CLKFB is not joined to output %0d, which FEEDBK_PATH names", FEEDBACK);
        $stop;
      end
    end
  end

  wire unused = &{1'b0, PHASESEL1, PHASESEL0, PHASEDIR, PHASESTEP, PHASELOADREG, PLLWAKESYNC,
                  ENCLKOP, ENCLKOS, ENCLKOS2, ENCLKOS3, RST, STDBY, CLKFB};

endmodule

`default_nettype wire
