// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the window.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kPortsInUse[] =
    "the ports {} to {} of this computer are all in use; name another port";
inline constexpr char kNoPageFile[] = "{}: the page of the window needs this file; {}";
inline constexpr char kNotOurMessage[] = "this is no message of the window: {}";

}  // namespace dynrt::host::messages
