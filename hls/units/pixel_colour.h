// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The colour of a ray's pixel, as the shading gets it: from the eye light of the thesis's prototype
// (chapter 7), the surface's colour times the scalar product of ray direction and normal, at most
// one; or from the shader, where there are light or reflection rays (6.2).
#pragma once

#include "units/colour.h"
#include "units/frame.h"
#include "units/intersection_tokens.h"

namespace dynrt {

template <class C>
struct EyeLight {
  HLS_NO_PORTS
  static Word colour_of(const HitRecord<C>& h, RayRow<C> /*ray*/, const FrameRegisters<C>& config) {
    return h.hit ? Word(eye_light(surface_colour<C>(h.colour, config), in_256ths(h.cosine)))
                 : config.background;
  }
};

template <class C>
struct ColourOfShader {
  hls::RamRead<uint<24>, kRayRows<C>> pixel_colour;
  HLS_PORTS(pixel_colour)
  Word colour_of(const HitRecord<C>& /*hit*/, RayRow<C> ray, const FrameRegisters<C>&) const {
    return pixel_colour.read(ray);
  }
};

template <class C>
using PixelColour = std::conditional_t<kHasSecondary<C>, ColourOfShader<C>, EyeLight<C>>;

}  // namespace dynrt
