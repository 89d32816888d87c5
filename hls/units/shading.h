// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shading: writes the pixels of a packet's rays and, if asked, the hit records of its primary rays,
// three words to each half of a record (thesis chapter 7). A ray takes three clocks, one for each
// word; after a packet's last step the packet is free. What writes, and in which order, is a part:
// banks that the core has to itself (units/bank_writer.h), banks that pipelines share
// (units/shared_bank_writer.h), or bursts to a memory behind the port (units/burst_writer.h).
#pragma once

#include <type_traits>

#include "units/bank_writer.h"
#include "units/burst_writer.h"
#include "units/frame.h"
#include "units/intersection_tokens.h"
#include "units/pixel_colour.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"
#include "units/shared_bank_writer.h"

namespace dynrt {

/// The part of the shading that writes.
template <class C>
using PictureWriter =
    std::conditional_t<kHasPort<C>, BurstWriter<C>,
                       std::conditional_t<kHasPipelines<C>, SharedBankWriter<C>, BankWriter<C>>>;

template <class C>
struct Shading : PictureWriter<C>, PixelColour<C> {
  using Real = typename C::Real;
  using Writer = PictureWriter<C>;
  static_assert(Real::kLeafWidth <= Word::kWidth, "a hit record has a word for each float");
  static_assert(kHasPort<C> || C::kPixelBits == 32, "a bank's word holds one pixel");
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr double kUncertaintyNs = kLongWiresNs<C>;
  using BankAddress = uint<20>;

  hls::In<Repeated<ShadeJob<C>>> job;
  hls::Config<FrameRegisters<C>> frame;
  hls::RamRead<HitRecord<C>, kRayRows<C>> hit;
  hls::RamRead<PixelPosition, kPackets> position;
  using PortsOfParts = hls::Parts<Writer, PixelColour<C>>;
  HLS_PORTS(job, frame, hit, position)

  void step() {
    const Repeated<ShadeJob<C>> j = job.read();
    const FrameRegisters<C> config = frame.get();
    const RayIndex<C> ray = Writer::ray_of(j.index);
    const uint<2> word = Writer::word_of(j.index);
    const HitRecord<C> h = hit.read(ray_row<C>(j.job.packet, ray));
    const PixelPosition p = pixel_of<C>(position.read(j.job.packet), ray);

    const bool inside = p.x.template zext<11>() < config.width.template trunc<11>() &&
                        p.y.template zext<11>() < config.height.template trunc<11>();
    const BankAddress pixel = BankAddress::from((p.y * Writer::pitch_of(config) + p.x).raw());
    const Word colour = this->colour_of(h, ray_row<C>(j.job.packet, ray), config);

    FrameWrite<C> w;
    w.has_pixel = inside;
    w.has_hit = inside && config.write_hits.template bit<0>();
    w.last = j.last;
    w.colour = PixelOf<C>::of(colour);
    w.hit = BankAddress::from((pixel + pixel.template shl<1>() + word).raw());
    w.place = hit_word(HitPlace{h.t.bits(), h.v.bits(), object_of(h, config), 0, h.hit}, word);
    w.surface = hit_word(HitSurface{h.u.bits(), h.cosine.bits(), h.triangle, 0}, word);
    w.pixel = BankAddress::from((pixel + config.frame_base.template trunc<20>()).raw());
    w.packet.packet = j.job.packet;
    this->put(w, ray, word);
  }

 private:
  /// A miss has none, which is zero.
  static MatrixIndex object_of(const HitRecord<C>& h, const FrameRegisters<C>& config) {
    if constexpr (kTwoLevels<C>) {
      return h.object;
    } else {
      return h.hit ? config.object.get().template trunc<kMatrixBits>() : MatrixIndex{};
    }
  }
  template <class Words>
  static Word hit_word(const Words& words, uint<2> index) {
    return index == uint<2>(0)   ? hls::word_of<0>(words)
           : index == uint<2>(1) ? hls::word_of<1>(words)
                                 : hls::word_of<2>(words);
  }
};

}  // namespace dynrt
