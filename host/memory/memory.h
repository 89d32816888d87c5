// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Nodes, list entries and matrices as the words of the three scene banks (units/memory_format.h),
// and back. In doubles until they are made words: the format is the board's.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "host/format/memory_format_of.h"
#include "host/memory/triangle_matrix.h"

namespace dynrt::host {

/// Consecutive words of one bank, as they go over the bus (MemoryFormat::bus_words).
struct MemoryRun {
  unsigned bank = 0;
  std::uint32_t address = 0;
  std::vector<std::uint32_t> words;
};

using MatrixColumns = std::array<MemoryColumn, 4>;

/// `extra` are 24 spare bits of column 0, `mirror` eight of column 1.
MatrixColumns to_columns(const glm::dmat4x3& matrix, std::uint32_t extra, std::uint32_t mirror = 0);
/// The same for a primitive: with the factor of its cosine in the spare bits of column 3.
MatrixColumns to_columns(const MemoryFormat& format, const UnitMatrix& unit, std::uint32_t colour,
                         std::uint32_t mirror);
/// A triangle without its column of ones (units/memory_format.h).
std::array<MemoryColumn, kStoredColumns> to_stored_columns(const MemoryFormat& format,
                                                           const UnitMatrix& efficient,
                                                           std::uint32_t colour,
                                                           std::uint32_t mirror);
glm::dmat4x3 from_columns(const MatrixColumns& columns);
std::uint32_t extra_bits(const MatrixColumns& columns);

/// Nodes, list entries and matrix columns at consecutive places of the memory.
struct MemoryPart {
  const MemoryFormat* format = &kShippedFormat;
  std::uint32_t first_node = 0;
  std::uint32_t first_entry = 0;
  std::uint32_t first_column = 0;
  std::vector<MemoryNode> nodes;
  std::vector<ListEntry> entries;
  std::vector<MemoryColumn> columns;

  void add(std::span<const MemoryColumn> matrix) {
    columns.insert(columns.end(), matrix.begin(), matrix.end());
  }

  std::uint32_t end_node() const { return first_node + static_cast<std::uint32_t>(nodes.size()); }
  std::uint32_t end_entry() const {
    return first_entry + static_cast<std::uint32_t>(entries.size());
  }
  std::uint32_t end_column() const {
    return first_column + static_cast<std::uint32_t>(columns.size());
  }
  /// The next matrix of four columns.
  std::uint32_t end_matrix() const { return (end_column() + 3) / 4; }

  /// At most one run for nodes in banks 0 and 1, for entries in bank 2, for columns in each bank.
  std::vector<MemoryRun> runs() const;
};

/// The runs that change the memory from `before` to `after`. Equal words between two different ones
/// are written too if that makes fewer runs that are hardly longer. A word of the memory is
/// `bus_words` of a run.
std::vector<MemoryRun> changed_runs(const std::vector<MemoryRun>& before,
                                    const std::vector<MemoryRun>& after, unsigned bus_words = 1);

/// The scene banks as the core reads them.
class SceneMemory {
 public:
  explicit SceneMemory(const MemoryFormat& format = kShippedFormat);
  void write(const std::vector<MemoryRun>& runs);
  MemoryNode node(std::uint32_t address) const;
  ListEntry entry(std::uint32_t address) const;
  MemoryColumn column(std::uint32_t address) const;
  MatrixColumns matrix(std::uint32_t index) const;

 private:
  const MemoryFormat& format_;
  std::array<std::vector<MemoryWord>, kSceneBanks> banks_;
};

}  // namespace dynrt::host
