// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/counts/counts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/memory/triangle_matrix.h"
#include "host/tree/grid.h"

namespace dynrt::host {

std::uint64_t WorkCounts::bound() const {
  return std::max({steps() + leaf_fetches, 5 * (triangles + objects + packets), list_entries});
}

void WorkCounts::add(const WorkCounts& more) {
  packets += more.packets;
  top_steps += more.top_steps;
  object_steps += more.object_steps;
  leaf_fetches += more.leaf_fetches;
  empty_leaves += more.empty_leaves;
  list_entries += more.list_entries;
  triangles += more.triangles;
  objects += more.objects;
  hits += more.hits;
  dropped_pushes += more.dropped_pushes;
  deepest_stack = std::max(deepest_stack, more.deepest_stack);
}

namespace {

using Mask = unsigned;
const glm::dmat4x3 kNoMatrix(std::nan(""));
constexpr Grid kGrid;

struct Ray {
  glm::dvec3 origin, direction;
};

/// The core has no zero: neither has this.
double not_zero(double x) {
  return std::abs(x) < kGrid.smallest() ? std::copysign(kGrid.smallest(), x) : x;
}
glm::dvec3 not_zero(const glm::dvec3& v) { return {not_zero(v.x), not_zero(v.y), not_zero(v.z)}; }

/// Slots fill in order; once full they stay as they are, or the oldest is replaced.
class Mailbox {
 public:
  void clear() {
    items_.clear();
    oldest_ = 0;
  }
  bool seen(std::uint32_t item, unsigned slots, bool keeps_latest) {
    if (std::find(items_.begin(), items_.end(), item) != items_.end()) return true;
    if (items_.size() < slots) {
      items_.push_back(item);
    } else if (keeps_latest && slots > 0) {
      items_[oldest_] = item;
      oldest_ = (oldest_ + 1) % slots;
    }
    return false;
  }

 private:
  std::vector<std::uint32_t> items_;
  std::size_t oldest_ = 0;
};

std::uint32_t start(const Tree& tree, const glm::dvec3& origin, Clipping clipping) {
  if (clipping == Clipping::kNever) return tree.root;
  return clipping == Clipping::kAlways ? tree.clipped_root : tree.entry(origin);
}

/// All that packets share.
struct Setting {
  Setting(const Scene& the_scene, std::span<const Tree> the_objects, const TopLevel& the_top,
          const Camera& the_camera, const TraceOptions& the_options)
      : scene(the_scene),
        objects(the_objects),
        top(the_top),
        camera(the_camera),
        options(the_options) {
    for (const Mesh& mesh : scene.objects) {
      std::vector<glm::dmat4x3>& matrices = triangles.emplace_back();
      for (std::size_t i = 0; i < mesh.primitives(); ++i) {
        matrices.push_back(mesh.is_ellipsoid(i)
                               ? ellipsoid_matrix(mesh.ellipsoid(i)).matrix
                               : triangle_matrix(mesh.corners(i)).value_or(kNoMatrix));
      }
    }
    for (const Instance& instance : scene.instances) {
      const glm::dmat4 inverse = glm::inverse(instance.transform);
      to_object.push_back(inverse);
      object_start.push_back(start(objects[instance.object],
                                   glm::dvec3(inverse * glm::dvec4(camera.position, 1.0)),
                                   options.object_clipping));
    }
    if (!top.tree.nodes.empty()) {
      top_start = start(top.tree, camera.position, options.scene_clipping);
    }
  }

  const Scene& scene;
  std::span<const Tree> objects;
  const TopLevel& top;
  const Camera& camera;
  const TraceOptions& options;
  std::vector<std::vector<glm::dmat4x3>> triangles;
  std::vector<glm::dmat4> to_object;
  std::vector<std::uint32_t> object_start;
  std::uint32_t top_start = kNullNode;
};

/// Traces packets of kRays rays, one ray or 2x2.
template <int kRays>
class Tracer {
 public:
  Tracer(const Setting& setting, std::span<TracedHit> hits) : setting_(setting), hits_(hits) {}

  static constexpr unsigned kSide = kRays == 1 ? 1 : 2;

  /// Rows y to y + kSide of an image.
  void rows(unsigned y, unsigned width, unsigned height) {
    for (unsigned x = 0; x < width; x += kSide) packet(x, y, width, height);
  }

  const WorkCounts& work() const { return work_; }

 private:
  struct Entry {
    std::uint32_t node;
    Mask active, both;
    std::array<double, kRays> far;
  };

  void packet(unsigned x, unsigned y, unsigned width, unsigned height) {
    const Camera& camera = setting_.camera;
    std::array<Ray, kRays> rays;
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
    const TraceOptions& options = setting_.options;
    const auto enter = [&](std::uint32_t instance) {
      if (objects_seen_.seen(instance, options.object_slots, options.keeps_latest)) return;
      ++work_.objects;
      object(instance, rays);
    };
    for (const std::uint32_t instance : setting_.top.first) enter(instance);
    if (setting_.top_start != kNullNode) {
      traverse(setting_.top.tree, setting_.top_start, rays, true, enter);
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
  void object(std::uint32_t instance, const std::array<Ray, kRays>& world) {
    const glm::dmat4& m = setting_.to_object[instance];
    const std::uint32_t object = setting_.scene.instances[instance].object;
    std::array<Ray, kRays> rays;
    for (int i = 0; i < kRays; ++i) {
      rays[i] = {not_zero(glm::dvec3(m * glm::dvec4(world[i].origin, 1.0))),
                 not_zero(glm::dmat3(m) * world[i].direction)};
    }
    triangles_seen_.clear();
    const TraceOptions& options = setting_.options;
    traverse(setting_.objects[object], setting_.object_start[instance], rays, false,
             [&](std::uint32_t item) {
               if (triangles_seen_.seen(item, options.triangle_slots, options.keeps_latest)) return;
               ++work_.triangles;
               intersect(instance, item, setting_.triangles[object][item], rays);
             });
  }

  void intersect(std::uint32_t instance, std::uint32_t triangle, const glm::dmat4x3& m,
                 const std::array<Ray, kRays>& rays) {
    const Mesh& mesh = setting_.scene.objects[setting_.scene.instances[instance].object];
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
    near.fill(kGrid.smallest());
    for (int i = 0; i < kRays; ++i) far[i] = top ? kGrid.largest() : distance_[i];
    std::vector<Entry> stack;
    Mask active = (1u << kRays) - 1;
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
      if (top && !setting_.top.inner.empty() && active != 0) {
        const std::vector<std::uint32_t>& inner = setting_.top.inner[index];
        work_.list_entries += inner.size();
        for (const std::uint32_t item : inner) visit(item);
      }
      if (node.is_leaf()) {
        ++work_.leaf_fetches;
        if (active != 0) {
          work_.list_entries += node.right;
          for (std::uint32_t i = 0; i < node.right; ++i) visit(tree.items[node.left + i]);
        }
      } else {
        const bool clipping = index < tree.root;
        if (!(clipping && !top && setting_.options.object_clip_free)) {
          ++(top ? work_.top_steps : work_.object_steps);
        }
        Mask left = 0, right = 0, left_first = 0;
        for (int i = 0; i < kRays; ++i) {
          const double offset = not_zero(node.split - rays[i].origin[node.axis]);
          const double d = not_zero(offset / rays[i].direction[node.axis]);
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
        if (near_mask != 0 && near_node == kNullNode && !clipping) ++work_.empty_leaves;
        pop = !enter_near && !enter_far;
        if (enter_near) {
          if (far_mask != 0) {
            const bool real = far_node != kNullNode;
            if (real && real_entries == setting_.options.stack_depth) {
              ++work_.dropped_pushes;
            } else if (real || !clipping) {
              stack.push_back({far_node, far_mask, both, far});
              real_entries += real;
            }
            work_.deepest_stack = std::max(work_.deepest_stack, real_entries);
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
        // The core's stack holds no empty children: those here only count nodes that were not
        // fetched.
        while (!stack.empty() && stack.back().node == kNullNode) {
          const Mask still = stack.back().active & alive;
          bool wanted = false;
          for (int i = 0; i < kRays; ++i) {
            wanted = wanted || ((still >> i & 1) && !(distance_[i] < far[i]));
          }
          work_.empty_leaves += wanted;
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

  const Setting& setting_;
  std::span<TracedHit> hits_;
  std::array<TracedHit, kRays> hit_;
  std::array<double, kRays> distance_;
  Mailbox objects_seen_, triangles_seen_;
  WorkCounts work_;
};

template <int kRays>
WorkCounts trace(const Setting& setting, unsigned width, unsigned height,
                 std::span<TracedHit> hits) {
  constexpr unsigned kSide = Tracer<kRays>::kSide;
  const auto add = [](WorkCounts left, const WorkCounts& right) {
    left.add(right);
    return left;
  };
  return tbb::parallel_reduce(
      tbb::blocked_range<unsigned>(0, height / kSide), WorkCounts{},
      [&](const tbb::blocked_range<unsigned>& range, const WorkCounts& before) {
        Tracer<kRays> tracer(setting, hits);
        for (unsigned row = range.begin(); row != range.end(); ++row) {
          tracer.rows(row * kSide, width, height);
        }
        return add(before, tracer.work());
      },
      add);
}

}  // namespace

TracedFrame trace_frame(const Scene& scene, std::span<const Tree> objects, const TopLevel& top,
                        const Camera& camera, unsigned width, unsigned height,
                        const TraceOptions& options) {
  const Setting setting(scene, objects, top, camera, options);
  TracedFrame frame;
  frame.hits.resize(std::size_t{width} * height);
  frame.work = options.single_rays ? trace<1>(setting, width, height, frame.hits)
                                   : trace<4>(setting, width, height, frame.hits);
  return frame;
}

TracedFrame trace_frame(const Scene& scene, const SceneTrees& trees, const Camera& camera,
                        unsigned width, unsigned height, const TraceOptions& options) {
  return trace_frame(scene, trees.objects, {trees.instances, {}, {}}, camera, width, height,
                     options);
}

}  // namespace dynrt::host
