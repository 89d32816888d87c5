// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/hit_json.h"

#include <fmt/format.h>

namespace dynrt::host {

using Json = nlohmann::ordered_json;

namespace {

Json number_json(const MemoryFormat& format, std::uint32_t bits) {
  return {{"bits", fmt::format("{:#x}", bits)}, {"value", format.number(bits)}};
}

}  // namespace

std::string colour_text(std::uint32_t pixel) {
  return fmt::format("#{:02x}{:02x}{:02x}", pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255);
}

Json hit_json(const Frame& frame, unsigned x, unsigned y) {
  const std::size_t pixel = std::size_t{y} * frame.width + x;
  const HitRecord& hit = frame.hits.at(pixel);
  const MemoryFormat& format = *frame.core.format;
  return {{"x", x},
          {"y", y},
          {"colour", colour_text(frame.pixels[pixel])},
          {"hit", hit.hit},
          {"object", hit.object},
          {"triangle", hit.triangle},
          {"t", number_json(format, hit.t)},
          {"u", number_json(format, hit.u)},
          {"v", number_json(format, hit.v)},
          {"cosine", number_json(format, hit.cosine)}};
}

}  // namespace dynrt::host
