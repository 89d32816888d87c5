// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "output_files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "error.h"

namespace hlsc {
namespace {

constexpr char kPartial[] = ".partial";
constexpr char kCannotWrite[] =
    "cannot write {}: {}; name a file in a folder that exists and can be written";

}  // namespace

OutputFiles::~OutputFiles() {
  std::error_code ignored;
  for (const std::string& path : paths_) std::filesystem::remove(path + kPartial, ignored);
}

void OutputFiles::add(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  if (path == "-") {
    terminal_ += text;
    return;
  }
  if (std::filesystem::is_directory(path)) {
    throw Error({}, fmt::format(kCannotWrite, path, std::strerror(EISDIR)));
  }
  paths_.push_back(path);
  std::ofstream file(path + kPartial);
  file << text;
  file.close();
  if (!file) throw Error({}, fmt::format(kCannotWrite, path, std::strerror(errno)));
}

void OutputFiles::commit() {
  for (const std::string& path : paths_) {
    std::error_code error;
    std::filesystem::rename(path + kPartial, path, error);
    if (error) throw Error({}, fmt::format(kCannotWrite, path, error.message()));
  }
  paths_.clear();
  fmt::print("{}", terminal_);
}

}  // namespace hlsc
