// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's registers as a Wishbone B4 subordinate, pipelined, of 4 KB and 32 bits, with an
// address of bytes. One access is under way at a time; STALL keeps the next one waiting. An access
// to an address that has no register, or one of less than a whole word, has no effect and gets ERR
// in place of ACK. An access whose CYC falls gets no answer.
`default_nettype none

module wishbone_registers (
  input  wire        clk_i,
  input  wire        rst_ni,
  // Wishbone
  input  wire        s_wb_cyc_i,
  input  wire        s_wb_stb_i,
  input  wire        s_wb_we_i,
  input  wire [11:0] s_wb_adr_i,
  input  wire [31:0] s_wb_dat_i,
  input  wire [3:0]  s_wb_sel_i,
  output wire        s_wb_stall_o,
  output wire        s_wb_ack_o,
  output wire        s_wb_err_o,
  output wire [31:0] s_wb_dat_o,
  // board_registers
  output wire        bus_valid_o,
  output wire        bus_write_o,
  output wire [25:0] bus_addr_o,
  output wire [31:0] bus_wdata_o,
  input  wire        bus_ready_i,
  input  wire        bus_exists_i, // of bus_addr_o, in the same clock
  input  wire        bus_rvalid_i,
  input  wire [31:0] bus_rdata_i
);

  reg        waits_q;   // for the bus
  reg        reading_q; // the bus has yet to answer
  reg        answer_q;  // for the manager
  reg        error_q;
  reg        left_q;    // CYC has fallen since the access came
  reg        write_q;
  reg [9:0]  word_q;
  reg [31:0] wdata_q;
  reg        whole_q;
  reg [31:0] rdata_q;

  wire taken = s_wb_cyc_i && s_wb_stb_i && !s_wb_stall_o;
  assign s_wb_stall_o = waits_q || reading_q || answer_q;
  assign s_wb_ack_o = answer_q && !error_q && s_wb_cyc_i;
  assign s_wb_err_o = answer_q && error_q && s_wb_cyc_i;
  assign s_wb_dat_o = rdata_q;

  wire allowed = bus_exists_i && whole_q;
  assign bus_valid_o = waits_q && allowed;
  assign bus_write_o = write_q;
  assign bus_addr_o = {14'd0, word_q, 2'b00};
  assign bus_wdata_o = wdata_q;
  wire done = waits_q && (bus_ready_i || !allowed);
  wire asked = done && allowed && !write_q;
  wire answered = (done && !asked) || (reading_q && bus_rvalid_i);

  always @(posedge clk_i) begin
    if (taken) begin
      write_q <= s_wb_we_i;
      word_q <= s_wb_adr_i[11:2];
      wdata_q <= s_wb_dat_i;
      whole_q <= &s_wb_sel_i;
    end
    if (done) error_q <= !allowed;
    rdata_q <= reading_q ? bus_rdata_i : 32'd0;
    left_q <= !taken && (left_q || !s_wb_cyc_i);
    waits_q <= taken || (waits_q && !done);
    reading_q <= asked || (reading_q && !bus_rvalid_i);
    answer_q <= answered && !left_q && s_wb_cyc_i;
    if (!rst_ni) begin
      waits_q <= 1'b0;
      reading_q <= 1'b0;
      answer_q <= 1'b0;
    end
  end

  wire unused = &{1'b0, s_wb_adr_i[1:0]};

endmodule

`default_nettype wire
