// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the stress cases.
#pragma once

namespace dynrt::host::stress::messages {

inline constexpr char kNotInTable[] = "this build's table of configurations lacks '{}'";
inline constexpr char kNoCase[] =
    "there is no stress case or group '{}'; give one of these, or the part before the slash: {}";

}  // namespace dynrt::host::stress::messages
