// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The full picture in the window, with all that the program knows of it: the hit records; the paths
// of the packets and the work of the units, once the frame was watched; the true hits, once
// somebody has asked for them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/layout/matrix_owners.h"
#include "host/view/message.h"
#include "host/view/view_truth.h"
#include "units/frame_watch.h"

namespace dynrt::host {

struct FullPicture {
  unsigned number = 0;  ///< of the full pictures since the program began
  PictureRequest request;
  Camera camera;  ///< in the core's space
  FrameImage image;
  Frame frame;
  MatrixOwners owners;
  std::shared_ptr<const ViewTruth> truth{};
  /// Of the same frame, once it was watched. Its clocks are known if the units' schedules are.
  std::optional<FrameWatch> watch{};
  std::optional<Frame> watched{};
  std::vector<std::uint32_t> packet_of{};  ///< by pixel, a place in watch->packets

  std::size_t index(unsigned x, unsigned y) const { return std::size_t{y} * request.width + x; }
  std::optional<PrimitiveId> primitive_at(std::size_t pixel) const;
  /// The work of the packet of a pixel; null if the frame was not watched.
  const PacketWork* packet_at(unsigned x, unsigned y) const;
  void keep(FrameWatch seen, Frame rendered);
};

}  // namespace dynrt::host
