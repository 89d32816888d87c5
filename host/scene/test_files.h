// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of host/scene: the files of testdata/, files written for one test, and the
// sentence of the UserError that something throws.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>

#include "host/error.h"
#include "host/scene/check_file.h"
#include "host/test_folder.h"

namespace dynrt::host {

inline std::string test_data(const std::string& name) {
  return std::string(DYNRT_TESTDATA_FOLDER) + "/" + name;
}

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

inline std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what << " is not there";
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

}  // namespace dynrt::host
