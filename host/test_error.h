// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The sentence of the UserError that something throws, for tests.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "host/error.h"

namespace dynrt::host {

/// The text of the UserError; fails the test when there is none or it is no single sentence.
inline std::string user_error(const std::function<void()>& act) {
  try {
    act();
  } catch (const UserError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text;
  }
  ADD_FAILURE() << "no UserError";
  return {};
}

}  // namespace dynrt::host
