// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/counts/packet_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <utility>

#include "host/memory/triangle_matrix.h"
#include "host/tree/grid.h"

namespace dynrt::host {

namespace {

constexpr Grid kGrid;

/// The core has no zero: neither has this.
double not_zero(double x) {
  return std::abs(x) < kGrid.smallest() ? std::copysign(kGrid.smallest(), x) : x;
}
glm::dvec3 not_zero(const glm::dvec3& v) { return {not_zero(v.x), not_zero(v.y), not_zero(v.z)}; }

template <std::size_t kRays>
void update(unsigned mask, std::array<double, kRays>& bound,
            const std::array<double, kRays>& plane) {
  for (std::size_t i = 0; i < kRays; ++i) {
    if (mask >> i & 1) bound[i] = plane[i];
  }
}

}  // namespace

void TracerMailbox::clear() {
  items_.clear();
  oldest_ = 0;
}

bool TracerMailbox::seen(std::uint32_t item, unsigned slots, bool keeps_latest) {
  if (std::find(items_.begin(), items_.end(), item) != items_.end()) return true;
  if (items_.size() < slots) {
    items_.push_back(item);
  } else if (keeps_latest && slots > 0) {
    items_[oldest_] = item;
    oldest_ = (oldest_ + 1) % slots;
  }
  return false;
}

template <int kRays>
void PacketTracer<kRays>::rows(unsigned y, unsigned width, unsigned height) {
  for (unsigned x = 0; x < width; x += kSide) packet(x, y, width, height);
}

template <int kRays>
void PacketTracer<kRays>::packet(unsigned x, unsigned y, unsigned width, unsigned height) {
  const Camera& camera = scene_.camera;
  Rays rays;
  for (int i = 0; i < kRays; ++i) {
    const double px = (x + static_cast<unsigned>(i & 1) + 0.5) / width - 0.5;
    const double py = 0.5 - (y + static_cast<unsigned>(i >> 1) + 0.5) / height;
    rays[i] = {not_zero(camera.position),
               not_zero(px * camera.right + py * camera.up + camera.forward)};
  }
  hit_.fill({});
  distance_.fill(kGrid.largest());
  objects_seen_.clear();
  ++work_.packets;
  const TraceOptions& options = scene_.options;
  const auto enter = [&](std::uint32_t instance) {
    if (objects_seen_.seen(instance, options.object_slots, options.keeps_latest)) return;
    ++work_.objects;
    object(instance, rays);
  };
  const Tree& top = scene_.top.tree;
  if (top.main_leaf != kNullNode) enter(top.items[top.nodes[top.main_leaf].left]);
  if (scene_.top_start != kNullNode) {
    traverse(top, scene_.top_start, rays, true, enter);
  }
  for (int i = 0; i < kRays; ++i) {
    const std::size_t pixel =
        std::size_t{y + static_cast<unsigned>(i >> 1)} * width + x + static_cast<unsigned>(i & 1);
    hits_[pixel] = hit_[i];
    work_.hits += hit_[i].hit;
  }
}

/// All rays of the packet enter: one that reaches the instance in another leaf finds it in the
/// mailbox there.
template <int kRays>
void PacketTracer<kRays>::object(std::uint32_t instance, const Rays& world) {
  const glm::dmat4& m = scene_.to_object[instance];
  const std::uint32_t object = scene_.scene.instances[instance].object;
  Rays rays;
  for (int i = 0; i < kRays; ++i) {
    rays[i] = {not_zero(glm::dvec3(m * glm::dvec4(world[i].origin, 1.0))),
               not_zero(glm::dmat3(m) * world[i].direction)};
  }
  triangles_seen_.clear();
  const TraceOptions& options = scene_.options;
  traverse(scene_.objects[object], scene_.object_start[instance], rays, false,
           [&](std::uint32_t item) {
             if (triangles_seen_.seen(item, options.triangle_slots, options.keeps_latest)) return;
             ++work_.triangles;
             intersect(instance, item, scene_.triangles[object][item], rays);
           });
}

template <int kRays>
void PacketTracer<kRays>::intersect(std::uint32_t instance, std::uint32_t triangle,
                                    const glm::dmat4x3& matrix, const Rays& rays) {
  const Mesh& mesh = scene_.scene.objects[scene_.scene.instances[instance].object];
  for (int i = 0; i < kRays; ++i) {
    const glm::dvec3 o = matrix * glm::dvec4(rays[i].origin, 1.0);
    const glm::dvec3 d = matrix * glm::dvec4(rays[i].direction, 0.0);
    double t = -o.z / d.z;
    const double u = t * d.x + o.x;
    const double v = t * d.y + o.y;
    bool inside = u >= 0 && v >= 0 && (mesh.is_rectangle(triangle) ? u <= 1 && v <= 1 : u + v <= 1);
    if (mesh.is_ellipsoid(triangle)) {
      const auto [first, second] = sphere_hits(o, d);
      t = first > 0 ? first : second;
      inside = true;
    }
    if (t > 0 && t < distance_[i] && inside) {
      distance_[i] = t;
      hit_[i] = {true, t, u, v, instance, triangle};
    }
  }
}

template <int kRays>
template <class Visit>
void PacketTracer<kRays>::traverse(const Tree& tree, std::uint32_t start, const Rays& rays,
                                   bool top, Visit&& visit) {
  constexpr Mask kAll = (1u << kRays) - 1;
  Walk walk{.tree = tree,
            .rays = rays,
            .top = top,
            .index = start,
            .active = kAll,
            .alive = kAll,
            .near = {},
            .far = {}};
  walk.near.fill(kGrid.smallest());
  for (int i = 0; i < kRays; ++i) walk.far[i] = top ? kGrid.largest() : distance_[i];
  bool below = true;
  for (bool first = true; below || pop(walk); first = false) {
    if (!first) end_rays(walk);
    const TreeNode& node = tree.nodes[walk.index];
    if (top && !scene_.top.inner.empty() && walk.active != 0) {
      const std::vector<std::uint32_t>& inner = scene_.top.inner[walk.index];
      work_.list_entries += inner.size();
      for (const std::uint32_t item : inner) visit(item);
    }
    below = !node.is_leaf() && step(walk, node);
    if (!node.is_leaf()) continue;
    ++work_.leaf_fetches;
    if (walk.active == 0) continue;
    work_.list_entries += node.right;
    for (std::uint32_t i = 0; i < node.right; ++i) visit(tree.items[node.left + i]);
  }
}

/// Rays end whose hit is nearer than the node.
template <int kRays>
void PacketTracer<kRays>::end_rays(Walk& walk) const {
  Mask ended = 0;
  for (int i = 0; i < kRays; ++i) {
    if ((walk.active >> i & 1) && distance_[i] < walk.near[i]) ended |= 1u << i;
  }
  walk.alive &= ~ended;
  walk.active &= ~ended;
}

template <int kRays>
typename PacketTracer<kRays>::Sides PacketTracer<kRays>::sides_of(const Walk& walk,
                                                                  const TreeNode& node) const {
  Sides sides;
  for (int i = 0; i < kRays; ++i) {
    const double offset = not_zero(node.split - walk.rays[i].origin[node.axis]);
    const double d = not_zero(offset / walk.rays[i].direction[node.axis]);
    const bool go_near = d >= walk.near[i] || d <= 0;
    const bool go_far = d <= walk.far[i] && d >= 0;
    const bool left_first = offset >= 0;
    sides.plane[i] = d;
    if (!(walk.active >> i & 1)) continue;
    sides.left_first |= static_cast<Mask>(left_first) << i;
    sides.left |= static_cast<Mask>(left_first ? go_near : go_far) << i;
    sides.right |= static_cast<Mask>(left_first ? go_far : go_near) << i;
  }
  return sides;
}

template <int kRays>
bool PacketTracer<kRays>::step(Walk& walk, const TreeNode& node) {
  const bool clipping = walk.index < walk.tree.root;
  if (!(clipping && !walk.top && scene_.options.object_clip_free)) {
    ++(walk.top ? work_.top_steps : work_.object_steps);
  }
  const Sides sides = sides_of(walk, node);
  const Mask both = sides.left & sides.right;
  const Mask deciding = both != 0 ? both : walk.active;
  std::pair near{node.right, sides.right}, far{node.left, sides.left};
  if ((sides.left_first & deciding & (~deciding + 1)) != 0) std::swap(near, far);
  const auto [near_node, near_mask] = near;
  const auto [far_node, far_mask] = far;
  if (near_mask != 0 && near_node != kNullNode) {
    if (far_mask != 0) push(walk, far_node, far_mask, both, clipping);
    update(both, walk.far, sides.plane);
    walk.index = near_node;
    walk.active = near_mask;
    return true;
  }
  if (near_mask != 0 && !clipping) ++work_.empty_leaves;
  if (far_mask == 0 || far_node == kNullNode) return false;
  update(both, walk.near, sides.plane);
  walk.index = far_node;
  walk.active = far_mask;
  return true;
}

template <int kRays>
void PacketTracer<kRays>::push(Walk& walk, std::uint32_t node, Mask active, Mask both,
                               bool clipping) {
  const bool real = node != kNullNode;
  if (real && walk.real_entries == scene_.options.stack_depth) {
    ++work_.dropped_pushes;
  } else if (real || !clipping) {
    walk.stack.push_back({node, active, both, walk.far});
    walk.real_entries += real;
  }
  work_.deepest_stack = std::max(work_.deepest_stack, walk.real_entries);
}

template <int kRays>
bool PacketTracer<kRays>::pop(Walk& walk) {
  do {
    drop_empty_children(walk);
    if (walk.stack.empty() || walk.alive == 0) return false;
    const Entry entry = walk.stack.back();
    walk.stack.pop_back();
    --walk.real_entries;
    walk.active = entry.active & walk.alive;
    for (int i = 0; i < kRays; ++i) {
      if (!(entry.both >> i & 1)) continue;
      walk.near[i] = walk.far[i];
      walk.far[i] = entry.far[i];
    }
    walk.index = entry.node;
  } while (walk.active == 0);
  return true;
}

/// The core's stack holds no empty children: those here only count nodes that were not
/// fetched.
template <int kRays>
void PacketTracer<kRays>::drop_empty_children(Walk& walk) {
  while (!walk.stack.empty() && walk.stack.back().node == kNullNode) {
    const Mask still = walk.stack.back().active & walk.alive;
    bool wanted = false;
    for (int i = 0; i < kRays; ++i) {
      wanted = wanted || ((still >> i & 1) && !(distance_[i] < walk.far[i]));
    }
    work_.empty_leaves += wanted;
    walk.stack.pop_back();
  }
}

template class PacketTracer<1>;
template class PacketTracer<4>;

}  // namespace dynrt::host
