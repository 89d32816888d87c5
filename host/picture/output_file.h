// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files that are either whole or not there: each is written under a temporary name beside its own
// and renamed when it is complete. What is unfinished is removed on an error and when the program
// is interrupted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace dynrt::host {

/// A file that is removed unless it is kept: by the destructor, and by SIGHUP, SIGINT and SIGTERM.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  const std::string& path() const { return path_; }
  void keep();

 private:
  const std::string path_;
  std::size_t slot_;
  bool kept_ = false;
};

/// The name of the file that a process wrote when it was killed, if this is what it left
/// half-written of it; else empty.
std::string abandoned(const std::filesystem::path& file);

/// A file that the user asked for, by which flag; no path: not asked for.
struct Output {
  const char* flag;
  std::string path;
};

/// Throws UserError, before any work is done, for a folder that does not exist or cannot be
/// written, and for two outputs of one name. Removes what killed processes have left of them.
void check_outputs(std::span<const Output> outputs);
void check_output_path(const std::string& path);

/// Whether a file is there and its last bytes are these.
bool ends_with(const std::string& path, std::string_view end);

/// Throws UserError where a file that has been written does not end so: not every library notices
/// that a disk is full.
void check_end(const std::string& file, std::string_view end, const std::string& path);

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason);

/// Calls `write` with a temporary name of the same extension, in the same folder.
void write_whole(const std::string& path,
                 const std::function<void(const std::string& temporary)>& write);

void write_text(const std::string& path, const std::string& text);

}  // namespace dynrt::host
