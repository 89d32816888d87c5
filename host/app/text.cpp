// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "host/error.h"

namespace dynrt::host {

void say(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    refuse("cannot print the report ({}); free some space or redirect the output to another place",
           std::strerror(errno));
  }
}

}  // namespace dynrt::host
