// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/full_picture.h"

#include <algorithm>
#include <utility>

namespace dynrt::host {

std::optional<PrimitiveId> FullPicture::primitive_at(std::size_t pixel) const {
  const HitRecord& hit = frame.hits[pixel];
  if (!hit.hit) return std::nullopt;
  return owners.of(hit.object, hit.triangle);
}

const PacketWork* FullPicture::packet_at(unsigned x, unsigned y) const {
  if (!watch) return nullptr;
  return &watch->packets[packet_of[index(x, y)]];
}

void FullPicture::keep(FrameWatch seen, Frame rendered) {
  watch = std::move(seen);
  watched = std::move(rendered);
  packet_of.assign(frame.pixels.size(), 0);
  for (std::uint32_t p = 0; p < watch->packets.size(); ++p) {
    const PacketWork& packet = watch->packets[p];
    const unsigned right = std::min(packet.x + watch->columns, request.width);
    const unsigned below = std::min(packet.y + watch->rows, request.height);
    for (unsigned y = packet.y; y < below; ++y) {
      for (unsigned x = packet.x; x < right; ++x) packet_of[index(x, y)] = p;
    }
  }
}

}  // namespace dynrt::host
