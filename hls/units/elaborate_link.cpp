// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Writes the Verilog top of the link for a memory whose beats have DYNRT_LINK_BYTES bytes, FILE.v,
// and FILE.vh with the numbers that the board around it needs.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "join/emit_top.h"
#include "units/link.h"

namespace {

constexpr unsigned kBytes = DYNRT_LINK_BYTES;

std::string numbers() {
  using namespace dynrt;
  const auto line = [](const char* name, const std::string& value) {
    return fmt::format("`define DYNRT_LINK_{} {}\n", name, value);
  };
  const auto width = [&line](const char* name, unsigned bits) {
    return line(name, std::to_string(bits));
  };
  return "\n// Widths of tokens, and what the link says of itself (hls/units/link_format.h).\n" +
         width("WRITE_BITS", hls::bit_width_of<LinkWrite<kBytes>>()) +
         width("READ_BITS", hls::bit_width_of<LinkRead>()) +
         width("BEAT_BITS", hls::bit_width_of<LinkBeat<kBytes>>()) +
         line("BEAT_BYTES", fmt::format("8'd{}", kBytes)) +
         line("VERSION", fmt::format("8'd{}", kLinkVersion)) +
         line("MAGIC", fmt::format("32'h{:08x}", kLinkMagicValue));
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (file.flush()) return true;
  std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: elaborate_link FILE; it writes FILE.v and FILE.vh\n");
    return 2;
  }
  hls::Join join;
  const dynrt::Link<kBytes> link(join);
  const std::string file = argv[1];
  const bool written =
      write(file + ".v", hlsc::emit_top(join.record(), "dynrt_link")) &&
      write(file + ".vh", hlsc::emit_header(join.record(), "dynrt_link") + numbers());
  return written ? 0 : 1;
}
