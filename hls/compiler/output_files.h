// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The files that a run writes: all of them or none. Each is first written under a temporary name in
// the same folder, and renamed once all are written.
#pragma once

#include <string>
#include <vector>

namespace hlsc {

class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// The path "-" is the terminal; an empty path writes nothing. Throws Error if the file cannot be
  /// written.
  void add(const std::string& path, const std::string& text);
  void commit();

 private:
  std::vector<std::string> paths_;
  std::string terminal_;
};

}  // namespace hlsc
