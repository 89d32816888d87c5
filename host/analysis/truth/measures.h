// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Measures the errors of a frame: compares its hit records and pixels with the truth. The table of
// measures() explains each measure, and a test compares docs/reference/measures.md with it.
//
// A frame has hit records of primary rays only. The pixels show the results of light and reflection
// rays; these are judged where the primary ray hit correctly, so that a wrong pixel is their error.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "host/analysis/truth/frame_truth.h"
#include "host/layout/matrix_owners.h"
#include "host/render/frame.h"

namespace dynrt::host {

struct MeasureDefinition {
  const char* group;  ///< "primary", "light", "reflection": the rays; "image"
  const char* name;
  const char* unit;
  const char* better;  ///< "less" or "more"; "-" if it is no error
  const char* meaning;
};

/// All, group by group.
std::span<const MeasureDefinition> measures();
/// As rows of a Markdown table.
std::string measures_table();

/// The way a board shades a frame.
TruthShading shading_of(const CoreInfo& core, const FrameConfig& frame);

/// The value of a number of the board's format (MemoryFormat::number).
using NumberOf = std::function<double(std::uint32_t bits)>;

/// {group: {name: figure}} of all groups that the frame has: "light" only where there are light
/// rays, "reflection" likewise. A figure that is not known is null. `frame` is of the size of
/// `truth` and has hit records.
nlohmann::ordered_json measure(const Truth& truth, const TruthFrame& expected, const Frame& frame,
                               const MatrixOwners& owners, const NumberOf& number);

/// The picture of the differences: 16 times the difference of each channel, so that one level is
/// visible; 0x00BBGGRR.
std::vector<std::uint32_t> difference_picture(std::span<const std::uint32_t> expected,
                                              std::span<const std::uint32_t> pixels);

}  // namespace dynrt::host
