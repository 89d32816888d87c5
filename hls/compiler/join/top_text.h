// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The text of a Verilog top while it is written, and the names that its parts give to wires.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace hlsc {

/// "unit.port" as the stem of a wire's name.
inline std::string wire(const std::string& port) {
  std::string name = port;
  name.replace(name.find('.'), 1, "__");
  return name;
}

inline std::string range(unsigned width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

inline unsigned address_bits(unsigned rows) {
  unsigned bits = 1;
  while ((1ull << bits) < rows) ++bits;
  return bits;
}

/// `{c, b, a}`: Verilog lists the highest first.
inline std::string concatenation(const std::vector<std::string>& lowest_first) {
  if (lowest_first.size() == 1) return lowest_first.front();
  std::string list;
  for (auto it = lowest_first.rbegin(); it != lowest_first.rend(); ++it) {
    list += (list.empty() ? "" : ", ") + *it;
  }
  return "{" + list + "}";
}

inline std::vector<std::string> wires(const std::vector<std::string>& ports, const char* suffix) {
  std::vector<std::string> names;
  for (const std::string& port : ports) names.push_back(wire(port) + suffix);
  return names;
}

struct TopText {
  std::vector<std::string> ports;
  std::string wires;
  std::string body;

  template <class... A>
  void declare(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(wires), format, std::forward<A>(args)...);
  }
  template <class... A>
  void write(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(body), format, std::forward<A>(args)...);
  }
  template <class... A>
  void port(fmt::format_string<A...> format, A&&... args) {
    ports.push_back(fmt::format(format, std::forward<A>(args)...));
  }
  /// Declares the three wires of a stream.
  void stream(const std::string& stem, unsigned width) {
    declare("  wire {0}_valid, {0}_ready;\n  wire {1}{0}_data;\n", stem, range(width));
  }
};

}  // namespace hlsc
