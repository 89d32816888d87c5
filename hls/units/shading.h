// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shading: the eye light of the thesis's prototype (chapter 7): the triangle's colour times the
// scalar product of ray direction and normal, at most one; or, where there are light or reflection
// rays, the colour that the shader has found. It takes three clocks a ray: if asked, it writes the
// hit records of the primary rays to banks 4 and 5, three words to each, first those of all rays,
// then the second, then the third. In the first two rounds it writes the pixels of every second ray
// to bank 3, so that the bank has a clock for the display between two pixels. After a packet's last
// step the packet is free. Where pipelines share the banks, frame_writer.h has the writes. To a
// memory behind the port it writes ray by ray, which frame_gather.h makes bursts of.
#pragma once

#include <type_traits>

#include "units/colour.h"
#include "units/frame.h"
#include "units/frame_gather.h"
#include "units/intersection_tokens.h"
#include "units/ray_generation.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"

namespace dynrt {

template <class C>
struct Shading {
  using Real = typename C::Real;
  static_assert(Real::kLeafWidth <= Word::kWidth, "a hit record has a word for each float");
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr bool kOwnBanks = !kHasPipelines<C> && !kHasPort<C>;
  static constexpr double kUncertaintyNs = kLongWiresNs<C>;
  using BankAddress = uint<20>;

  hls::In<Repeated<ShadeJob<C>>> job;
  hls::Config<FrameRegisters<C>> frame;
  hls::OptionalPort<kOwnBanks, hls::Out<FreePacket<C>>> free;
  hls::RamRead<HitRecord<C>, kRayRows<C>> hit;
  hls::RamRead<PixelPosition, kPackets> position;
  std::conditional_t<kOwnBanks, OutBank[3], hls::Absent> bank;
  hls::OptionalPort<kHasSecondary<C>, hls::RamRead<uint<24>, kRayRows<C>>> pixel_colour;
  hls::OptionalPort<!kOwnBanks && !kHasPort<C>, hls::Out<FrameWrite<C>>> write;
  hls::OptionalPort<kHasPort<C>, hls::Out<WriteBurst<C>>> burst;
  hls::OptionalPort<kHasPipelines<C>, hls::Config<PipelineId<C>>> pipeline;
  HLS_PORTS(job, frame, free, hit, position, bank, pixel_colour, write, burst, pipeline)

  void step() {
    const Repeated<ShadeJob<C>> j = job.read();
    const FrameRegisters<C> config = frame.get();
    const RayIndex<C> ray = ray_of(j.index);
    const uint<2> word = word_of(j.index);
    const HitRecord<C> h = hit.read(ray_row<C>(j.job.packet, ray));
    const PixelPosition p = pixel_of<C>(position.read(j.job.packet), ray);

    const bool inside = p.x.template zext<11>() < config.width.template trunc<11>() &&
                        p.y.template zext<11>() < config.height.template trunc<11>();
    const BankAddress pixel = BankAddress::from((p.y * pitch_of(config) + p.x).raw());

    Word colour;
    if constexpr (kHasSecondary<C>) {
      colour = pixel_colour.read(ray_row<C>(j.job.packet, ray));
    } else {
      colour = h.hit ? Word(eye_light(surface_colour<C>(h.colour, config), in_256ths(h.cosine)))
                     : config.background;
    }
    FrameWrite<C> w;
    if (kHasPort<C> || (inside && word == ray.template bits<0, 0>().template zext<2>())) {
      put_pixel(w, BankAddress::from((pixel + config.frame_base.template trunc<20>()).raw()),
                colour);
    }
    if (kHasPort<C> || (inside && config.write_hits.template bit<0>())) {
      const BankAddress at = BankAddress::from((pixel + pixel.template shl<1>() + word).raw());
      put_hit(w, at,
              hit_word(HitPlace{h.t.bits(), h.v.bits(), object_of(h, config), 0, h.hit}, word),
              hit_word(HitSurface{h.u.bits(), h.cosine.bits(), h.triangle, 0}, word));
    }
    if constexpr (kHasPort<C>) {
      w.has_pixel = inside;
      w.has_hit = inside && config.write_hits.template bit<0>();
    }
    w.last = j.last;
    w.packet.packet = j.job.packet;
    if constexpr (kHasPipelines<C>) w.packet.pipeline = pipeline.get();
    end(w, ray, word);
  }

 private:
  void put_pixel(FrameWrite<C>& w, BankAddress at, Word colour) {
    if constexpr (kOwnBanks) {
      bank[0].write(at, colour);
    } else {
      w.has_pixel = true;
      w.pixel = at;
      w.colour = PixelOf<C>::of(colour);
    }
  }
  void put_hit(FrameWrite<C>& w, BankAddress at, Word place, Word surface) {
    if constexpr (kOwnBanks) {
      bank[1].write(at, place);
      bank[2].write(at, surface);
    } else {
      w.has_hit = true;
      w.hit = at;
      w.place = place;
      w.surface = surface;
    }
  }
  void end(const FrameWrite<C>& w, RayIndex<C> ray, uint<2> word) {
    if constexpr (kHasPort<C>) {
      gather_.take(w, ray.template trunc<FrameGather<C>::Column::kWidth>(), word, burst);
    } else if constexpr (kHasPipelines<C>) {
      if (w.has_pixel || w.has_hit || w.last) write.write(w);
    } else if (w.last) {
      free.write(w.packet);
    }
  }

  /// The ray and the word of its hit record of a step.
  static RayIndex<C> ray_of(RepeatCount<C> index) {
    if constexpr (kHasPort<C>) {
      return RayIndex<C>::from((index * uint<6>(43)).raw() >> 7);  // a third of an index below 64
    } else {
      return index.template bits<kRayBits<C> - 1, 0>();
    }
  }
  static uint<2> word_of(RepeatCount<C> index) {
    if constexpr (kHasPort<C>) {
      return uint<2>::from((index + ray_of(index)).raw());  // less three times the ray, modulo 4
    } else {
      return index.template bits<kRayBits<C> + 1, kRayBits<C>>();
    }
  }
  /// Pixels from a row to the next.
  static uint<11> pitch_of(const FrameRegisters<C>& config) {
    const uint<11> width = config.width.template trunc<11>();
    if constexpr (kHasPort<C>) {
      const auto more = (width + uint<2>(kPitchStep - 1)).template trunc<11>();
      return hls::concat(more.template bits<10, 2>(), uint<2>(0));
    } else {
      return width;
    }
  }
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

  static_assert(kHasPort<C> || C::kPixelBits == 32, "a bank's word holds one pixel");
  [[no_unique_address]] std::conditional_t<kHasPort<C>, FrameGather<C>, hls::Absent> gather_;
};

}  // namespace dynrt
