// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the boards.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kNoConfigurationFile[] = "configuration {}: there is no such file";

}  // namespace dynrt::host::messages
