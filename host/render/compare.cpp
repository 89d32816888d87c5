// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/compare.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/render/figures.h"

namespace dynrt::host {

namespace {

std::string number(const MemoryFormat&, std::uint32_t value) { return fmt::format("{}", value); }
std::string flag(const MemoryFormat&, std::uint32_t value) { return value ? "yes" : "no"; }
std::string colour(std::uint32_t value) { return fmt::format("{:#08x}", value); }

/// The bits of a float and their value.
std::string real(const MemoryFormat& format, std::uint32_t bits) {
  return fmt::format("{} ({:#08x})", format.number(bits), bits);
}

struct Field {
  const char* name;
  std::uint32_t (*value)(const HitRecord&);
  std::string (*text)(const MemoryFormat&, std::uint32_t);
};

constexpr Field kFields[] = {
    {"hit", [](const HitRecord& r) -> std::uint32_t { return r.hit; }, flag},
    {"object", [](const HitRecord& r) { return r.object; }, number},
    {"triangle", [](const HitRecord& r) { return r.triangle; }, number},
    {"t", [](const HitRecord& r) { return r.t; }, real},
    {"u", [](const HitRecord& r) { return r.u; }, real},
    {"v", [](const HitRecord& r) { return r.v; }, real},
    {"cosine", [](const HitRecord& r) { return r.cosine; }, real},
};

Difference first_field(const HitRecord& left, const MemoryFormat& left_format,
                       const HitRecord& right, const MemoryFormat& right_format) {
  for (const Field& field : kFields) {
    const std::uint32_t a = field.value(left);
    const std::uint32_t b = field.value(right);
    if (a == b) continue;
    return {{}, {}, field.name, field.text(left_format, a), field.text(right_format, b)};
  }
  return {};
}

void note(Comparison& comparison, Difference difference) {
  if (!comparison.first) comparison.first = std::move(difference);
}

void compare_pixels(Comparison& comparison, const Frame& left, const Frame& right) {
  for (std::size_t p = 0; p < left.pixels.size(); ++p) {
    const auto at = [&](Difference difference) {
      difference.x = static_cast<unsigned>(p % left.width);
      difference.y = static_cast<unsigned>(p / left.width);
      return difference;
    };
    ++comparison.pixels;
    comparison.hits += left.hits[p].hit;
    if (left.hits[p] != right.hits[p]) {
      ++comparison.different_hits;
      note(comparison,
           at(first_field(left.hits[p], *left.core.format, right.hits[p], *right.core.format)));
    }
    if (left.pixels[p] != right.pixels[p]) {
      ++comparison.different_pixels;
      note(comparison, at({{}, {}, "colour", colour(left.pixels[p]), colour(right.pixels[p])}));
    }
  }
}

constexpr char kNone[] = "none";

/// The value of an order-independent counter, if the board has it.
std::optional<std::uint64_t> value_of(const CounterTotals& totals, const std::string& name) {
  const auto found = std::ranges::find(totals, name, &Counter::name);
  if (found == totals.end() || !found->order_independent) return std::nullopt;
  return found->value;
}

/// Every order-independent counter of either board, the sum over all pipelines; one that the other
/// board lacks is a difference.
void compare_counters(Comparison& comparison, const Frame& left, const Frame& right) {
  const CounterTotals of_left = totals_of(left), of_right = totals_of(right);
  const auto text = [](std::optional<std::uint64_t> value) {
    return value ? fmt::format("{}", *value) : kNone;
  };
  const auto check = [&](const std::string& name) {
    const auto a = value_of(of_left, name);
    const auto b = value_of(of_right, name);
    if (a && b) ++comparison.counters;
    if (a == b) return;
    ++comparison.different_counters;
    note(comparison, {{}, {}, name, text(a), text(b)});
  };
  for (const Counter& counter : of_left) check(counter.name);
  for (const Counter& counter : of_right) {
    if (!value_of(of_left, counter.name)) check(counter.name);
  }
}

/// Nothing compared is nothing proved.
void require(Comparison& comparison, std::uint64_t compared, const char* what) {
  if (compared == 0) note(comparison, {{}, {}, what, kNone, kNone});
}

}  // namespace

std::string Difference::text(const std::string& left_board, const std::string& right_board) const {
  const std::string where = x ? fmt::format("pixel ({}, {}), {}", *x, *y, field) : field;
  return fmt::format("{}: {} has {}, {} has {}", where, left_board, left, right_board, right);
}

Comparison compare(const Frame& left, const Frame& right) {
  Comparison comparison;
  if (left.width != right.width || left.height != right.height) {
    const auto size = [](const Frame& f) { return fmt::format("{}x{}", f.width, f.height); };
    note(comparison, {{}, {}, "size", size(left), size(right)});
    return comparison;
  }
  compare_pixels(comparison, left, right);
  require(comparison, comparison.pixels, "pixels to compare");
  // Cores of other parts do the same frame by other steps.
  if (left.core.name == right.core.name && left.core.counters && right.core.counters) {
    compare_counters(comparison, left, right);
    require(comparison, comparison.counters, "counters to compare");
  }
  return comparison;
}

}  // namespace dynrt::host
