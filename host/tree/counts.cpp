// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/counts.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/tree/grid.h"
#include "host/tree/triangle_matrix.h"

namespace dynrt::host {

std::uint64_t WorkCounts::bound() const {
  return std::max({steps() + leaf_fetches, 5 * (triangles + objects + packets), list_entries});
}

namespace {

constexpr int kRays = 4;
using Mask = unsigned;
const glm::dmat4x3 kNoMatrix(std::nan(""));

struct Ray {
  glm::dvec3 origin, direction;
};

/// The core has no zero: neither has this.
double not_zero(double x) {
  return std::abs(x) < grid_smallest() ? std::copysign(grid_smallest(), x) : x;
}
glm::dvec3 not_zero(const glm::dvec3& v) { return {not_zero(v.x), not_zero(v.y), not_zero(v.z)}; }

/// Slots fill in order and are never replaced.
class Mailbox {
 public:
  void clear() { slots_.clear(); }
  bool seen(std::uint32_t item, unsigned slots) {
    if (std::find(slots_.begin(), slots_.end(), item) != slots_.end()) return true;
    if (slots_.size() < slots) slots_.push_back(item);
    return false;
  }

 private:
  std::vector<std::uint32_t> slots_;
};

class Tracer {
 public:
  Tracer(const Scene& scene, const SceneTrees& trees, const Camera& camera,
         const TraceOptions& options)
      : scene_(scene), trees_(trees), camera_(camera), options_(options) {
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
      const Mesh& mesh = scene.objects[k];
      std::vector<glm::dmat4x3>& matrices = triangles_.emplace_back();
      for (std::size_t i = 0; i < mesh.primitives(); ++i) {
        matrices.push_back(mesh.is_ellipsoid(i)
                               ? ellipsoid_matrix(mesh.ellipsoid(i)).matrix
                               : triangle_matrix(mesh.corners(i)).value_or(kNoMatrix));
      }
    }
    for (const Instance& instance : scene.instances) {
      const glm::dmat4 inverse = glm::inverse(instance.transform);
      to_object_.push_back(inverse);
      const Tree& tree = trees.objects[instance.object];
      object_start_.push_back(start(tree, glm::dvec3(inverse * glm::dvec4(camera.position, 1.0))));
    }
    top_start_ = start(trees.instances, camera.position);
  }

  TracedFrame run(unsigned width, unsigned height) {
    frame_.hits.resize(std::size_t{width} * height);
    for (unsigned y = 0; y < height; y += 2) {
      for (unsigned x = 0; x < width; x += 2) packet(x, y, width, height);
    }
    return std::move(frame_);
  }

 private:
  struct Entry {
    std::uint32_t node;
    Mask active, both;
    std::array<double, kRays> far;
  };

  std::uint32_t start(const Tree& tree, const glm::dvec3& origin) const {
    return options_.always_clip ? tree.clipped_root : tree.entry(origin);
  }

  void packet(unsigned x, unsigned y, unsigned width, unsigned height) {
    std::array<Ray, kRays> rays;
    for (int i = 0; i < kRays; ++i) {
      const double px = (x + static_cast<unsigned>(i & 1) + 0.5) / width - 0.5;
      const double py = 0.5 - (y + static_cast<unsigned>(i >> 1) + 0.5) / height;
      rays[i] = {not_zero(camera_.position),
                 not_zero(px * camera_.right + py * camera_.up + camera_.forward)};
    }
    hit_.fill({});
    distance_.fill(grid_largest());
    objects_seen_.clear();
    ++frame_.work.packets;
    traverse(trees_.instances, top_start_, rays, true, [&](std::uint32_t item) {
      if (objects_seen_.seen(item, options_.mailbox_slots)) return;
      ++frame_.work.objects;
      object(item, rays);
    });
    for (int i = 0; i < kRays; ++i) {
      const std::size_t pixel =
          std::size_t{y + static_cast<unsigned>(i >> 1)} * width + x + static_cast<unsigned>(i & 1);
      frame_.hits[pixel] = hit_[i];
      frame_.work.hits += hit_[i].hit;
    }
  }

  /// All rays of the packet enter: one that reaches the instance in another leaf finds it in the
  /// mailbox there.
  void object(std::uint32_t instance, const std::array<Ray, kRays>& world) {
    const glm::dmat4& m = to_object_[instance];
    const std::uint32_t object = scene_.instances[instance].object;
    std::array<Ray, kRays> rays;
    for (int i = 0; i < kRays; ++i) {
      rays[i] = {not_zero(glm::dvec3(m * glm::dvec4(world[i].origin, 1.0))),
                 not_zero(glm::dmat3(m) * world[i].direction)};
    }
    triangles_seen_.clear();
    traverse(trees_.objects[object], object_start_[instance], rays, false, [&](std::uint32_t item) {
      if (triangles_seen_.seen(item, options_.mailbox_slots)) return;
      ++frame_.work.triangles;
      intersect(instance, item, triangles_[object][item], rays);
    });
  }

  void intersect(std::uint32_t instance, std::uint32_t triangle, const glm::dmat4x3& m,
                 const std::array<Ray, kRays>& rays) {
    const Mesh& mesh = scene_.objects[scene_.instances[instance].object];
    for (int i = 0; i < kRays; ++i) {
      const glm::dvec3 o = m * glm::dvec4(rays[i].origin, 1.0);
      const glm::dvec3 d = m * glm::dvec4(rays[i].direction, 0.0);
      double t = -o.z / d.z;
      const double u = t * d.x + o.x;
      const double v = t * d.y + o.y;
      bool inside =
          u >= 0 && v >= 0 && (mesh.is_rectangle(triangle) ? u <= 1 && v <= 1 : u + v <= 1);
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

  template <class Visit>
  void traverse(const Tree& tree, std::uint32_t start, const std::array<Ray, kRays>& rays, bool top,
                Visit&& visit) {
    std::array<double, kRays> near, far, plane;
    near.fill(grid_smallest());
    for (int i = 0; i < kRays; ++i) far[i] = top ? grid_largest() : distance_[i];
    std::vector<Entry> stack;
    Mask active = 15;
    Mask alive = active;
    std::uint32_t index = start;
    int real_entries = 0;
    bool first = true;
    while (true) {
      const TreeNode& node = tree.nodes[index];
      Mask ended = 0;
      for (int i = 0; i < kRays; ++i) {
        if (!first && (active >> i & 1) && distance_[i] < near[i]) ended |= 1u << i;
      }
      first = false;
      alive &= ~ended;
      active &= ~ended;
      bool pop = true;
      if (node.is_leaf()) {
        ++frame_.work.leaf_fetches;
        if (active != 0) {
          frame_.work.list_entries += node.right;
          for (std::uint32_t i = 0; i < node.right; ++i) visit(tree.items[node.left + i]);
        }
      } else {
        const bool clipping = index < tree.root;
        if (!(clipping && !top && options_.object_clip_free)) {
          ++(top ? frame_.work.top_steps : frame_.work.object_steps);
        }
        Mask left = 0, right = 0, left_first = 0;
        for (int i = 0; i < kRays; ++i) {
          const double offset = node.split - rays[i].origin[node.axis];
          const double d = offset / rays[i].direction[node.axis];
          const bool go_near = d >= near[i] || d <= 0;
          const bool go_far = d <= far[i] && d >= 0;
          const bool is_left_first = offset >= 0;
          plane[i] = d;
          if (!(active >> i & 1)) continue;
          left_first |= static_cast<Mask>(is_left_first) << i;
          left |= static_cast<Mask>(is_left_first ? go_near : go_far) << i;
          right |= static_cast<Mask>(is_left_first ? go_far : go_near) << i;
        }
        const Mask both = left & right;
        const Mask deciding = both != 0 ? both : active;
        const bool left_is_near = (left_first & deciding & (~deciding + 1)) != 0;
        const std::uint32_t near_node = left_is_near ? node.left : node.right;
        const std::uint32_t far_node = left_is_near ? node.right : node.left;
        const Mask near_mask = left_is_near ? left : right;
        const Mask far_mask = left_is_near ? right : left;
        const bool enter_near = near_mask != 0 && near_node != kNullNode;
        const bool enter_far = far_mask != 0 && far_node != kNullNode;
        const bool clips = clipping;
        if (near_mask != 0 && near_node == kNullNode && !clips) ++frame_.work.empty_leaves;
        pop = !enter_near && !enter_far;
        if (enter_near) {
          if (far_mask != 0) {
            const bool real = far_node != kNullNode;
            if (real && real_entries == options_.stack_depth) {
              ++frame_.work.dropped_pushes;
            } else if (real || !clips) {
              stack.push_back({far_node, far_mask, both, far});
              real_entries += real;
            }
            frame_.work.deepest_stack = std::max(frame_.work.deepest_stack, real_entries);
          }
          update(both, far, plane);
          index = near_node;
          active = near_mask;
        } else if (enter_far) {
          update(both, near, plane);
          index = far_node;
          active = far_mask;
        }
      }
      while (pop) {
        // The core's stack holds no empty children: those here only count what was not fetched.
        while (!stack.empty() && stack.back().node == kNullNode) {
          const Mask still = stack.back().active & alive;
          bool wanted = false;
          for (int i = 0; i < kRays; ++i) {
            wanted = wanted || ((still >> i & 1) && !(distance_[i] < far[i]));
          }
          frame_.work.empty_leaves += wanted;
          stack.pop_back();
        }
        if (stack.empty() || alive == 0) return;
        const Entry entry = stack.back();
        stack.pop_back();
        --real_entries;
        active = entry.active & alive;
        for (int i = 0; i < kRays; ++i) {
          if (!(entry.both >> i & 1)) continue;
          near[i] = far[i];
          far[i] = entry.far[i];
        }
        index = entry.node;
        pop = active == 0;
      }
    }
  }

  static void update(Mask mask, std::array<double, kRays>& bound,
                     const std::array<double, kRays>& plane) {
    for (int i = 0; i < kRays; ++i) {
      if (mask >> i & 1) bound[i] = plane[i];
    }
  }

  const Scene& scene_;
  const SceneTrees& trees_;
  const Camera& camera_;
  const TraceOptions options_;
  std::vector<std::vector<glm::dmat4x3>> triangles_;
  std::vector<glm::dmat4> to_object_;
  std::vector<std::uint32_t> object_start_;
  std::uint32_t top_start_ = kNullNode;
  std::array<TracedHit, kRays> hit_;
  std::array<double, kRays> distance_;
  Mailbox objects_seen_, triangles_seen_;
  TracedFrame frame_;
};

}  // namespace

TracedFrame trace_frame(const Scene& scene, const SceneTrees& trees, const Camera& camera,
                        unsigned width, unsigned height, const TraceOptions& options) {
  return Tracer(scene, trees, camera, options).run(width, height);
}

}  // namespace dynrt::host
