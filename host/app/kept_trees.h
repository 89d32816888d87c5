// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Trees of objects that an earlier run of the program has built, in a folder of the user's. Each
// lies under a key of all that it is made of: the object's primitives, the options, and the sources
// of the builder.
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/tree/build.h"

namespace dynrt::host {

class KeptTrees {
 public:
  /// Bytes that the folder may take; beyond that the trees that were made first go.
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20;

  explicit KeptTrees(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// The kept tree, else a new one, which is kept then. A file that is damaged counts as none, and
  /// a folder that cannot be written keeps nothing.
  Tree tree(const Mesh& object, const TreeOptions& options) const;

 private:
  void keep(const std::filesystem::path& file, const Tree& tree) const;
  void make_room() const;

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
};

/// Where the program keeps its trees: in the folder that DYNRT_CACHE names, else in the user's
/// cache folder; empty if there is neither.
std::filesystem::path folder_of_trees();

/// Options with which objects take the trees of an earlier run from there, and leave theirs.
TreeOptions kept_trees();

}  // namespace dynrt::host
