// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's settings for a frame. Every field that configuration C has is one 32-bit register of
// the board, in this order; the registers do not change while a frame is being rendered.
#pragma once

#include <bit>

#include "hls/fields.h"
#include "units/options.h"

namespace dynrt {

/// The pixels of a packet's rays: 2x2, 4x2 or 4x4.
constexpr unsigned packet_columns(unsigned rays) { return rays == 4 ? 2 : 4; }
constexpr unsigned packet_rows(unsigned rays) { return rays / packet_columns(rays); }

/// Bits of the counter of an image's packets. Their Morton curve fills a square of pixels that has
/// room for the larger side, and for one packet.
constexpr unsigned morton_bits(unsigned width, unsigned height, unsigned rays) {
  const unsigned pixels = width > height ? width : height;
  const unsigned side = pixels > packet_columns(rays) ? pixels : packet_columns(rays);
  return 2u * static_cast<unsigned>(std::bit_width(side - 1)) -
         static_cast<unsigned>(std::countr_zero(rays));
}

template <class C>
struct FrameRegisters {
  hls::uint<32> packets;    ///< packets in flight, 1 to the configuration's number
  hls::uint<32> line_mask;  ///< cache lines - 1: 2^0 to 2^9 lines
  hls::uint<32> width;      ///< pixels
  hls::uint<32> height;     ///< pixels
  hls::uint<32> scanline;   ///< 0: Morton order of packets, 1: line by line
  /// bits of the packet counter: 2 ceil(log2(larger side in pixels)) - log2(rays of a packet)
  hls::uint<32> morton_bits;
  hls::uint<32> start_node;     ///< node of the uppermost tree where every ray starts
  hls::uint<32> camera_matrix;  ///< index of the matrix from pixel coordinates to the world
  hls::uint<32> background;     ///< colour where nothing is hit, 0x00BBGGRR
  hls::uint<32> frame_base;     ///< first pixel of the picture, in bank 3 or from kPixelsAt on
  hls::uint<32> write_hits;     ///< 1: hit records are written to banks 4 and 5
  /// 1: every ray's origin is transformed, not one for the packet
  hls::OptionalField<C::kUncompressed, hls::uint<32>> uncompressed;
  hls::uint<32> ambient;       ///< light that reaches every surface, 0 to 256 (all of it)
  hls::uint<32> lights;        ///< point lights, at most the configuration's number
  hls::uint<32> light_matrix;  ///< index of the first light's matrix
  hls::uint<32> reflections;   ///< bounces, at most the configuration's number
  hls::OptionalField<C::kOneColour, hls::uint<32>> colour;  ///< of every surface, 0x00BBGGRR
  hls::OptionalField<C::kLevels == 1, hls::uint<32>>
      object;  ///< number of the one there is, for its hits
  /// node where rays go on from the end of a list that the start node points to; 0: nowhere
  hls::OptionalField<C::kMainFirst, hls::uint<32>> others_node;
  hls::OptionalField<kTestsWorldBox<C>, hls::uint<32>>
      box_column;  ///< column of an object's box, less the number of the object's matrix
  /// columns from the boxes as they lie from the eye to those from the first light, and so on
  hls::OptionalField<kTestsWorldBox<C> && (C::kLights > 0), hls::uint<32>> boxes_apart;
  HLS_FIELDS(packets, line_mask, width, height, scanline, morton_bits, start_node, camera_matrix,
             background, frame_base, write_hits, uncompressed, ambient, lights, light_matrix,
             reflections, colour, object, others_node, box_column, boxes_apart)
};

/// No core: the host fills every register that some configuration has.
struct EveryRegister {
  static constexpr bool kUncompressed = true;
  static constexpr bool kOneColour = true;
  static constexpr unsigned kLevels = 1;
  static constexpr bool kMainFirst = true;
  static constexpr unsigned kLights = 1;
};
template <>
inline constexpr bool kTestsWorldBox<EveryRegister> = true;
using FrameConfig = FrameRegisters<EveryRegister>;

/// The host's registers that configuration C has.
template <class C>
FrameRegisters<C> registers_of(const FrameConfig& all) {
  const auto value = []<class F>(const F& field) {
    if constexpr (requires { field.get(); }) {
      return field.get();
    } else {
      return field;
    }
  };
  FrameRegisters<C> some;
  some.hls_visit(
      [&](auto&... to) { all.hls_visit([&](const auto&... from) { ((to = value(from)), ...); }); });
  return some;
}

}  // namespace dynrt
