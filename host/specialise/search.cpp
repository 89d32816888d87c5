// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "host/words.h"

namespace dynrt::host {

namespace {

constexpr double kSeenEnough = 1.5;  ///< times the fewest clocks: slower still, nothing is measured
constexpr double kAsFast = 1.02;     ///< times the fewest clocks: no slower, so the bytes decide

double percent_more(std::uint64_t clocks, std::uint64_t base) {
  return 100 * (static_cast<double>(clocks) / static_cast<double>(base) - 1);
}

/// From the most down, by half each time.
struct Walk {
  Curve curve;
  unsigned chosen;  ///< the smallest number that costs at most so much, as do all above it
};
Walk walk_down(unsigned most, unsigned least, double percent,
               const std::function<std::uint64_t(unsigned)>& clocks_of) {
  const std::uint64_t base = clocks_of(most);
  Walk walk{{{most, base}}, most};
  bool holds = true;
  for (unsigned number = std::bit_ceil(most) / 2; number >= std::max(least, 1u); number /= 2) {
    const std::uint64_t clocks = clocks_of(number);
    walk.curve.emplace_back(number, clocks);
    holds = holds && static_cast<double>(clocks) <= static_cast<double>(base) * (1 + percent / 100);
    if (holds) walk.chosen = number;
    if (static_cast<double>(clocks) > kSeenEnough * static_cast<double>(base)) break;
  }
  return walk;
}

/// Why this number, with the next ones on both sides.
std::string reason_of(const Walk& walk, double percent, const std::string& frame) {
  const auto& [most, base] = walk.curve.front();
  std::string words = fmt::format("with {} {} takes {} clocks", most, frame, grouped(base));
  for (const auto& [number, clocks] : walk.curve) {
    if (number == most || number > walk.chosen) continue;
    words += fmt::format(", with {} {}", number,
                         by_percent(percent_more(clocks, base), "fewer", "more"));
    if (number < walk.chosen) break;
  }
  return fmt::format("{}; {:g} % are allowed", words, percent);
}

double bytes_of(const FrameCosts& costs) { return costs.bytes_per_ray.value_or(0); }

std::uint64_t fewest_clocks(const Layouts& layouts) {
  const auto clocks = [](const auto& one) { return one.second.clocks; };
  return std::ranges::min_element(layouts, {}, clocks)->second.clocks;
}

}  // namespace

std::string by_percent(double percent, const std::string& below, const std::string& above) {
  const double rounded = std::round(10 * percent) / 10;
  const std::string& word = rounded < 0 ? below : above;
  return fmt::format("{:.1f} %{}{}", std::abs(rounded), word.empty() ? "" : " ", word);
}

Counts choose_counts(const CountSearch& search,
                     const std::function<std::uint64_t(unsigned, unsigned)>& clocks) {
  Counts counts;
  unsigned packets = search.packets;
  const auto add = [&](const char* key, Curve& curve, Walk walk) {
    counts.decisions.push_back(
        {key, walk.chosen, reason_of(walk, search.percent / 2, search.frame)});
    curve = std::move(walk.curve);
    return walk.chosen;
  };
  if (search.search_packets) {
    packets = add("packets", counts.packets,
                  walk_down(search.packets, 1, search.percent / 2,
                            [&](unsigned n) { return clocks(n, search.lines); }));
  }
  if (search.search_lines) {
    add("lines", counts.lines,
        walk_down(search.lines, search.least_lines, search.percent / 2,
                  [&](unsigned n) { return clocks(packets, n); }));
  }
  return counts;
}

Layouts try_layouts(const std::vector<unsigned>& rising,
                    const std::function<FrameCosts(unsigned)>& costs_of) {
  Layouts found;
  for (const unsigned nodes : rising) {
    const FrameCosts costs = costs_of(nodes);
    const bool worse = std::ranges::any_of(found, [&](const auto& other) {
      return costs.clocks > other.second.clocks && bytes_of(costs) > bytes_of(other.second);
    });
    found.emplace_back(nodes, costs);
    if (worse) break;
  }
  return found;
}

unsigned best_layout(const Layouts& layouts) {
  const double most = kAsFast * static_cast<double>(fewest_clocks(layouts));
  const auto rank = [&](const auto& one) {
    const bool slow = static_cast<double>(one.second.clocks) > most;
    return std::tuple(slow, bytes_of(one.second), one.first);
  };
  return std::ranges::min_element(layouts, {}, rank)->first;
}

std::string layout_reason(const Layouts& layouts, unsigned chosen, const std::string& frame) {
  std::string first, others;
  std::uint64_t base = 0;
  for (const auto& [nodes, costs] : layouts) {
    if (nodes == chosen) base = costs.clocks;
  }
  for (const auto& [nodes, costs] : layouts) {
    const std::string read =
        costs.bytes_per_ray ? fmt::format(" and {:.2f} bytes a ray", *costs.bytes_per_ray) : "";
    if (nodes == chosen) {
      first = fmt::format("with {} {} takes {} clocks{}", nodes, frame, grouped(base), read);
    } else {
      others += fmt::format(", with {} {}{}", nodes,
                            by_percent(percent_more(costs.clocks, base), "fewer", "more"), read);
    }
  }
  return first + others;
}

}  // namespace dynrt::host
