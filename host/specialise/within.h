// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Whether a scene, as it is in some frame, stays inside a core that was made for what was analysed
// before.
#pragma once

#include <optional>
#include <string>

#include "host/error.h"
#include "host/format/core_info.h"
#include "host/specialise/scene_needs.h"

namespace dynrt::host {

/// A key of the configuration, what a frame needs of it, and what the core has.
struct Excess {
  std::string key, needs, has;
};

/// The first key that is exceeded.
std::optional<Excess> excess(const SceneNeeds& needs, const CoreInfo& core);

/// A frame that its core was not made for.
struct Exceeded : UserError {
  using UserError::UserError;
};

/// Throws Exceeded, with the key and both values. `frame`: how the frame is called.
[[noreturn]] void refuse_excess(const Excess& over, const CoreInfo& core, const std::string& frame);
/// Does so if there is something to refuse.
void check_within(const SceneNeeds& needs, const CoreInfo& core, const std::string& frame);

}  // namespace dynrt::host
