// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The SDRAM of the ULX3S behind a memory port in another clock. Reads and writes cross by a FIFO each,
// as the port takes writes together and reads meanwhile; beats come back by a third. So a read sees a
// write before it only if it comes when writes_idle_o is high: every write has reached the port then,
// which tells by a token that crosses back.
//
// Parameters:
//   ID_BITS      of a read
//   BEAT_BYTES   of the port
//   PAUSE_TURNS  clocks of the chip's pause after power-up, in pairs
`default_nettype none

module ulx3s_memory #(
  parameter ID_BITS = 8,
  parameter BEAT_BYTES = 16,
  parameter [15:0] PAUSE_TURNS = 16'd10000
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire                    read_valid_i,
  output wire                    read_ready_o,
  input  wire [ID_BITS-1:0]      read_id_i,
  input  wire [24:0]             read_address_i,
  input  wire [3:0]              read_last_i,
  output wire                    beat_valid_o,
  input  wire                    beat_ready_i,
  output wire [ID_BITS-1:0]      beat_id_o,
  output wire [8*BEAT_BYTES-1:0] beat_data_o,
  output wire                    beat_last_o,
  input  wire                    write_valid_i,
  output wire                    write_ready_o,
  input  wire [24:0]             write_address_i,
  input  wire [8*BEAT_BYTES-1:0] write_data_i,
  input  wire [BEAT_BYTES/2-1:0] write_mask_i,
  output wire                    writes_idle_o,
  // the chip, in its own clock
  input  wire                    sdram_clk_i,
  input  wire                    sdram_rst_ni,
  output wire                    sdram_ras_no,
  output wire                    sdram_cas_no,
  output wire                    sdram_we_no,
  output wire [1:0]              sdram_ba_o,
  output wire [12:0]             sdram_a_o,
  output wire [1:0]              sdram_dqm_o,
  output wire [15:0]             sdram_dq_float_o,
  output wire [15:0]             sdram_dq_o,
  input  wire [15:0]             sdram_dq_i
);

  localparam DATA_BITS = 8 * BEAT_BYTES;
  localparam MASK_BITS = BEAT_BYTES / 2;
  localparam READS = 16;
  localparam WRITES = 32;
  localparam BEATS = 16;
  localparam COUNT_BITS = 8; // for all writes that FIFOs and port hold

  // The port lies at the chip's pins, far from the core: what crosses waits in a buffer on the way.
  wire                    crossed_read_valid, crossed_read_ready;
  wire                    chip_read_valid, chip_read_ready;
  wire [ID_BITS-1:0]      chip_read_id;
  wire [24:0]             chip_read_address;
  wire [3:0]              chip_read_last;
  wire [ID_BITS+25+4-1:0] crossed_read;
  hls_clock_fifo #(.WIDTH(ID_BITS + 25 + 4), .DEPTH(READS)) reads (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(read_valid_i), .ready_o(read_ready_o),
    .data_i({read_id_i, read_address_i, read_last_i}),
    .read_clk_i(sdram_clk_i), .read_rst_ni(sdram_rst_ni),
    .valid_o(crossed_read_valid), .ready_i(crossed_read_ready), .data_o(crossed_read)
  );
  hls_buffer #(.WIDTH(ID_BITS + 25 + 4)) read_at_port (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni),
    .valid_i(crossed_read_valid), .ready_o(crossed_read_ready), .data_i(crossed_read),
    .valid_o(chip_read_valid), .ready_i(chip_read_ready),
    .data_o({chip_read_id, chip_read_address, chip_read_last})
  );

  wire                    crossed_write_valid, crossed_write_ready;
  wire                    chip_write_valid, chip_write_ready;
  wire [24:0]             chip_write_address;
  wire [DATA_BITS-1:0]    chip_write_data;
  wire [MASK_BITS-1:0]    chip_write_mask;
  wire [25+DATA_BITS+MASK_BITS-1:0] crossed_write;
  hls_clock_fifo #(.WIDTH(25 + DATA_BITS + MASK_BITS), .DEPTH(WRITES)) writes (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(write_valid_i), .ready_o(write_ready_o),
    .data_i({write_address_i, write_data_i, write_mask_i}),
    .read_clk_i(sdram_clk_i), .read_rst_ni(sdram_rst_ni),
    .valid_o(crossed_write_valid), .ready_i(crossed_write_ready), .data_o(crossed_write)
  );
  hls_buffer #(.WIDTH(25 + DATA_BITS + MASK_BITS)) write_at_port (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni),
    .valid_i(crossed_write_valid), .ready_o(crossed_write_ready), .data_i(crossed_write),
    .valid_o(chip_write_valid), .ready_i(chip_write_ready && taken_ready),
    .data_o({chip_write_address, chip_write_data, chip_write_mask})
  );

  // A write that the port has taken.
  wire                    taken_ready, taken;
  hls_clock_fifo #(.WIDTH(1), .DEPTH(WRITES)) takes (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni), .valid_i(chip_write_valid && chip_write_ready),
    .ready_o(taken_ready), .data_i(1'b0),
    .read_clk_i(clk_i), .read_rst_ni(rst_ni), .valid_o(taken), .ready_i(1'b1), .data_o()
  );
  reg  [COUNT_BITS-1:0]   under_way_q;
  wire                    begins = write_valid_i && write_ready_o;
  assign writes_idle_o = under_way_q == {COUNT_BITS{1'b0}};
  always @(posedge clk_i) begin
    if (!rst_ni) under_way_q <= {COUNT_BITS{1'b0}};
    else if (begins && !taken) under_way_q <= under_way_q + 1'b1;
    else if (taken && !begins) under_way_q <= under_way_q - 1'b1;
  end

  wire                    beat_valid, beat_ready, beat_last;
  wire [ID_BITS-1:0]      beat_id;
  wire [DATA_BITS-1:0]    beat_data;
  wire                    leaving_valid, leaving_ready;
  wire                    back_valid, back_ready;
  wire [DATA_BITS+ID_BITS:0] leaving, back;
  sdram_port #(
    .ID_WIDTH(ID_BITS), .PORT_BYTES(BEAT_BYTES), .CAS_LATENCY(2)
  ) chip (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni), .pause_i(PAUSE_TURNS),
    .read_valid_i(chip_read_valid), .read_ready_o(chip_read_ready), .read_id_i(chip_read_id),
    .read_address_i(chip_read_address), .read_last_i(chip_read_last),
    .write_valid_i(chip_write_valid && taken_ready), .write_ready_o(chip_write_ready),
    .write_address_i(chip_write_address), .write_data_i(chip_write_data),
    .write_mask_i(chip_write_mask),
    .beat_valid_o(beat_valid), .beat_ready_i(beat_ready), .beat_id_o(beat_id),
    .beat_data_o(beat_data), .beat_last_o(beat_last),
    .sdram_ras_no(sdram_ras_no), .sdram_cas_no(sdram_cas_no), .sdram_we_no(sdram_we_no),
    .sdram_ba_o(sdram_ba_o), .sdram_a_o(sdram_a_o), .sdram_dqm_o(sdram_dqm_o),
    .sdram_dq_float_o(sdram_dq_float_o), .sdram_dq_o(sdram_dq_o), .sdram_dq_i(sdram_dq_i)
  );

  hls_buffer #(.WIDTH(DATA_BITS + ID_BITS + 1)) beat_at_port (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni),
    .valid_i(beat_valid), .ready_o(beat_ready), .data_i({beat_last, beat_id, beat_data}),
    .valid_o(leaving_valid), .ready_i(leaving_ready), .data_o(leaving)
  );
  hls_clock_fifo #(.WIDTH(DATA_BITS + ID_BITS + 1), .DEPTH(BEATS)) from_chip (
    .clk_i(sdram_clk_i), .rst_ni(sdram_rst_ni),
    .valid_i(leaving_valid), .ready_o(leaving_ready), .data_i(leaving),
    .read_clk_i(clk_i), .read_rst_ni(rst_ni),
    .valid_o(back_valid), .ready_i(back_ready), .data_o(back)
  );
  hls_buffer #(.WIDTH(DATA_BITS + ID_BITS + 1)) beat_at_switch (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .valid_i(back_valid), .ready_o(back_ready), .data_i(back),
    .valid_o(beat_valid_o), .ready_i(beat_ready_i),
    .data_o({beat_last_o, beat_id_o, beat_data_o})
  );

endmodule

`default_nettype wire
