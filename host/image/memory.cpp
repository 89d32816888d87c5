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
  for (unsigned row = 0; row < kSceneBanks && !matrices.empty(); ++row) {
    MemoryRun run{row, kColumnBase + 4 * first_matrix, {}};
    run.words.reserve(4 * matrices.size());
    for (const MatrixColumns& columns : matrices) {
      for (const MatrixColumn& column : columns) {
        run.words.push_back(hls::pack(column.row[row])[0]);
      }
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

MatrixColumns SceneMemory::matrix(std::uint32_t index) const {
  MatrixColumns columns;
  for (std::uint32_t c = 0; c < 4; ++c) {
    for (unsigned row = 0; row < kSceneBanks; ++row) {
      columns[c].row[row] = hls::unpack<MatrixWord>(&banks_[row].at(kColumnBase + 4 * index + c));
    }
  }
  return columns;
}

}  // namespace dynrt::host
