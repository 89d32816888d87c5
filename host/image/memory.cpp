// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/image/memory.h"

#include <algorithm>
#include <map>
#include <utility>

#include "hls/bits.h"

namespace dynrt::host {

MatrixColumns to_columns(const glm::dmat4x3& matrix, std::uint32_t extra, std::uint32_t mirror) {
  MatrixColumns columns;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) columns[c].row[r].value = Real::from_double(matrix[c][r]);
  }
  for (unsigned r = 0; r < 3; ++r) columns[0].row[r].spare = uint<8>::from(extra >> (8 * r) & 255);
  columns[1].row[0].spare = uint<8>::from(mirror & 255);
  return columns;
}

namespace {

void set_spare(MatrixColumn& column, std::uint64_t bits) {
  for (unsigned r = 0; r < 3; ++r) column.row[r].spare = uint<8>::from(bits >> (8 * r) & 255);
}

std::uint64_t factor_bits(double factor) { return Real::from_double(factor).bits().to_u64(); }

}  // namespace

MatrixColumns to_columns(const UnitMatrix& unit, std::uint32_t colour, std::uint32_t mirror) {
  MatrixColumns columns = to_columns(unit.matrix, colour, mirror);
  set_spare(columns[3], factor_bits(unit.cosine_factor));
  return columns;
}

std::array<MatrixColumn, kStoredColumns> to_stored_columns(const UnitMatrix& efficient,
                                                           std::uint32_t colour,
                                                           std::uint32_t mirror) {
  const MatrixColumns all = to_columns(efficient.matrix, 0);
  const int ones = efficient.ones;
  std::array<MatrixColumn, kStoredColumns> stored{all[ones == 0 ? 1 : 0], all[ones == 2 ? 1 : 2],
                                                  all[3]};
  const auto place = static_cast<std::uint32_t>(ones) << 16;
  set_spare(stored[0], (colour & 0xffff) | place);
  set_spare(stored[1], mirror | (colour >> 16 & 255) << 8 | place);
  set_spare(stored[2], factor_bits(efficient.cosine_factor));
  return stored;
}

glm::dmat4x3 from_columns(const MatrixColumns& columns) {
  glm::dmat4x3 matrix;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) matrix[c][r] = columns[c].row[r].value.to_double();
  }
  return matrix;
}

std::uint32_t extra_bits(const MatrixColumns& columns) {
  std::uint32_t extra = 0;
  for (unsigned r = 0; r < 3; ++r) {
    extra |= static_cast<std::uint32_t>(columns[0].row[r].spare.to_u64()) << (8 * r);
  }
  return extra;
}

std::vector<MemoryRun> MemoryPart::runs() const {
  std::vector<MemoryRun> runs;
  if (!nodes.empty()) {
    MemoryRun low{0, first_node, {}};
    MemoryRun high{1, first_node, {}};
    for (const Node& node : nodes) {
      const auto words = hls::pack(node);
      low.words.push_back(words[0]);
      high.words.push_back(words[1]);
    }
    runs.push_back(std::move(low));
    runs.push_back(std::move(high));
  }
  if (!entries.empty()) {
    MemoryRun run{2, first_entry, {}};
    for (const ListEntry& entry : entries) run.words.push_back(hls::pack(entry)[0]);
    runs.push_back(std::move(run));
  }
  for (unsigned row = 0; row < kSceneBanks && !columns.empty(); ++row) {
    MemoryRun run{row, kColumnBase + first_column, {}};
    run.words.reserve(columns.size());
    for (const MatrixColumn& column : columns) {
      run.words.push_back(hls::pack(column.row[row])[0]);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<MemoryRun> changed_runs(const std::vector<MemoryRun>& before,
                                    const std::vector<MemoryRun>& after) {
  constexpr std::size_t kGap = 4;  // a run's own cost on the bus, in words
  std::map<std::pair<unsigned, std::uint32_t>, const MemoryRun*> known;
  for (const MemoryRun& run : before) known[{run.bank, run.address}] = &run;
  std::vector<MemoryRun> changed;
  for (const MemoryRun& run : after) {
    const auto found = known.find({run.bank, run.address});
    const std::size_t same = found == known.end() ? 0 : found->second->words.size();
    std::size_t begin = 0, end = 0;  // the open run, empty at first
    const auto close = [&] {
      if (begin == end) return;
      changed.push_back({run.bank,
                         run.address + static_cast<std::uint32_t>(begin),
                         {run.words.begin() + static_cast<std::ptrdiff_t>(begin),
                          run.words.begin() + static_cast<std::ptrdiff_t>(end)}});
      begin = end = 0;
    };
    for (std::size_t i = 0; i < run.words.size(); ++i) {
      if (i < same && found->second->words[i] == run.words[i]) continue;
      if (begin != end && i - end > kGap) close();
      if (begin == end) begin = i;
      end = i + 1;
    }
    close();
  }
  return changed;
}

SceneMemory::SceneMemory() {
  for (std::vector<std::uint32_t>& bank : banks_) bank.resize(kBankWords);
}

void SceneMemory::write(const std::vector<MemoryRun>& runs) {
  for (const MemoryRun& run : runs) {
    std::copy(run.words.begin(), run.words.end(), banks_.at(run.bank).begin() + run.address);
  }
}

Node SceneMemory::node(std::uint32_t address) const {
  return hls::unpack<Node>(hls::Words<Node>{banks_[0].at(address), banks_[1].at(address)});
}

ListEntry SceneMemory::entry(std::uint32_t address) const {
  return hls::unpack<ListEntry>(&banks_[2].at(address));
}

MatrixColumn SceneMemory::column(std::uint32_t address) const {
  MatrixColumn column;
  for (unsigned row = 0; row < kSceneBanks; ++row) {
    column.row[row] = hls::unpack<MatrixWord>(&banks_[row].at(kColumnBase + address));
  }
  return column;
}

MatrixColumns SceneMemory::matrix(std::uint32_t index) const {
  return {column(4 * index), column(4 * index + 1), column(4 * index + 2), column(4 * index + 3)};
}

}  // namespace dynrt::host
