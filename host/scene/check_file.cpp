// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/scene/scene_messages.h"

namespace dynrt::host {

namespace {

std::ifstream open_file(const std::string& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    wording::fail(wording::kNotAFile, path);
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) wording::fail(wording::kUnreadable, path, std::strerror(errno));
  const bool is_empty = file.peek() == std::ifstream::traits_type::eof();
  if (file.bad()) wording::fail(wording::kUnreadable, path, std::strerror(errno));
  if (is_empty) wording::fail(wording::kEmptyFile, path);
  return file;
}

}  // namespace

void require_file(const std::string& path) { open_file(path); }

std::string read_file(const std::string& path) {
  std::ifstream file = open_file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) wording::fail(wording::kUnreadable, path, std::strerror(errno));
  return text;
}

}  // namespace dynrt::host
