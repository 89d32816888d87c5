// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kUnreadable[] = "{}: cannot read this file ({})";

std::ifstream open_file(const std::string& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    refuse("{}: this path is not a file; give the path of a file", path);
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(kUnreadable, path, std::strerror(errno));
  const bool is_empty = file.peek() == std::ifstream::traits_type::eof();
  if (file.bad()) refuse(kUnreadable, path, std::strerror(errno));
  if (is_empty) refuse("{}: the file is empty", path);
  return file;
}

}  // namespace

void require_file(const std::string& path) { open_file(path); }

std::string read_file(const std::string& path) {
  std::ifstream file = open_file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) refuse(kUnreadable, path, std::strerror(errno));
  return text;
}

}  // namespace dynrt::host
