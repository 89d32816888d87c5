// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From the user's flags to a scene in memory: load it, place the camera, add lights and mirrors,
// lay it out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/app/scene_file.h"
#include "host/layout/lay_out.h"

namespace dynrt::host {

/// A scene in the memory, and its figures for the report.
struct Prepared : MemoryImage {
  double load_seconds = 0;
  bool trees_may_be_kept = false;  ///< so `tree_seconds` may be those of reading them

  explicit Prepared(MemoryImage image) : MemoryImage(std::move(image)) {}

  std::size_t triangles() const;  ///< of all objects, each counted once
  std::size_t rectangles() const;
  std::size_t spheres() const;
  std::size_t instanced_triangles() const;  ///< of all instances
  /// Notes for the user: parts that the import changed, trees that were cut.
  std::vector<std::string> notes() const;
  /// Adds a note with the scene's bounds and a camera that sees all of it.
  void note_no_hit();
  /// The scene, its trees and the memory they take, as data and as lines of text.
  nlohmann::ordered_json json() const;
  std::string text() const;
};

/// With a core: throws UserError if the core lacks one of the scene's primitives, naming the
/// configurations that have it, and throws the errors of lay_out(); notes the lights and mirrors
/// that the core has no rays for. Without a core: lays the scene out for the shipped number format,
/// with every primitive, and does not check lights and mirrors.
Prepared prepare(SceneFile& file, unsigned width, unsigned height, const CoreInfo* core = nullptr,
                 const TreeOptions& trees = {});
/// For one core, of a file that nothing else reads.
Prepared prepare(const SceneArguments& arguments, unsigned width, unsigned height,
                 const CoreInfo* core = nullptr, const TreeOptions& trees = {});

}  // namespace dynrt::host
