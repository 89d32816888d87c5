// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/outcome.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace dynrt::host::stress {

namespace {

constexpr std::array<FaultText, kFaults> kTexts = {{
    {"lost", "rays that hit something and are reported to hit nothing"},
    {"invented", "rays that hit nothing and are reported to hit something"},
    {"wrong", "rays reported to hit a triangle that is not where the nearest is"},
    {"twice", "rays that hit more than one of several triangles, each tested alone"},
    {"different", "rays that must give the same bits as others and do not"},
    {"unsaid", "rays lost by a full stack that the counter stack_full does not count"},
    {"accepted", "rays of a scene that the host must refuse and does not"},
}};

}  // namespace

std::span<const FaultText, kFaults> fault_texts() { return kTexts; }

std::optional<std::uint64_t> Allowed::count(Fault fault) const {
  const auto bound = [&](std::uint64_t rays) {
    return stated ? std::optional(rays) : std::nullopt;
  };
  switch (fault) {
    case Fault::kLost:
      return bound(lost);
    case Fault::kInvented:
      return bound(invented);
    case Fault::kWrong:
      return bound(wrong);
    case Fault::kTwice:
      return bound(twice);
    default:
      return 0;
  }
}

void Outcome::digest_word(std::uint32_t word) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (unsigned byte = 0; byte < 4; ++byte) {
    digest = (digest ^ (word >> (8 * byte) & 0xff)) * kPrime;
  }
}

bool within(const Outcome& outcome, const Allowed& allowed) {
  if (outcome.exceeds_core) return true;
  for (std::size_t i = 0; i < kFaults; ++i) {
    const auto bound = allowed.count(static_cast<Fault>(i));
    if (bound && outcome.faults[i] > *bound) return false;
  }
  if (!outcome.refusal.empty() && !outcome.refusal_expected) return !allowed.stated;
  return outcome.rays > 0 && (!allowed.stated || outcome.distance <= allowed.distance);
}

std::string text_of(const Outcome& outcome, const Allowed& allowed) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < kFaults; ++i) {
    const auto bound = allowed.count(static_cast<Fault>(i));
    if (outcome.faults[i] == 0 && bound.value_or(0) == 0) continue;
    parts.push_back(fmt::format("{} {}", kTexts[i].name, outcome.faults[i]));
    if (bound) parts.back() += fmt::format(" (of {} allowed)", *bound);
  }
  if (parts.empty()) parts.push_back("nothing wrong");
  if (outcome.distance > 0) {
    parts.push_back(fmt::format("distance {:.1e}", outcome.distance));
    if (allowed.stated) parts.back() += fmt::format(" (of {:.1e})", allowed.distance);
  }
  if (outcome.dropped > 0) parts.push_back(fmt::format("stack_full {}", outcome.dropped));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace dynrt::host::stress
