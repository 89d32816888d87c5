// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one exception for what a user can mend: bad input, bad flags, a board that does not answer.
#pragma once

#include <stdexcept>

namespace dynrt::host {

/// One sentence that names the file, line or node, what is wrong and what would be right. The
/// program prints it on stderr and ends with exit code 1.
struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace dynrt::host
