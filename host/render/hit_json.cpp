// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/hit_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

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

std::string hit_table(const Frame& frame) {
  const MemoryFormat& format = *frame.core.format;
  std::string text = fmt::format("{}\n", fmt::join(kHitColumns, ","));
  for (unsigned y = 0; y < frame.height; ++y) {
    for (unsigned x = 0; x < frame.width; ++x) {
      const std::size_t pixel = std::size_t{y} * frame.width + x;
      const HitRecord& hit = frame.hits.at(pixel);
      fmt::format_to(std::back_inserter(text), "{},{},{:d},{},{},{},{},{},{},{}\n", x, y, hit.hit,
                     hit.object, hit.triangle, format.number(hit.t), format.number(hit.u),
                     format.number(hit.v), format.number(hit.cosine),
                     colour_text(frame.pixels[pixel]));
    }
  }
  return text;
}

}  // namespace dynrt::host
