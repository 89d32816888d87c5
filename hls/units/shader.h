// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shader: turns the hits of a packet's rays into colour and decides which rays follow (thesis 6.2):
// first the primary rays, then light rays from every light to the hits, then reflected rays, and so
// on. A ray is shaded on a clock.
//
// A surface's colour times ambient light and the cosine with the arriving ray, and for every light
// that is seen, the light's colour and intensity times cosine over distance: with d from the light
// to the surface, |n . d| / (d . d). It is lit on the side only from which it is seen. A mirror
// adds its share of the light that the reflected ray brings, and keeps the rest.
#pragma once

#include "units/colour.h"
#include "units/frame.h"
#include "units/light_columns.h"
#include "units/packet_rays.h"
#include "units/repeated.h"
#include "units/send_packet.h"
#include "units/shading_tokens.h"

namespace dynrt {

template <class C>
struct Shader {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  using Sum = uint<12>;  ///< a channel's sum in sixteenths
  /// The state of a ray's pixel.
  struct Pixel {
    std::array<Sum, 3> sum;
    SurfaceColour<C> colour;  ///< of the surface hit last
    bool towards = false;     ///< the sign of its cosine
    Brightness diffuse;       ///< how much of that surface's light reaches the eye
    hls::OptionalField<kHasMirrors<C>, Brightness> mirror;  ///< share of it that is reflected
    HLS_FIELDS(sum, colour, towards, diffuse, mirror)
  };

  hls::In<Repeated<ShadeJob<C>>> job;
  hls::Config<FrameRegisters<C>> frame;
  hls::RamRead<Found<C>, kRayRows<C>> found;
  hls::RamWrite<SurfacePoint<C>, kRayRows<C>> surface;
  hls::RamWrite<uint<24>, kRayRows<C>> pixel_colour;
  hls::OptionalPort<kHasLights<C>, hls::RamRead<LightPower<C>, kPackets>> light;
  hls::OptionalPort<kHasLights<C>, hls::RamRead<Vector<Real>, kVectorRows<C>>> vectors;
  hls::RamRead<RayMask<C>, kPackets>
      traced;  ///< of rays that are not primary, those that were traced
  hls::Out<DerivationEvent<C>> derive;
  hls::Ram1R1W<Pixel, kRayRows<C>> pixels;
  HLS_PORTS(job, frame, found, surface, pixel_colour, light, vectors, traced, derive)

  void step() {
    const Repeated<ShadeJob<C>> j = job.read();
    const FrameRegisters<C> config = frame.get();
    const PacketId<C> packet = j.job.packet;
    const RayIndex<C> ray = j.index.template trunc<kRayBits<C>>();
    const RayRow<C> row = ray_row<C>(packet, ray);
    const Found<C> f = found.read(row);
    Pixel pixel = pixels.read(row);

    const RayKind kind = j.job.kind.get();
    const bool primary = kind == RayKind::kPrimary;
    const bool light_ray = kHasLights<C> && kind == RayKind::kLight;
    const bool mine = primary || traced.read(packet).bit(static_cast<unsigned>(ray.raw()));
    bool surface_hit = false;
    bool mirrors = false;
    const Brightness weight = primary ? Brightness(256) : pixel.mirror.get();

    if (primary) pixel = Pixel{};
    if (light_ray) {
      if constexpr (kHasLights<C>) {
        const LightPower<C> power = light.read(packet);
        const Vector<Real> d =
            vectors.read(vector_row<C>(level_row<C>(Level{}, packet), ray, false));
        const Real square = (d.x * d.x + d.y * d.y) + d.z * d.z;
        const Brightness bright = in_256ths(power.intensity * (f.cosine / square));
        const bool seen = mine && !f.hit && f.cosine.sign() == pixel.towards;
        add(pixel, light_on(surface_colour<C>(pixel.colour, config), power.colour),
            seen ? product(bright, pixel.diffuse) : Brightness(0));
      }
    } else if (mine) {
      const Brightness mirror = f.mirror.get().template zext<9>();
      const Brightness kept = Brightness::from(256 - mirror.raw());
      if (f.hit) {
        pixel.colour = f.colour;
        pixel.towards = f.cosine.sign();
        pixel.diffuse = product(weight, kept);
        pixel.mirror = product(weight, mirror);
        surface.write(row, SurfacePoint<C>{f.t, f.object, f.triangle});
        surface_hit = true;
        mirrors = kHasMirrors<C> && mirror != Brightness(0);
      }
      const Brightness ambient = product(in_256ths(f.cosine), config.ambient.template trunc<9>());
      add(pixel,
          f.hit ? surface_colour<C>(f.colour, config) : config.background.template trunc<24>(),
          f.hit ? product(ambient, pixel.diffuse) : weight);
    }
    pixels.write(row, pixel);
    pixel_colour.write(row, hls::concat(pixel.sum[2].template bits<11, 4>(),
                                        hls::concat(pixel.sum[1].template bits<11, 4>(),
                                                    pixel.sum[0].template bits<11, 4>())));

    surfaces_ = with_next_ray(surfaces_, surface_hit);
    mirrors_ = with_next_ray(mirrors_, mirrors);
    if (j.last) derive.write(DerivationEvent<C>{packet, true, kind, surfaces_, mirrors_});
  }

 private:
  static void add(Pixel& pixel, uint<24> colour, Brightness brightness) {
    for (unsigned i = 0; i < 3; ++i) {
      const auto more = (channel(colour, i) * brightness).template bits<16, 4>();
      const auto sum = pixel.sum[i] + more;
      const bool over = sum.template bits<13, 12>() != uint<2>(0);
      pixel.sum[i] = over ? Sum::ones() : sum.template trunc<12>();
    }
  }
  /// The light that the surface reflects: the product of their channels.
  static uint<24> light_on(uint<24> colour, uint<24> light_colour) {
    uint<8> result[3];
    for (unsigned i = 0; i < 3; ++i) {
      // 255 of 255 is all of it.
      const uint<8> c = channel(light_colour, i);
      result[i] = scaled(channel(colour, i), (c + c.template bits<7, 7>()));
    }
    return hls::concat(result[2], hls::concat(result[1], result[0]));
  }

  RayMask<C> surfaces_;  ///< of the packet, whose rays come one after the other
  RayMask<C> mirrors_;
};

}  // namespace dynrt
