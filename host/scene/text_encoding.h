// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Text files that are not plain ASCII: editors on Windows write UTF-16, or UTF-8 behind a mark.
#pragma once

#include <string>

namespace dynrt::host {

/// The text as UTF-8 without a byte order mark. A mark at its beginning names its encoding (UTF-8
/// or UTF-16 of either byte order); text without one stays as it is. Half of a surrogate pair
/// becomes U+FFFD.
std::string to_utf8(std::string text);

}  // namespace dynrt::host
