// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every unit in test/errors is refused with the text that its comment gives. A last line
// "..." stands for whatever clang adds.
#include "error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "frontend/read_unit.h"

namespace hlsc {
namespace {

namespace fs = std::filesystem;

const std::string kHls = HLSC_TEST_HLS;

UnitSource source_of(const std::string& header, const std::string& unit = "errors::Unit") {
  UnitSource source;
  source.unit = unit;
  source.header = header;
  source.module = "unit";
  source.folders = {kHls + "/lowered", kHls + "/include", kHls + "/compiler/test"};
  return source;
}

std::string error_text(const UnitSource& source) {
  try {
    read_unit(source);
  } catch (const Error& error) {
    return error.text();
  }
  return "no error";
}

std::string expected_text(const fs::path& file) {
  constexpr char kMark[] = "// error: ";
  std::ifstream lines(file);
  std::string line;
  while (std::getline(lines, line) && !line.starts_with(kMark)) {
  }
  std::string text = line.substr(std::min(line.size(), sizeof kMark - 1));
  while (std::getline(lines, line) && line.starts_with("//")) text += "\n" + line.substr(3);
  return text;
}

std::vector<std::string> error_units() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kHls + "/compiler/test/errors")) {
    if (entry.path().extension() == ".h") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Refused : public ::testing::TestWithParam<std::string> {};

TEST_P(Refused, WithItsText) {
  const std::string header = "errors/" + GetParam() + ".h";
  EXPECT_EQ(error_text(source_of(header)), expected_text(kHls + "/compiler/test/" + header));
}

INSTANTIATE_TEST_SUITE_P(Units, Refused, ::testing::ValuesIn(error_units()),
                         [](const auto& param) { return param.param; });

TEST(RefusedInput, HeaderMissing) {
  EXPECT_EQ(error_text(source_of("errors/nowhere.h")),
            "hlsc: error: no folder given with -I holds the header errors/nowhere.h; add the "
            "folder that holds it");
}

TEST(RefusedInput, UnitMissing) {
  EXPECT_EQ(error_text(source_of("errors/in_never_read.h", "errors::Nobody")),
            "errors/in_never_read.h: error: the type errors::Nobody cannot be used as a unit; give "
            "--unit the full name of a complete type that errors/in_never_read.h defines. clang "
            "says: no type named 'Nobody' in namespace 'errors'");
}

TEST(RefusedInput, WideLeaf) {
  const std::string text = error_text(source_of("rejected/wide_leaf.h"));
  EXPECT_NE(text.find("a leaf has at most 64 bits"), std::string::npos) << text;
  EXPECT_NE(text.find("rejected/wide_leaf.h:9:21: note:"), std::string::npos) << text;
}

TEST(RefusedInput, ClangMissing) {
  UnitSource source = source_of("errors/in_never_read.h");
  source.clang = "clang++-from-nowhere";
  EXPECT_EQ(error_text(source),
            "hlsc: error: clang++-from-nowhere is not installed or not on the PATH; install the "
            "package clang-19 or name it with --clang");
}

TEST(RefusedInput, LanguageMissing) {
  UnitSource source = source_of("errors/in_never_read.h");
  source.folders[0] = kHls + "/native";
  EXPECT_EQ(error_text(source),
            "hlsc: error: no folder given with -I holds hls/ports.h for lowering; put the folder "
            "hls/lowered of the language first");
}

}  // namespace
}  // namespace hlsc
