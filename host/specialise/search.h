// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The keys that no rule decides, as only measurements tell what they cost a scene: packets and
// cache lines and, behind a memory port, the nodes of a line of the node cache. The caller
// measures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/specialise/decide.h"

namespace dynrt::host {

/// What a frame takes on the native model, counted by hlsc's schedules.
struct FrameCosts {
  std::uint64_t clocks = 0;
  std::optional<double> bytes_per_ray;  ///< read of the scene; none without counters
};

/// Clocks of a frame by packets or lines, and costs by nodes of a line, in the order of measuring.
using Curve = std::vector<std::pair<unsigned, std::uint64_t>>;
using Layouts = std::vector<std::pair<unsigned, FrameCosts>>;

struct CountSearch {
  unsigned packets = 1, lines = 1;                  ///< of the general core: the most
  unsigned least_lines = 1;                         ///< that the other keys allow
  bool search_packets = true, search_lines = true;  ///< else they stay at the most
  double percent = 2;   ///< more clocks that a frame may take, one half for packets, one for lines
  std::string frame{};  ///< that is measured, in a sentence
};
struct Counts {
  std::vector<Decision> decisions;
  Curve packets, lines;  ///< empty for one that is not searched
};
/// The fewest packets, and with these the fewest lines, among powers of two.
Counts choose_counts(const CountSearch& search,
                     const std::function<std::uint64_t(unsigned packets, unsigned lines)>& clocks);

/// Costs from the fewest nodes up to a number that is both slower and reads more than one before.
Layouts try_layouts(const std::vector<unsigned>& rising,
                    const std::function<FrameCosts(unsigned nodes)>& costs);
/// The number that reads the fewest bytes among those that are about as fast as the fastest.
unsigned best_layout(const Layouts& layouts);
/// Why this number, beside all others that were measured.
std::string layout_reason(const Layouts& layouts, unsigned chosen, const std::string& frame);

/// "3.9 % fewer", with one word for numbers below 0 and one for the others.
std::string by_percent(double percent, const std::string& below, const std::string& above = "");

}  // namespace dynrt::host
