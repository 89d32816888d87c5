// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A picture in a memory behind a port, pixel by pixel for display_dvi in place of a bank: the unit
// picture_reader asks for it in bursts, as many ahead as the FIFO here has space for, and the unit
// picture_pixels finds the pixels in the answers, which come in the order of the reads.
//
// A display never waits. For a missing pixel it gets black, and underrun_o stays high until the
// display is switched off. The pixel is dropped when it comes, so that the picture does not shift.
// When a picture begins, the rest of the one before is dropped. When the display is switched off,
// reads are in flight; their beats are dropped before it is switched on again.
//
// The units are lowered with the core, for its port and its pixels (hls/units/picture_reader.h), or for
// others, as the parameters say.
`default_nettype none
`include "dynrt_core.vh"

module picture_stream #(
  parameter BEAT_BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES,   // of the port
  parameter PIXEL_BYTES = `DYNRT_CORE_MEMORY_PIXEL_BYTES, // 2 or 4
  parameter AHEAD = 64 // bursts of 32 bytes that the FIFO has space for
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire                    running_i, // of display_dvi
  input  wire [447:0]            config_i,
  // display
  input  wire                    begins_i,
  input  wire [19:0]             base_i,
  input  wire                    bank_en_i,
  output wire [31:0]             bank_data_o, // three clocks later
  output wire                    underrun_o,
  // port: reads of bursts, and their beats
  output wire                    read_valid_o,
  input  wire                    read_ready_i,
  output wire [24:0]             read_address_o,
  output wire [3:0]              read_last_o,
  input  wire                    beat_valid_i,
  output wire                    beat_ready_o,
  input  wire [8*BEAT_BYTES-1:0] beat_data_i,
  input  wire                    beat_last_i
);

  localparam PLACES = BEAT_BYTES / PIXEL_BYTES; // for pixels in a beat
  localparam PLACE_BITS = PLACES > 1 ? $clog2(PLACES) : 1;
  localparam [31:0] LAST_PLACE = PLACES - 1;
  localparam PIXEL_BITS = 8 * PIXEL_BYTES;
  localparam ROOM_BITS = $clog2(AHEAD + 1);

  // ---- bursts that were asked for and have not come ----
  reg  [ROOM_BITS-1:0] in_flight_q;
  reg                  run_q; // low: all but them is in reset
  wire                 asked_valid, asked_ready;
  wire [28:0]          asked;
  wire                 asks = asked_valid && asked_ready;
  wire                 comes = beat_valid_i && beat_ready_o && beat_last_i;

  always @(posedge clk_i) begin
    run_q <= running_i && (run_q || in_flight_q == {ROOM_BITS{1'b0}});
    if (asks && !comes) in_flight_q <= in_flight_q + {{(ROOM_BITS - 1){1'b0}}, 1'b1};
    if (!asks && comes) in_flight_q <= in_flight_q - {{(ROOM_BITS - 1){1'b0}}, 1'b1};
    if (!rst_ni) begin
      run_q <= 1'b0;
      in_flight_q <= {ROOM_BITS{1'b0}};
    end
  end

  // A read that the port has seen stays there until it is taken.
  hls_buffer #(.WIDTH(29)) reads (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .valid_i(asked_valid), .ready_o(asked_ready), .data_i(asked),
    .valid_o(read_valid_o), .ready_i(read_ready_i), .data_o({read_last_o, read_address_o})
  );

  // ---- what the reader has to know, until it takes it ----
  wire                 ready;
  wire                 events_ready = run_q && ready;
  reg                  begins_q;
  reg  [19:0]          base_q;
  reg  [ROOM_BITS-1:0] rooms_q;
  wire                 room = rooms_q != {ROOM_BITS{1'b0}};
  wire                 left; // a burst has left the FIFO

  always @(posedge clk_i) begin
    if (events_ready) begins_q <= 1'b0;
    if (begins_i) begin
      begins_q <= 1'b1;
      base_q <= base_i;
    end
    if (left && !(room && events_ready)) rooms_q <= rooms_q + {{(ROOM_BITS - 1){1'b0}}, 1'b1};
    if (!left && room && events_ready) rooms_q <= rooms_q - {{(ROOM_BITS - 1){1'b0}}, 1'b1};
    if (!running_i) begins_q <= 1'b0;
    if (!run_q) rooms_q <= {ROOM_BITS{1'b0}};
  end

  picture_reader u_picture_reader (
    .clk_i(clk_i), .rst_ni(run_q),
    .events_valid_i(run_q), .events_ready_o(ready),
    .events_data_i({room, base_q, begins_q}), .config_i(config_i),
    .read_valid_o(asked_valid), .read_ready_i(asked_ready), .read_data_o(asked),
    .fire_o(), .stall_o()
  );

  // ---- the beats, and the places for pixels in them ----
  wire                    beat_valid, beat_last;
  wire [8*BEAT_BYTES-1:0] beat;
  reg  [PLACE_BITS-1:0]   place_q;
  wire                    place_ready;
  wire                    last_place = place_q == LAST_PLACE[PLACE_BITS-1:0];
  wire                    taken = beat_valid && place_ready && last_place;

  assign left = taken && beat_last;

  hls_fifo #(
    .WIDTH(8 * BEAT_BYTES + 1), .DEPTH(AHEAD * 32 / BEAT_BYTES), .BOUNDED(1)
  ) beats (
    .clk_i(clk_i), .rst_ni(run_q),
    .valid_i(run_q && beat_valid_i), .ready_o(beat_ready_o), .data_i({beat_last_i, beat_data_i}),
    .valid_o(beat_valid), .ready_i(place_ready && last_place), .data_o({beat_last, beat})
  );

  always @(posedge clk_i) begin
    if (beat_valid && place_ready)
      place_q <= last_place ? {PLACE_BITS{1'b0}} : place_q + {{(PLACE_BITS - 1){1'b0}}, 1'b1};
    if (!run_q) place_q <= {PLACE_BITS{1'b0}};
  end

  wire        pixel_valid, pixel_first, pixel_ready;
  wire [23:0] pixel;
  picture_pixels u_picture_pixels (
    .clk_i(clk_i), .rst_ni(run_q),
    .place_valid_i(beat_valid), .place_ready_o(place_ready),
    .place_data_i(beat[place_q * PIXEL_BITS +: PIXEL_BITS]), .config_i(config_i),
    .pixel_valid_o(pixel_valid), .pixel_ready_i(pixel_ready),
    .pixel_data_o({pixel_first, pixel}),
    .fire_o(), .stall_o()
  );

  // ---- the display takes them ----
  reg        searches_q; // for the first pixel of the picture that has begun
  reg [19:0] missed_q;   // pixels that the display did without
  reg        underrun_q;
  reg [71:0] way_q;      // to bank_data_o

  // The display's next pixel, or that of the missed ones which comes next.
  wire       missed = missed_q != 20'd0;
  wire       right = pixel_valid && pixel_first == searches_q;
  wire       gives = bank_en_i && right && !missed;
  wire       late = right && missed;
  wire       stale = pixel_valid && !pixel_first && searches_q;

  assign pixel_ready = gives || late || stale;
  assign bank_data_o = {8'd0, way_q[71:48]};
  assign underrun_o = underrun_q;

  always @(posedge clk_i) begin
    way_q <= {way_q[47:0], gives ? pixel : 24'd0};
    if (gives || late) searches_q <= 1'b0;
    if (bank_en_i && !gives) underrun_q <= 1'b1;
    if (bank_en_i && !gives && !late) missed_q <= missed_q + 20'd1;
    if (!bank_en_i && late) missed_q <= missed_q - 20'd1;
    if (begins_i) begin
      searches_q <= 1'b1;
      missed_q <= 20'd0;
    end
    if (!run_q) begin
      searches_q <= 1'b1;
      missed_q <= 20'd0;
    end
    if (!running_i) underrun_q <= 1'b0;
  end

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (begins_i && base_i % (32 / PIXEL_BYTES) != 20'd0) begin
      $display("%m: the picture begins at pixel %0d, which is no multiple of %0d", base_i,
               32 / PIXEL_BYTES);
      $stop;
    end
    if (beat_valid_i && in_flight_q == {ROOM_BITS{1'b0}}) begin
      $display("%m: a beat came that nobody asked for");
      $stop;
    end
  end
`endif

endmodule

`default_nettype wire
