// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one exception for mistakes of the user: a bad file, flag or folder. The program prints its
// message, one sentence that names the file, line or node, and exits with a non-zero code. Every
// other exception is a defect of dynrt itself. A message stands where it is thrown; one that
// several files share stands in the folder's *_messages.h.
#pragma once

#include <fmt/format.h>

#include <stdexcept>

namespace dynrt::host {

struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UserError with a message in fmt's format.
template <class... Args>
[[noreturn]] void refuse(fmt::format_string<const Args&...> message, const Args&... args) {
  throw UserError(fmt::format(message, args...));
}

}  // namespace dynrt::host
