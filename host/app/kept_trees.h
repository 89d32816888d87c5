// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Saves the trees of objects in a folder of the user for later runs of the program. The name of a
// file is a hash of the object's primitives, the options, and the sources of the builder.
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/tree/build.h"

namespace dynrt::host {

class KeptTrees {
 public:
  /// Bytes that the folder may take; beyond that the oldest trees are removed.
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20;

  explicit KeptTrees(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// The saved tree, or else a new one, which is then saved. A damaged file is ignored, and nothing
  /// is saved into a folder that cannot be written.
  Tree tree(const Mesh& object, const TreeOptions& options) const;

 private:
  void keep(const std::filesystem::path& file, const Tree& tree) const;
  void make_room() const;

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
};

/// The folder of the saved trees: in the folder DYNRT_CACHE, else in the user's cache folder; empty
/// if there is neither.
std::filesystem::path folder_of_trees();

/// Options with which trees are taken from this folder and saved there.
TreeOptions kept_trees();

}  // namespace dynrt::host
