// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The folder where the program keeps what takes it long to find, each under a key of all that
// decides it.
#pragma once

#include <filesystem>
#include <string>

namespace dynrt::host {

/// The folder that DYNRT_CACHE names, else dynrt in the user's cache folder; empty if there is
/// neither.
std::filesystem::path cache_folder();

/// The SHA-256 of a text, in hexadecimal digits.
std::string digest(const std::string& text);

/// While this object lives, no other program holds the same file; waits for one that does. The file
/// stays. A file system without locks, or a folder that cannot be written, locks nothing.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_;
};

}  // namespace dynrt::host
