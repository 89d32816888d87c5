// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one exception for mistakes of the user: a bad file, flag or folder. The program prints its
// message, one sentence naming the file, line or node, and exits with a non-zero code. Everything
// else that is thrown is a defect of dynrt itself.
#ifndef DYNRT_HOST_ERROR_H_
#define DYNRT_HOST_ERROR_H_

#include <stdexcept>

namespace dynrt::host {

struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace dynrt::host

#endif  // DYNRT_HOST_ERROR_H_
