// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scan-out: reads a picture from bank 3 and makes the signals of a VGA display of it (the thesis's
// prototype has a VGA output, chapter 7). It belongs to the board, not to the join of the core: it
// goes on while the core is reset and stands still between frames. A transaction is one pixel of
// the display, visible or not; board_scan.v asks for them at the pixel clock. State: position on
// the display, address of the picture's next pixel.
#pragma once

#include "hls/ports.h"
#include "units/memory_format.h"

namespace dynrt {

/// The picture and the display's mode, in pixels and lines. Every field is one 32-bit register of
/// the board, in this order. Only `base` may change while pixels are asked for. A mode is given as
/// in an X11 mode line: a line is `hdisplay` visible pixels, the front porch to `hsync_start`, the
/// pulse to `hsync_end`, the back porch to `htotal`; and so down the display.
struct ScanConfig {
  uint<32> base;    ///< first word of the picture, taken over at the start of a vertical blank
  uint<32> width;   ///< of the picture, whose rows follow each other and fit the display
  uint<32> height;  ///< what lies below the display is not shown
  uint<32> left;    ///< its place on the display; the rest is black
  uint<32> top;
  uint<32> hdisplay;
  uint<32> hsync_start;
  uint<32> hsync_end;
  uint<32> htotal;
  uint<32> vdisplay;
  uint<32> vsync_start;
  uint<32> vsync_end;
  uint<32> vtotal;
  uint<32> positive_syncs;  ///< bit 0: hsync is high in its pulse, bit 1: vsync is
  HLS_FIELDS(base, width, height, left, top, hdisplay, hsync_start, hsync_end, htotal, vdisplay,
             vsync_start, vsync_end, vtotal, positive_syncs)
};

/// The pins of one pixel.
struct ScanPixel {
  uint<24> colour;  ///< red lowest; black where `visible` is false
  bool hsync = false;
  bool vsync = false;
  bool visible = false;  ///< called "not blanked" in a converter
  HLS_FIELDS(colour, hsync, vsync, visible)
};

template <class C>
struct ScanOut {
  using Position = uint<12>;
  using BankAddress = uint<20>;

  hls::In<uint<1>> tick;  ///< asks for a pixel; 1: the display's first
  hls::Config<ScanConfig> config;
  hls::RamRead<Word, kBankWords, kSramLatency> bank;
  hls::Out<ScanPixel> pixel;
  hls::Out<BankAddress> shown;  ///< once in a vertical blank: the next picture
  HLS_PORTS(tick, config, bank, pixel, shown)

  void step() {
    const bool first = bool(tick.read());
    const ScanConfig c = config.get();
    const Position column = first ? Position(0) : column_;
    const Position line = first ? Position(0) : line_;
    const bool lit = !first && lit_;

    const Position x = Position::of_raw(column.raw() - position(c.left).raw());
    const Position y = Position::of_raw(line.raw() - position(c.top).raw());
    const bool row_visible = line < position(c.vdisplay);
    const bool inside = lit && row_visible && x < position(c.width) && y < position(c.height);
    Word word;
    if (inside) word = bank.read(next_);

    const bool visible = row_visible && column < position(c.hdisplay);
    const bool hsync = position(c.hsync_start) <= column && column < position(c.hsync_end);
    const bool vsync = position(c.vsync_start) <= line && line < position(c.vsync_end);
    pixel.write({inside && visible ? word.template trunc<24>() : uint<24>(0),
                 hsync == c.positive_syncs.template bit<0>(),
                 vsync == c.positive_syncs.template bit<1>(), visible});

    // The base is looked at once, in the first pixel of the blank, so that it may change at any
    // time; what was taken is told from the register, a pixel later.
    const bool blank = line == position(c.vdisplay);
    if (blank && column == Position(1)) shown.write(next_);
    if (blank && column == Position(0)) {
      next_ = c.base.template trunc<20>();
      lit_ = true;
    } else {
      if (inside) next_ = after(next_);
      lit_ = lit;
    }
    const bool line_ends = column == before(position(c.htotal));
    column_ = line_ends ? Position(0) : after(column);
    const bool all_ends = line == before(position(c.vtotal));
    line_ = !line_ends ? line : all_ends ? Position(0) : after(line);
  }

 private:
  static Position position(uint<32> field) { return field.template trunc<12>(); }
  static Position before(Position p) { return (p + Position::ones()).template trunc<12>(); }
  template <unsigned W>
  static uint<W> after(uint<W> value) {
    return (value + uint<1>(1)).template trunc<W>();
  }

  Position column_;
  Position line_;
  BankAddress next_;  ///< word of the picture's next pixel
  bool lit_ = false;  ///< a vertical blank has been; until then there is no picture
};

/// Registers of the display.
inline constexpr unsigned kScanWords = hls::bit_width_of<ScanConfig>() / 32;

}  // namespace dynrt
