// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of host/scene: the files of testdata/ and files written for one test.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "host/scene/check_file.h"
#include "host/test_error.h"
#include "host/test_folder.h"

namespace dynrt::host {

inline std::string test_data(const std::string& name) {
  return std::string(DYNRT_TESTDATA_FOLDER) + "/" + name;
}

inline std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what << " is not there";
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

}  // namespace dynrt::host
