// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Walks packets of primary rays through both levels of a scene as the core does (thesis 3.1.3: the
// packet decides together, rays end where a hit is nearer, mailboxes drop items that were met
// before), in doubles, and counts the work. counts.h says what differs from the core.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/analysis/counts/traced_scene.h"

namespace dynrt::host {

/// Items that a packet has met. Slots fill in order; once full they stay as they are, or the oldest
/// is replaced.
class TracerMailbox {
 public:
  void clear();
  /// Whether the item is in a slot; puts it there if it is not.
  bool seen(std::uint32_t item, unsigned slots, bool keeps_latest);

 private:
  std::vector<std::uint32_t> items_;
  std::size_t oldest_ = 0;
};

/// Packets of kRays rays: one ray, or 2x2.
template <int kRays>
class PacketTracer {
 public:
  /// Hits are written where their pixels are numbered.
  PacketTracer(const TracedScene& scene, std::span<TracedHit> hits) : scene_(scene), hits_(hits) {}

  static constexpr unsigned kSide = kRays == 1 ? 1 : 2;

  /// Rows y to y + kSide of an image.
  void rows(unsigned y, unsigned width, unsigned height);

  const WorkCounts& work() const { return work_; }

 private:
  using Mask = unsigned;  ///< a bit for each ray
  using Distances = std::array<double, kRays>;

  struct Ray {
    glm::dvec3 origin, direction;
  };
  using Rays = std::array<Ray, kRays>;

  /// A child that the packet comes to later.
  struct Entry {
    std::uint32_t node;
    Mask active, both;
    Distances far;
  };
  /// The packet on its way through one tree.
  struct Walk {
    const Tree& tree;
    const Rays& rays;
    bool top;  ///< the tree is that of the instances
    std::uint32_t index;
    Mask active, alive;  ///< rays that are in this node; that have not ended
    Distances near, far;
    std::vector<Entry> stack{};
    int real_entries = 0;  ///< of the stack, without empty children, which the core's has not
  };
  /// What the rays do at a node's plane.
  struct Sides {
    Mask left = 0, right = 0, left_first = 0;
    Distances plane{};
  };

  void packet(unsigned x, unsigned y, unsigned width, unsigned height);
  void object(std::uint32_t instance, const Rays& world);
  void intersect(std::uint32_t instance, std::uint32_t triangle, const glm::dmat4x3& matrix,
                 const Rays& rays);

  template <class Visit>
  void traverse(const Tree& tree, std::uint32_t start, const Rays& rays, bool top, Visit&& visit);
  void end_rays(Walk& walk) const;
  Sides sides_of(const Walk& walk, const TreeNode& node) const;
  /// Goes on to a child; false where no ray enters one.
  bool step(Walk& walk, const TreeNode& node);
  void push(Walk& walk, std::uint32_t node, Mask active, Mask both, bool clipping);
  /// Takes the next child from the stack; false at the end of the walk.
  bool pop(Walk& walk);
  void drop_empty_children(Walk& walk);

  const TracedScene& scene_;
  std::span<TracedHit> hits_;
  std::array<TracedHit, kRays> hit_;
  Distances distance_;
  TracerMailbox objects_seen_, triangles_seen_;
  WorkCounts work_;
};

extern template class PacketTracer<1>;
extern template class PacketTracer<4>;

}  // namespace dynrt::host
