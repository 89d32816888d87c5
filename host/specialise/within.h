// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tells whether a frame of a scene fits a core that was made for the frames analysed before.
#pragma once

#include <optional>
#include <string>

#include "host/error.h"
#include "host/format/core_info.h"
#include "host/specialise/scene_needs.h"

namespace dynrt::host {

/// A key of the configuration, the value that a frame needs, and the core's value.
struct Excess {
  std::string key, needs, has;
};

/// The first key that is exceeded.
std::optional<Excess> excess(const SceneNeeds& needs, const CoreInfo& core);

/// A frame that its core was not made for.
struct Exceeded : UserError {
  using UserError::UserError;
};

/// Throws Exceeded, with the key and both values. `frame` is the frame's name in the message.
[[noreturn]] void refuse_excess(const Excess& over, const CoreInfo& core, const std::string& frame);
/// The same, if there is an excess.
void check_within(const SceneNeeds& needs, const CoreInfo& core, const std::string& frame);

}  // namespace dynrt::host
