// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A board behind a line, for tests: the model of the link with a memory and registers that count.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "hls/random.h"
#include "units/link_model.h"

namespace dynrt::host {

struct TestBoard {
  static constexpr std::uint32_t kMemoryBytes = 1 << 20;

  explicit TestBoard(std::uint32_t bytes = kMemoryBytes, std::string_view configuration = "fast")
      : memory_bytes(bytes), name(configuration) {}

  std::uint32_t memory_bytes;
  std::string_view name;
  std::map<std::uint32_t, std::uint32_t> registers;
  std::uint64_t register_writes = 0;
  LinkModel<16> model{{.name = name,
                       .clock_hz = 120'000'000,
                       .memory_bytes = memory_bytes,
                       .divisor = 40,
                       .beat_bytes = 16,
                       .pixel_mhz = 25},
                      {[this](std::uint32_t address, std::uint32_t value) {
                         ++register_writes;
                         registers[address] = value;
                       },
                       [this](std::uint32_t address) { return registers[address]; }}};
};

/// As unlike a picture as bytes are.
inline std::vector<std::uint8_t> random_bytes(std::size_t count, std::uint64_t seed) {
  hls::testing::Random random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  return bytes;
}

}  // namespace dynrt::host
