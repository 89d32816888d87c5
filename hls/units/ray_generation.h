// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ray generation: gives a free packet the next pixels of the image, in Morton order (thesis
// chapter 7: counter bits ... y1 x1 y0 x0) or line by line, and has the camera's matrix applied to
// it. Morton positions outside the image are passed over, a whole block of them by two packets.
// When the image is used up the unit keeps the packets that come back; with the last of them the
// frame is complete. Pipelines share the unit: each has a block of the curve
// (units/morton_blocks.h); of lines the next pixels go to whichever has a packet free.
#pragma once

#include <algorithm>

#include "units/frame.h"
#include "units/morton_blocks.h"
#include "units/pipelines.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct FreePacket {
  PacketId<C> packet;
  [[no_unique_address]] PipelineNumber<C> pipeline{};
  HLS_FIELDS(packet, pipeline)
};

/// Where ray generation keeps the pixels of a pipeline's packets.
template <class C>
using PixelPositions = hls::RamWrite<PixelPosition, 1u << PacketId<C>::kWidth>;

template <class C>
struct RayGeneration {
  static constexpr unsigned kColumns = packet_columns(kRays<C>);
  static constexpr unsigned kRows = packet_rows(kRays<C>);
  static constexpr unsigned kColumnBits = hls::index_width(kColumns);
  static constexpr unsigned kRowBits = hls::index_width(kRows);
  /// Of a packet's position: images up to 1024 x 1024.
  static constexpr unsigned kSideBits = 10 - std::min(kColumnBits, kRowBits);
  /// The curve goes through pixels, and those of a packet are one point of it.
  static constexpr unsigned kCounterBits = 2 * 10 - kRayBits<C>;
  /// Of the counter within a block of 64 packets.
  static constexpr unsigned kBlockBits = 6;

  hls::In<FreePacket<C>> free;
  hls::Config<FrameRegisters<C>> frame;
  PortOfEach<kPipelines<C>, hls::Out<TransformJob<C>>> job;
  hls::Out<FreePacket<C>> skipped;
  hls::Out<uint<1>> done;
  PortOfEach<kPipelines<C>, PixelPositions<C>> position;
  HLS_PORTS(free, frame, job, skipped, done, position)

  void step() {
    const FreePacket<C> f = free.read();
    const FrameRegisters<C> config = frame.get();
    const uint<10> columns = packets_of<kColumnBits>(config.width);
    const uint<10> rows = packets_of<kRowBits>(config.height);

    const bool scanline = config.scanline.template bit<0>();
    const Place next = place_of(f);
    const uint<kSideBits> x = scanline ? scan_x_ : morton<kColumnBits>(next.counter, 0);
    const uint<kSideBits> y =
        scanline ? scan_y_.template trunc<kSideBits>() : morton<kRowBits>(next.counter, 1);
    const bool in_width = x.template zext<10>() < columns;
    const bool in_height = y.template zext<10>() < rows;

    if constexpr (kHasPipelines<C>) advance_block(f, config);
    if (scanline || !kHasPipelines<C> ? bool(over_) : next.is_over) {
      returned_ = hls::next(returned_);
      if (returned_ == in_flight(config.packets)) done.write(1);
    } else {
      const bool line_end = line_end_ || columns == 1;
      const bool morton_end = next_of_curve(config);
      line_end_ = uint<1>(!line_end && scan_x_.template zext<10>() == before(before(columns)));
      over_ = uint<1>(scanline ? line_end && scan_y_ == before(rows) : morton_end);
      if (line_end) scan_y_ = hls::next(scan_y_);
      scan_x_ = line_end ? uint<kSideBits>{} : hls::next(scan_x_);

      if (in_width && in_height) {
        const PixelPosition p{pixel<kColumnBits>(x), pixel<kRowBits>(y)};
        write_to<kPipelines<C>>(position, f.pipeline.get(), f.packet, p);
        TransformJob<C> camera;
        camera.packet = f.packet;
        camera.kind = TransformKind::kCamera;
        camera.active = mask(p, config);
        camera.matrix = config.camera_matrix.template trunc<C::kMatrixBits>();
        write_to<kPipelines<C>>(job, f.pipeline.get(), camera);
      } else {
        skipped.write(f);
      }
    }
    in_width_ = uint<1>(in_width);
    in_height_ = uint<1>(in_height);
  }

 private:
  using Returned = uint<std::max(8u, hls::index_width(kPipelines<C>* C::kPackets + 1))>;
  /// Packets of all pipelines.
  static Returned in_flight(Word packets) {
    if constexpr (kHasPipelines<C>) {
      return Returned::from((packets.template trunc<8>() * uint<5>(kPipelines<C>)).raw());
    } else {
      return packets.template trunc<8>();
    }
  }
  using Blocks = MortonBlocks<C, kCounterBits>;
  using Place = typename Blocks::Next;
  /// The next packet's on the Morton curve.
  Place place_of(const FreePacket<C>& f) const {
    if constexpr (kHasPipelines<C>) {
      return blocks_.next(f.pipeline.get());
    } else {
      return {counter_};
    }
  }
  void advance_block(const FreePacket<C>& f, const FrameRegisters<C>& config) {
    const auto corner = blocks_.corner();
    const bool is_inside =
        morton<kColumnBits>(corner, 0).template zext<10>() <
            packets_of<kColumnBits>(config.width) &&
        morton<kRowBits>(corner, 1).template zext<10>() < packets_of<kRowBits>(config.height);
    blocks_.advance(f.pipeline.get(), is_inside,
                    last_packet(config.morton_bits.template trunc<5>()));
  }
  /// Counts on along the Morton curve; true at its end. A block that begins outside the image lies
  /// outside, for it begins at its corner with the least x and y.
  bool next_of_curve(const FrameRegisters<C>& config) {
    if constexpr (kHasPipelines<C>) return false;
    const uint<kCounterBits> last = last_packet(config.morton_bits.template trunc<5>());
    const bool morton_end = counter_ == last;
    const auto block = counter_.template bits<kCounterBits - 1, kBlockBits>();
    const bool last_block = block == last.template bits<kCounterBits - 1, kBlockBits>();
    const bool pass_over = begun_ && !(in_width_ && in_height_);
    begun_ =
        uint<1>(!last_block && counter_.template bits<kBlockBits - 1, 0>() == uint<kBlockBits>(0));
    counter_ = pass_over ? hls::concat(hls::next(block), uint<kBlockBits>(0)) : hls::next(counter_);
    return morton_end;
  }
  /// Packets along a side of the image, whose edge one may cross.
  template <unsigned Bits>
  static uint<10> packets_of(Word side) {
    const auto rounded = side.template trunc<11>() + uint<11>((1u << Bits) - 1);
    return rounded.template trunc<11>().template bits<10, Bits>().template zext<10>();
  }
  template <unsigned Bits>
  static uint<10> pixel(uint<kSideBits> packet) {
    return hls::concat(packet, uint<Bits>(0)).template trunc<10>();
  }
  static uint<10> before(uint<10> value) { return (value + uint<10>::ones()).template trunc<10>(); }
  /// A packet's x (axis 0) or y (1), whose lowest bit is bit `Low` of its pixels': every second bit
  /// of its place on the curve.
  template <unsigned Low>
  static uint<kSideBits> morton(uint<kCounterBits> counter, unsigned axis) {
    uint<kSideBits> side;
    for (unsigned i = 0; i < 10 - Low; ++i) {
      const unsigned bit = 2 * (i + Low) + axis - kRayBits<C>;
      if (counter.bit(bit)) side = side | uint<kSideBits>::from(1u << i);
    }
    return side;
  }
  /// Ones in the lowest `bits`, made bit by bit: a shift would come out inverted, which is logic
  /// more in the loop of over_.
  static uint<kCounterBits> last_packet(uint<5> bits) {
    uint<kCounterBits> last;
    for (unsigned i = 0; i < kCounterBits; ++i) {
      last =
          hls::concat(uint<1>(bits > uint<5>::from(i)), last.template bits<kCounterBits - 1, 1>());
    }
    return last;
  }
  /// The rays of a packet whose pixels lie in the image.
  static RayMask<C> mask(PixelPosition p, const FrameRegisters<C>& config) {
    const uint<11> last_x = config.width.template trunc<11>();
    const uint<11> last_y = config.height.template trunc<11>();
    RayMask<C> inside;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      const PixelPosition at = pixel_of<C>(p, RayIndex<C>::from(i));
      const bool x1 = i % kColumns == 0 || at.x.template zext<11>() < last_x;
      const bool y1 = i < kColumns || at.y.template zext<11>() < last_y;
      inside = hls::concat(uint<1>(x1 && y1), inside.template bits<kRays<C> - 1, 1>());
    }
    return inside;
  }

  uint<kCounterBits> counter_;  ///< Morton: packets handed out or passed over
  [[no_unique_address]] std::conditional_t<kHasPipelines<C>, Blocks, hls::Absent> blocks_;
  uint<kSideBits> scan_x_;
  uint<kSideBits + 1> scan_y_;  ///< reaches the number of rows
  // These are known a transaction ahead, so that the loops are short.
  uint<1> begun_;     ///< Morton: the packet before began a block, and not the last one
  uint<1> in_width_;  ///< the packet before lay in the image
  uint<1> in_height_;
  uint<1> line_end_;  ///< scan_x_ is the last column, but not the only one
  uint<1> over_;      ///< no packet is left
  Returned returned_;
};

}  // namespace dynrt
