// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores without the parts that a scene does not need, against the general core of a configuration
// that ships: the same hit records and pixels.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/scenes.h"
#include "host/board/configurations.h"
#include "host/board/native_core.h"
#include "host/error.h"
#include "host/render/compare.h"
#include "host/render/render.h"

namespace dynrt::host::specialised {

inline constexpr unsigned kWidth = 64, kHeight = 48;

inline void paint(Scene& scene) {
  for (Material& material : scene.materials) material.diffuse = {0.3, 0.6, 0.9};
}
/// All instances as one object.
inline void merge(Scene& scene) {
  Mesh all;
  all.name = "all";
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.objects[instance.object];
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const glm::dvec3& vertex : mesh.vertices) {
      all.vertices.push_back(glm::dvec3(instance.transform * glm::dvec4(vertex, 1.0)));
    }
    for (const glm::uvec3& triangle : mesh.triangles) all.triangles.push_back(triangle + first);
    all.material.insert(all.material.end(), mesh.material.begin(), mesh.material.end());
  }
  scene.objects = {all};
  scene.instances = {{.name = "all"}};
}
inline void merge_and_paint(Scene& scene) {
  merge(scene);
  paint(scene);
}

inline FrameOptions small_frame() {
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return options;
}

inline MemoryImage laid_out(const std::string& name, const CoreInfo& core,
                            const ChangeScene& change = {}) {
  return host::laid_out(name, kWidth, kHeight, core, change);
}

template <class C>
std::unique_ptr<Board> board_of(const char* name = "special") {
  CoreInfo info = core_info_of<C>();
  info.name = name;
  return std::make_unique<ModelBoard>(std::move(info), std::make_unique<NativeCoreOf<C>>());
}

inline Frame rendered(Board& board, const std::string& scene, const ChangeScene& change) {
  return render(board, small_frame(), laid_out(scene, board.core(), change));
}

/// A counter of a frame.
inline std::uint64_t count_of(const Frame& frame, std::string_view name) {
  const auto found = std::ranges::find(frame.counters, name, &Counter::name);
  if (found != frame.counters.end()) return found->value;
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

/// Every ray of two cores' frames has the same hit and the same pixel, and many hit something.
inline void expect_same_picture(const Frame& frame, const Frame& expected, const std::string& scene,
                                const char* core, const char* expected_core) {
  const Comparison comparison = compare(frame, expected);
  EXPECT_GT(comparison.hits, comparison.pixels / 8);
  EXPECT_EQ(comparison.different_hits + comparison.different_pixels, 0u)
      << scene << ": " << comparison.first->text(core, expected_core);
}

/// The specialised core C against a general one.
template <class C>
Frame expect_as(Board& general, const char* name, const std::string& scene,
                const ChangeScene& change) {
  const auto special = board_of<C>();
  const Frame frame = rendered(*special, scene, change);
  const Comparison comparison = compare(frame, rendered(general, scene, change));
  EXPECT_GT(comparison.hits, comparison.pixels / 8);
  EXPECT_TRUE(comparison.identical())
      << scene << ": " << comparison.different_hits << " hits differ; "
      << comparison.first->text("special", name);
  return frame;
}
/// The same where the general core is that of a configuration by name.
template <class C>
Frame expect_as_general(const char* configuration, const std::string& scene,
                        const ChangeScene& change = {}) {
  const auto general = make_board(configurations(), {"model", configuration, ""});
  return expect_as<C>(*general, configuration, scene, change);
}

/// The sentence with which something is refused.
template <class Do>
std::string refusal(Do&& action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "none";
}

/// Whether a port, or a RAM, of some configuration is there.
template <class Port>
constexpr bool is_there(const Port&) {
  return !std::is_same_v<Port, hls::Absent>;
}

/// Bits that the token T of a general core has more than that of a special one.
template <class T, class Special>
inline constexpr unsigned kSaved = hls::bit_width_of<T>() - hls::bit_width_of<Special>();

}  // namespace dynrt::host::specialised
