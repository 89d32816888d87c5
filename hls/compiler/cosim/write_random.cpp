// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// write_random SEED DELAY_FOLDER STEM: lowers random_netlist(SEED) to STEM.v and STEM_ports.h.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "cosim/random_netlist.h"
#include "error.h"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: write_random SEED DELAY_FOLDER STEM\n", stderr);
    return 2;
  }
  try {
    const auto seed = static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
    const hlsc::Lowered lowered =
        hlsc::lower(hlsc::random_netlist(seed), hlsc::random_options(seed, argv[2]));
    const std::string stem = argv[3];
    std::ofstream(stem + ".v") << lowered.verilog;
    std::ofstream(stem + ".txt") << lowered.report;
    std::ofstream(stem + "_ports.h") << lowered.binding;
  } catch (const hlsc::Error& error) {
    std::fprintf(stderr, "%s\n", error.text().c_str());
    return 1;
  }
  return 0;
}
