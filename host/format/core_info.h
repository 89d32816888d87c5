// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// All that the host knows of a core: the keys of its configuration, the words that its memory and
// its frame registers take, and the core that it was specialised from. A board hands it out;
// images, trees and reports hold it and copy nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "configs/core_configuration.h"
#include "host/format/frame_words.h"
#include "host/format/memory_format_of.h"

namespace dynrt::host {

struct CoreInfo : CoreConfiguration {
  const MemoryFormat* format = &kShippedFormat;  ///< its numbers, and how its memory holds them
  /// The words of its FRAME registers.
  std::vector<std::uint32_t> (*frame_words)(const FrameConfig&) = frame_words_of<config::shipped>;
  /// The configuration that it was specialised from, if it was.
  std::shared_ptr<const CoreConfiguration> general = {};

  /// Every key as by default, with the numbers of a format.
  explicit CoreInfo(const MemoryFormat& of_format) : format(&of_format) {
    exponent_bits = format->exponent_bits;
    mantissa_bits = format->mantissa_bits;
    rounding = format->rounding;
  }
  CoreInfo() : CoreInfo(kShippedFormat) {}
  explicit CoreInfo(CoreConfiguration keys) : CoreConfiguration(std::move(keys)) {}

  /// Whether it was specialised, and may hold less than other scenes need.
  bool is_specialised() const { return made_for != CoreConfiguration{}.made_for; }
  /// The fewest lines that a frame may ask for: of list entries, a line in each way.
  unsigned least_lines() const { return ways * entries_of_line(line_nodes); }
  /// Of a line of the second level of cache.
  unsigned second_line_bytes() const { return dynrt::second_line_bytes(line_nodes, port_bytes); }
  unsigned pixel_bytes() const { return pixel_bits / 8; }
  /// Pixels from the beginning of an image's row to that of the next, in the banks.
  unsigned pitch(unsigned width) const {
    return memory == MemoryPath::kPort ? row_pitch(width) : width;
  }
  bool is_watertight() const { return triangle_test == TriangleTest::kWatertight; }
  /// Whether it tests an object's box in the world (units/world_box.h), which then is in the
  /// memory.
  bool tests_world_box() const { return dynrt::tests_world_box(origins, levels); }
};

/// The host's knowledge of the core of struct C, which a test may have made: the keys that the
/// units know are those of C.
template <class C>
CoreInfo core_info_of(CoreConfiguration keys = configuration_of<C>()) {
  CoreInfo core(std::move(keys));
  core.format = &kMemoryFormatOf<typename C::Real>;
  core.frame_words = frame_words_of<C>;
  return core;
}

/// The host's knowledge of the core of a listed configuration, whose struct is C: every key.
template <class C>
CoreInfo core_info_of_listed(std::string_view name) {
  return core_info_of<C>(*listed_configuration(name));
}

}  // namespace dynrt::host
