// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about a frame that exceeds its configuration.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kExceeded[] =
    "{} needs {} {}, and configuration {}, made for '{}', has {}; specialise again for this scene "
    "and all its frames";
inline constexpr char kOrOnGeneral[] =
    "{}, or add --general-if-exceeded to render it on the general core";

}  // namespace dynrt::host::messages
