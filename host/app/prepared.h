// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene in the memory of a core, and its figures for the report.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/layout/lay_out.h"

namespace dynrt::host {

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

}  // namespace dynrt::host
