// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Writes what the join of the core says, for one configuration: the Verilog top, its description as
// JSON and the block diagram.
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include DYNRT_CONFIG_HEADER
#include "join/emit_top.h"
#include "units/core.h"

namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: elaborate TOP.v TOP.json TOP.dot\n");
    return 2;
  }
  try {
    hls::Join join;
    const auto core = std::make_unique<dynrt::Core<dynrt::config::DYNRT_CONFIG>>(
        join, std::array<dynrt::Bank, dynrt::kBanks>{});
    write(argv[1], hlsc::emit_top(join.record(), "dynrt_core"));
    write(argv[2], hlsc::emit_json(join.record(), "dynrt_core"));
    write(argv[3], hlsc::emit_diagram(join.record()));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "elaborate: %s\n", error.what());
    return 1;
  }
  return 0;
}
