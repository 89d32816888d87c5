// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shading: the eye light of the thesis's prototype (chapter 7): the triangle's colour times the
// scalar product of ray direction and normal, at most one. It takes four clocks a ray, in which it
// writes the pixel to bank 3 and, if asked, the hit record to banks 4 and 5; after a packet's last
// ray the packet is free.
#pragma once

#include "units/collect_hits.h"
#include "units/frame.h"
#include "units/ray_generation.h"
#include "units/tokens.h"

namespace dynrt {

template <class C>
struct Shading {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  using BankAddress = uint<20>;

  hls::In<Repeated<ShadeJob<C>>> job;
  hls::Config<FrameConfig> frame;
  hls::Out<FreePacket<C>> free;
  hls::RamRead<HitRecord<C>, 4 * kPackets> hit;
  hls::RamRead<PixelPosition, kPackets> position;
  hls::RamWrite<Word, kBankWords> bank[3];  ///< banks 3, 4 and 5 of the board
  HLS_PORTS(job, frame, free, hit, position, bank[0], bank[1], bank[2])

  void step() {
    const Repeated<ShadeJob<C>> j = job.read();
    const FrameConfig config = frame.get();
    const RayIndex ray = j.index.template bits<3, 2>();
    const uint<2> word = j.index.template bits<1, 0>();
    const HitRecord<C> h = hit.read(hls::concat(j.job.packet, ray));
    const PixelPosition p = position.read(j.job.packet);

    const uint<10> x = p.x | ray.template bits<0, 0>().template zext<10>();
    const uint<10> y = p.y | ray.template bits<1, 1>().template zext<10>();
    const bool inside = x.template zext<11>() < config.width.template trunc<11>() &&
                        y.template zext<11>() < config.height.template trunc<11>();
    const BankAddress pixel = BankAddress::from((y * config.width.template trunc<11>() + x).raw());

    if (inside && word == uint<2>(0)) {
      bank[0].write(BankAddress::from((pixel + config.frame_base.template trunc<20>()).raw()),
                    shade(h, config));
    }
    if (inside && word != uint<2>(3) && config.write_hits.template bit<0>()) {
      const BankAddress at = BankAddress::from((pixel + pixel.template shl<1>() + word).raw());
      bank[1].write(at, hit_word(HitPlace{h.t.bits(), h.v.bits(), h.object, 0, h.hit}, word));
      bank[2].write(at, hit_word(HitSurface{h.u.bits(), h.cosine.bits(), h.triangle, 0}, word));
    }
    if (j.last) free.write({j.job.packet});
  }

 private:
  template <class Words>
  static Word hit_word(const Words& words, uint<2> index) {
    return index == uint<2>(0)   ? hls::word_of<0>(words)
           : index == uint<2>(1) ? hls::word_of<1>(words)
                                 : hls::word_of<2>(words);
  }
  /// 0x00BBGGRR: each channel of the colour times the brightness, rounded down.
  static Word shade(const HitRecord<C>& h, const FrameConfig& config) {
    const uint<9> brightness = in_256ths(h.cosine);
    const uint<8> red = scaled(h.colour.template bits<7, 0>(), brightness);
    const uint<8> green = scaled(h.colour.template bits<15, 8>(), brightness);
    const uint<8> blue = scaled(h.colour.template bits<23, 16>(), brightness);
    return h.hit ? Word(hls::concat(blue, hls::concat(green, red))) : config.background;
  }
  /// min(|value|, 1) in units of 1/256, rounded down.
  static uint<9> in_256ths(Real value) {
    constexpr unsigned kMantissa = Real::kMantissaBits;
    const auto exponent = value.exponent();
    constexpr auto kOne = Real::from_double(1.0).exponent();
    if (!(exponent < kOne)) return 256;
    const auto significand = hls::concat(uint<1>(1), value.mantissa());
    const auto eighths = significand.template bits<kMantissa, kMantissa - 8>();
    return eighths >> (kOne - exponent).as_unsigned();
  }
  static uint<8> scaled(uint<8> channel, uint<9> brightness) {
    return (channel * brightness).template bits<15, 8>();
  }
};

}  // namespace dynrt
