// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one exception for mistakes of the user: a bad file, flag or folder. The program prints its
// message, one sentence naming the file, line or node, and exits with a non-zero code. Every other
// exception is a defect of dynrt itself. A room has its messages in one header, *_messages.h, as
// fmt's format strings.
#pragma once

#include <fmt/format.h>

#include <stdexcept>

namespace dynrt::host {

struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class... Args>
[[noreturn]] void refuse(fmt::format_string<const Args&...> message, const Args&... args) {
  throw UserError(fmt::format(message, args...));
}

}  // namespace dynrt::host
