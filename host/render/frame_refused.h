// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// An option of a frame that the core cannot follow.
#pragma once

#include <string>
#include <utility>

#include "host/error.h"

namespace dynrt::host {

struct FrameRefused : UserError {
  FrameRefused(std::string refused_option, const std::string& sentence)
      : UserError(sentence), option(std::move(refused_option)) {}

  std::string option;  ///< the flag that gives it; "size" for width and height
};

}  // namespace dynrt::host
