// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The errors of a stress case: their kinds, their numbers and the allowed numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace dynrt::host::stress {

/// Each counts rays.
enum class Fault : std::uint8_t {
  kLost,       ///< hits something and is reported to hit nothing
  kInvented,   ///< hits nothing and is reported to hit something
  kWrong,      ///< is reported to hit a triangle that is not where the nearest is
  kTwice,      ///< hits more than one of several triangles that are tested one by one
  kDifferent,  ///< must give the same bits as another ray or frame and does not
  kUnsaid,     ///< is lost by a full stack that the counter does not count
  kAccepted,   ///< belongs to a scene that the host must refuse and does not
};
inline constexpr std::size_t kFaults = 7;

struct FaultText {
  const char* name;
  const char* meaning;
};
/// In the order of Fault.
std::span<const FaultText, kFaults> fault_texts();

/// No error is allowed unless a case states it.
struct Allowed {
  std::uint64_t lost = 0, invented = 0, wrong = 0, twice = 0;
  double distance = 0x1p-10;  ///< relative error of the hit distance, at most
  /// Says whether the bounds are known: they were measured in the shipped format with the
  /// arithmetic of four cores (bounds.h), and others have no bounds.
  bool stated = true;

  /// The bound of an error. It is always 0 for different bits, uncounted losses and accepted
  /// scenes; the other errors have no bound if none is stated.
  std::optional<std::uint64_t> count(Fault fault) const;
};

struct Outcome {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  std::array<std::uint64_t, kFaults> faults{};
  double distance = 0;               ///< largest relative error of a hit distance
  std::uint64_t dropped = 0;         ///< pushes onto full stacks, as the core counts them
  std::uint64_t digest = kNoDigest;  ///< of every hit record and pixel
  double seconds = 0;
  std::string refusal;  ///< the host's message
  bool refusal_expected = false;
  bool exceeds_core = false;  ///< a specialised core was made for less: the refusal has the key

  static constexpr std::uint64_t kNoDigest = 0xcbf29ce484222325;  ///< FNV-1a of nothing

  std::uint64_t& operator[](Fault fault) { return faults[static_cast<std::size_t>(fault)]; }
  std::uint64_t operator[](Fault fault) const { return faults[static_cast<std::size_t>(fault)]; }
  void digest_word(std::uint32_t word);
};

bool within(const Outcome& outcome, const Allowed& allowed);

/// "lost 2 (of 5 allowed), distance 1.2e-05 (of 1.0e-03)": the errors and their bounds.
std::string text_of(const Outcome& outcome, const Allowed& allowed);

}  // namespace dynrt::host::stress
