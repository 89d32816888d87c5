// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From what the user says of a scene to its memory: load it, place the camera, add lights and
// mirrors, lay it out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/app/arguments.h"
#include "host/layout/lay_out.h"

namespace dynrt::host {

/// A scene in the memory, and what is reported of it.
struct Prepared : MemoryImage {
  double load_seconds = 0;

  Prepared() = default;
  explicit Prepared(MemoryImage image) : MemoryImage(std::move(image)) {}

  std::size_t triangles() const;  ///< of all objects, each counted once
  std::size_t rectangles() const;
  std::size_t spheres() const;
  std::size_t instanced_triangles() const;  ///< of all instances
  /// What the user should know: what the import took otherwise, which trees were cut.
  std::vector<std::string> notes() const;
  /// The scene, its trees and the memory they take, as data and as lines of text.
  nlohmann::ordered_json json() const;
  std::string text() const;
};

/// For a core: throws UserError where it lacks one of the scene's primitives, with the
/// configurations that have it, and what lay_out() throws; notes the lights and mirrors that it has
/// no rays for. Without a core it is laid out for the shipped numbers, with every primitive, and
/// neither lights nor mirrors are judged.
Prepared prepare(const SceneArguments& arguments, unsigned width, unsigned height,
                 const CoreInfo* core = nullptr);

}  // namespace dynrt::host
