// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/memory/memory.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "hls/bits.h"

namespace dynrt::host {

MatrixColumns to_columns(const glm::dmat4x3& matrix, std::uint32_t extra, std::uint32_t mirror) {
  MatrixColumns columns;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) columns[c].value[r] = matrix[c][r];
  }
  columns[0].spare = extra;
  columns[1].spare = mirror;
  return columns;
}

MatrixColumns to_columns(const MemoryFormat& format, const UnitMatrix& unit, std::uint32_t colour,
                         std::uint32_t mirror) {
  MatrixColumns columns = to_columns(unit.matrix, colour, mirror);
  columns[3].spare = format.bits(unit.cosine_factor);
  return columns;
}

std::array<MemoryColumn, kStoredColumns> to_stored_columns(const MemoryFormat& format,
                                                           const UnitMatrix& efficient,
                                                           std::uint32_t colour,
                                                           std::uint32_t mirror) {
  const MatrixColumns all = to_columns(efficient.matrix, 0);
  const int ones = efficient.ones;
  std::array<MemoryColumn, kStoredColumns> stored{all[ones == 0 ? 1 : 0], all[ones == 2 ? 1 : 2],
                                                  all[3]};
  const auto place = static_cast<std::uint32_t>(ones) << 16;
  stored[0].spare = (colour & 0xffff) | place;
  stored[1].spare = mirror | (colour >> 16 & 255) << 8 | place;
  stored[2].spare = format.bits(efficient.cosine_factor);
  return stored;
}

glm::dmat4x3 from_columns(const MatrixColumns& columns) {
  glm::dmat4x3 matrix;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) matrix[c][r] = columns[c].value[r];
  }
  return matrix;
}

std::uint32_t extra_bits(const MatrixColumns& columns) {
  return static_cast<std::uint32_t>(columns[0].spare) & 0xffffff;
}

std::vector<MemoryRun> MemoryPart::runs() const {
  const unsigned bus_words = format->bus_words();
  const auto append = [&](MemoryRun& run, MemoryWord word) {
    for (unsigned i = 0; i < bus_words; ++i) {
      run.words.push_back(static_cast<std::uint32_t>(word >> (32 * i)));
    }
  };
  std::vector<MemoryRun> runs;
  if (!nodes.empty()) {
    MemoryRun low{0, first_node, {}};
    MemoryRun high{1, first_node, {}};
    for (const MemoryNode& node : nodes) {
      const auto words = format->pack_node(node);
      append(low, words[0]);
      append(high, words[1]);
    }
    runs.push_back(std::move(low));
    runs.push_back(std::move(high));
  }
  if (!entries.empty()) {
    MemoryRun run{2, first_entry, {}};
    for (const ListEntry& entry : entries) append(run, hls::pack(entry)[0]);
    runs.push_back(std::move(run));
  }
  if (!columns.empty()) {
    std::array<MemoryRun, kSceneBanks> rows;
    for (unsigned row = 0; row < kSceneBanks; ++row) {
      rows[row] = {row, kColumnBase + first_column, {}};
      rows[row].words.reserve(columns.size() * bus_words);
    }
    for (const MemoryColumn& column : columns) {
      const auto words = format->pack_column(column);
      for (unsigned row = 0; row < kSceneBanks; ++row) append(rows[row], words[row]);
    }
    std::ranges::move(rows, std::back_inserter(runs));
  }
  return runs;
}

std::vector<MemoryRun> changed_runs(const std::vector<MemoryRun>& before,
                                    const std::vector<MemoryRun>& after, unsigned bus_words) {
  constexpr std::size_t kGap = 4;  // a run's own cost on the bus, in words
  const std::size_t step = bus_words;
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
                         run.address + static_cast<std::uint32_t>(begin / step),
                         {run.words.begin() + static_cast<std::ptrdiff_t>(begin),
                          run.words.begin() + static_cast<std::ptrdiff_t>(end)}});
      begin = end = 0;
    };
    for (std::size_t i = 0; i < run.words.size(); i += step) {
      if (i < same && std::equal(&run.words[i], &run.words[i] + step, &found->second->words[i])) {
        continue;
      }
      if (begin != end && i - end > kGap) close();
      if (begin == end) begin = i;
      end = i + step;
    }
    close();
  }
  return changed;
}

SceneMemory::SceneMemory(const MemoryFormat& format) : format_(format) {
  for (std::vector<MemoryWord>& bank : banks_) bank.resize(kBankWords);
}

void SceneMemory::write(const std::vector<MemoryRun>& runs) {
  const unsigned step = format_.bus_words();
  for (const MemoryRun& run : runs) {
    for (std::size_t i = 0; i < run.words.size(); ++i) {
      MemoryWord& word = banks_.at(run.bank).at(run.address + i / step);
      if (i % step == 0) word = 0;
      word |= MemoryWord{run.words[i]} << (32 * (i % step));
    }
  }
}

MemoryNode SceneMemory::node(std::uint32_t address) const {
  return format_.unpack_node({banks_[0].at(address), banks_[1].at(address)});
}

ListEntry SceneMemory::entry(std::uint32_t address) const {
  return hls::unpack<ListEntry>({static_cast<std::uint32_t>(banks_[2].at(address))});
}

MemoryColumn SceneMemory::column(std::uint32_t address) const {
  const std::uint32_t at = kColumnBase + address;
  return format_.unpack_column({banks_[0].at(at), banks_[1].at(at), banks_[2].at(at)});
}

MatrixColumns SceneMemory::matrix(std::uint32_t index) const {
  return {column(4 * index), column(4 * index + 1), column(4 * index + 2), column(4 * index + 3)};
}

}  // namespace dynrt::host
