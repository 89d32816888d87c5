// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of host/scene: the files of testdata/, files written for one test, and the
// sentence of the UserError that something throws.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "host/error.h"
#include "host/scene/check_file.h"

namespace dynrt::host {

inline std::string test_data(const std::string& name) {
  return std::string(DYNRT_TESTDATA_FOLDER) + "/" + name;
}

/// A folder of one test's own, gone at its end.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dynrt-scene-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  ~TestFolder() { std::filesystem::remove_all(path_); }

  std::string path(const std::string& name) const { return path_ + "/" + name; }

  std::string write(const std::string& name, std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

 private:
  std::string path_;
};

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
