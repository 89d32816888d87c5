// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Nodes, list entries and matrices as the words of the three scene banks (units/memory_format.h),
// and back.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "host/tree/triangle_matrix.h"
#include "units/memory_format.h"

namespace dynrt::host {

/// Consecutive words of one bank.
struct MemoryRun {
  unsigned bank = 0;
  std::uint32_t address = 0;
  std::vector<std::uint32_t> words;
};

using MatrixColumns = std::array<MatrixColumn, 4>;

/// Rounds a matrix once to the core's format; `extra` are the 24 spare bits of column 0, `mirror`
/// the spare byte of column 1, row 0.
MatrixColumns to_columns(const glm::dmat4x3& matrix, std::uint32_t extra, std::uint32_t mirror = 0);
/// The same for a primitive: with the factor of its cosine in the spare bytes of column 3.
MatrixColumns to_columns(const UnitMatrix& unit, std::uint32_t colour, std::uint32_t mirror);
/// A triangle without its column of ones (units/memory_format.h).
std::array<MatrixColumn, kStoredColumns> to_stored_columns(const UnitMatrix& efficient,
                                                           std::uint32_t colour,
                                                           std::uint32_t mirror);
glm::dmat4x3 from_columns(const MatrixColumns& columns);
std::uint32_t extra_bits(const MatrixColumns& columns);

/// Nodes, list entries and matrix columns at consecutive places of the memory.
struct MemoryPart {
  std::uint32_t first_node = 0;
  std::uint32_t first_entry = 0;
  std::uint32_t first_column = 0;
  std::vector<Node> nodes;
  std::vector<ListEntry> entries;
  std::vector<MatrixColumn> columns;

  void add(std::span<const MatrixColumn> matrix) {
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

/// What must be written to turn the memory that holds `before` into one that holds `after`. Equal
/// words between two different ones are written too where that makes fewer, hardly longer runs.
std::vector<MemoryRun> changed_runs(const std::vector<MemoryRun>& before,
                                    const std::vector<MemoryRun>& after);

/// The scene banks as the core reads them.
class SceneMemory {
 public:
  SceneMemory();
  void write(const std::vector<MemoryRun>& runs);
  Node node(std::uint32_t address) const;
  ListEntry entry(std::uint32_t address) const;
  MatrixColumn column(std::uint32_t address) const;
  MatrixColumns matrix(std::uint32_t index) const;

 private:
  std::array<std::vector<std::uint32_t>, kSceneBanks> banks_;
};

}  // namespace dynrt::host
