// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// TMDS encoder: makes the three channels of a DVI link of the pixels of the scan-out (Digital
// Visual Interface 1.0, 3.2.2 and figure 3-5). A transaction is one pixel, visible or not. Every
// visible byte becomes a character of ten bits with few transitions, and as many ones as zeros in
// the long run; outside the picture the syncs choose one of four characters of many transitions, by
// which a display finds where a character begins. State: the disparity of each channel, 12 bits.
#pragma once

#include "hls/ports.h"
#include "units/scan_out.h"

namespace dynrt {

/// Ten bits of a channel; the lowest leaves first.
using TmdsCharacter = uint<10>;

/// What the three channels carry in the time of one pixel. Channel 0 is blue and has the syncs.
struct TmdsPixel {
  TmdsCharacter blue;
  TmdsCharacter green;
  TmdsCharacter red;
  HLS_FIELDS(blue, green, red)
};

struct TmdsEncoder {
  hls::In<ScanPixel> pixel;
  hls::Out<TmdsPixel> characters;
  HLS_PORTS(pixel, characters)

  void step() {
    const ScanPixel p = pixel.read();
    const auto syncs = hls::concat(uint<1>(p.vsync), uint<1>(p.hsync));
    const Channel blue = encode(p.visible, p.colour.bits<23, 16>(), syncs, blue_);
    const Channel green = encode(p.visible, p.colour.bits<15, 8>(), uint<2>(0), green_);
    const Channel red = encode(p.visible, p.colour.bits<7, 0>(), uint<2>(0), red_);
    characters.write({blue.character, green.character, red.character});
    blue_ = blue.disparity;
    green_ = green.disparity;
    red_ = red.disparity;
  }

 private:
  /// Half of what the channel has sent more of ones than of zeros; that is always even.
  using Disparity = sint<4>;

  struct Channel {
    TmdsCharacter character;
    Disparity disparity;
  };

  static Channel encode(bool visible, uint<8> byte, uint<2> control, Disparity before) {
    if (!visible) return {control_character(control), Disparity(0)};
    // Each bit is compared with the one before it in the result. Counted from the lowest, the
    // exclusive or gives the parity so far; its complement turns every other bit of that about.
    const uint<4> ones_of_byte = ones(byte);
    const bool equal = ones_of_byte > uint<4>(4) || (ones_of_byte == uint<4>(4) && !byte.bit<0>());
    const uint<8> word = parities(byte) ^ hls::select(equal, uint<8>(0xaa), uint<8>(0));
    const Disparity excess = (ones(word) - uint<4>(4)).trunc<4>();

    // What the word would add as it is, and inverted; the two bits above it count, too. All this is
    // known before the disparity is, which has to come round within a clock.
    const Disparity plain = (excess + (equal ? Disparity(-1) : Disparity(0))).trunc<4>();
    const Disparity turned = ((equal ? Disparity(0) : Disparity(1)) - excess).trunc<4>();
    const bool balanced = excess == Disparity(0);
    const bool turns_above = balanced ? equal : !excess.negative();
    const bool turns_below = balanced ? equal : excess.negative();
    const Disparity above = (before + (turns_above ? turned : plain)).trunc<4>();
    const Disparity below = (before + (turns_below ? turned : plain)).trunc<4>();

    const bool even = before == Disparity(0);
    const bool inverted = even ? equal : before.negative() ? turns_below : turns_above;
    return {hls::concat(hls::concat(uint<1>(inverted), uint<1>(!equal)), inverted ? ~word : word),
            even                ? (equal ? turned : plain)
            : before.negative() ? below
                                : above};
  }

  /// The parity of the bits up to each place.
  static uint<8> parities(uint<8> byte) {
    const uint<8> of_two = byte ^ byte.shl<1>();
    const uint<8> of_four = of_two ^ of_two.shl<2>();
    return of_four ^ of_four.shl<4>();
  }
  static uint<4> ones(uint<8> byte) {
    uint<4> count;
    for (unsigned i = 0; i < 8; ++i) count = (count + uint<1>(byte.bit(i))).trunc<4>();
    return count;
  }
  static TmdsCharacter control_character(uint<2> control) {
    constexpr TmdsCharacter kCharacters[] = {0b1101010100, 0b0010101011, 0b0101010100,
                                             0b1010101011};
    return kCharacters[control.to_u64()];
  }

  Disparity blue_;
  Disparity green_;
  Disparity red_;
};

}  // namespace dynrt
