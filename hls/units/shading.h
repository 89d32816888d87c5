// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shading: the eye light of the thesis's prototype (chapter 7): the triangle's colour times the
// scalar product of ray direction and normal, at most one; or, where there are light or reflection
// rays, the colour that the shader has found. It takes three clocks a ray: if asked, it writes the
// hit records of the primary rays to banks 4 and 5, three words to each, first those of all rays,
// then the second, then the third. In the first two rounds it writes the pixels of every second ray
// to bank 3, so that the bank has a clock for the display between two pixels. After a packet's last
// step the packet is free. Where pipelines share the banks, frame_writer.h has the writes.
#pragma once

#include <type_traits>

#include "units/colour.h"
#include "units/frame.h"
#include "units/frame_writer.h"
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
  using BankAddress = uint<20>;

  hls::In<Repeated<ShadeJob<C>>> job;
  hls::Config<FrameRegisters<C>> frame;
  hls::OptionalPort<!kHasPipelines<C>, hls::Out<FreePacket<C>>> free;
  hls::RamRead<HitRecord<C>, kRayRows<C>> hit;
  hls::RamRead<PixelPosition, kPackets> position;
  std::conditional_t<kHasPipelines<C>, hls::Absent, OutBank[3]> bank;
  hls::OptionalPort<kHasSecondary<C>, hls::RamRead<uint<24>, kRayRows<C>>> pixel_colour;
  hls::OptionalPort<kHasPipelines<C>, hls::Out<FrameWrite<C>>> write;
  hls::OptionalPort<kHasPipelines<C>, hls::Config<PipelineId<C>>> pipeline;
  HLS_PORTS(job, frame, free, hit, position, bank, pixel_colour, write, pipeline)

  void step() {
    const Repeated<ShadeJob<C>> j = job.read();
    const FrameRegisters<C> config = frame.get();
    const RayIndex<C> ray = j.index.template bits<kRayBits<C> - 1, 0>();
    const uint<2> word = j.index.template bits<kRayBits<C> + 1, kRayBits<C>>();
    const HitRecord<C> h = hit.read(ray_row<C>(j.job.packet, ray));
    const PixelPosition p = pixel_of<C>(position.read(j.job.packet), ray);

    const bool inside = p.x.template zext<11>() < config.width.template trunc<11>() &&
                        p.y.template zext<11>() < config.height.template trunc<11>();
    const BankAddress pixel =
        BankAddress::from((p.y * config.width.template trunc<11>() + p.x).raw());

    Word colour;
    if constexpr (kHasSecondary<C>) {
      colour = pixel_colour.read(ray_row<C>(j.job.packet, ray));
    } else {
      colour = h.hit ? Word(eye_light(surface_colour<C>(h.colour, config), in_256ths(h.cosine)))
                     : config.background;
    }
    Step step;
    if (inside && word == ray.template bits<0, 0>().template zext<2>()) {
      put_pixel(step, BankAddress::from((pixel + config.frame_base.template trunc<20>()).raw()),
                colour);
    }
    if (inside && config.write_hits.template bit<0>()) {
      const BankAddress at = BankAddress::from((pixel + pixel.template shl<1>() + word).raw());
      put_place(step, at,
                hit_word(HitPlace{h.t.bits(), h.v.bits(), object_of(h, config), 0, h.hit}, word));
      put_surface(step, at, hit_word(HitSurface{h.u.bits(), h.cosine.bits(), h.triangle, 0}, word));
    }
    end(step, j.job.packet, j.last);
  }

 private:
  /// What a step writes, where another unit writes it to the banks.
  using Step = std::conditional_t<kHasPipelines<C>, FrameWrite<C>, hls::Absent>;

  void put_pixel(Step& step, BankAddress at, Word colour) {
    if constexpr (kHasPipelines<C>) {
      step.has_pixel = true;
      step.pixel = at;
      step.colour = colour;
    } else {
      bank[0].write(at, colour);
    }
  }
  void put_place(Step& step, BankAddress at, Word place) {
    if constexpr (kHasPipelines<C>) {
      step.has_hit = true;
      step.hit = at;
      step.place = place;
    } else {
      bank[1].write(at, place);
    }
  }
  void put_surface(Step& step, BankAddress at, Word surface) {
    if constexpr (kHasPipelines<C>) {
      step.surface = surface;
    } else {
      bank[2].write(at, surface);
    }
  }
  void end(Step& step, PacketId<C> packet, bool last) {
    if constexpr (kHasPipelines<C>) {
      step.last = last;
      step.packet = {packet, pipeline.get()};
      if (step.has_pixel || step.has_hit || last) write.write(step);
    } else if (last) {
      free.write({packet});
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
};

}  // namespace dynrt
