// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files that are either complete or absent: each is written under a temporary name in the same
// folder and renamed when it is complete. An unfinished file is removed on an error and when the
// program is interrupted.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/at_interrupt.h"

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
  static void remove(const void* path);

  const std::string path_;
  std::optional<AtInterrupt> interrupted_;  ///< until it is kept
};

/// If this is the half-written file of a killed process, the name of the file that it wrote; else
/// empty.
std::string abandoned(const std::filesystem::path& file);

/// A file that the user asked for, and its flag; without a path: not asked for.
struct Output {
  const char* flag;
  std::string path;
  bool is_picture = false;
};

/// Throws UserError, before any work is done, for a picture of an unknown format, for a folder that
/// does not exist or cannot be written, and for two outputs of one name. Removes their half-written
/// files of killed processes.
void check_outputs(std::span<const Output> outputs);
void check_output_path(const std::string& path);

/// Tells whether a file exists and ends with these bytes.
bool ends_with(const std::string& path, std::string_view end);

/// Throws UserError if a written file does not end with these bytes, as some libraries do not
/// notice that a disk is full.
void check_end(const std::string& file, std::string_view end, const std::string& path);

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason);

/// Calls `write` with a temporary name of the same extension, in the same folder.
void write_whole(const std::string& path,
                 const std::function<void(const std::string& temporary)>& write);

/// Throws UserError if the file cannot be written, as where the disk is full.
void write_bytes(const std::string& path, std::string_view bytes);
void write_text(const std::string& path, const std::string& text);

}  // namespace dynrt::host
