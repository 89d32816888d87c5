// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about a frame that exceeds its configuration.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kExceeded[] =
    "{} needs {} {}, and configuration {}, made for '{}', has {}; specialise again for this scene "
    "and all its frames";

}  // namespace dynrt::host::messages
