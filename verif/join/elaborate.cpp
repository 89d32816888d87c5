// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Writes the Verilog top of the ring.
#include <fstream>

#include "join/emit_top.h"
#include "join/ring_join.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const dynrt::ring::Ring ring;
  std::ofstream file(argv[1]);
  file << hlsc::emit_top(ring.join.record(), "ring");
  return file.flush() ? 0 : 1;
}
