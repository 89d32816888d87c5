// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core of a program sdram_frames_NAME, which is compiled once for each of several cores.
#pragma once

#include <string>

#include "sdram/sdram_frame.h"

namespace dynrt::verif {

/// The one frame that the program is asked for.
struct SdramRequest {
  std::string scene;
  host::FrameOptions options;
  double core_nanoseconds = 0;  ///< of a clock of the core
  bool display = true;          ///< one shows its pixels all the while
  unsigned mhz = 0;             ///< of the SDRAM: 133 or 100
  std::string schedules;
};

/// Throws UserError for a scene that the core cannot render, and for schedules that cannot be read.
SdramFrame frame_of(const SdramRequest& request);

}  // namespace dynrt::verif
