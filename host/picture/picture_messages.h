// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about pictures and other files that cannot be written or read.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kCannotWrite[] =
    "{}: cannot write this file ({}); name a file in a folder that can be written";

}  // namespace dynrt::host::messages
