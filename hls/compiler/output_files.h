// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The files that a run writes: all of them or none. Each is written beside its place first and
// moved there when every one could be written.
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

  /// The path "-" is the terminal, an empty one nowhere. Throws Error where the file cannot be
  /// written.
  void add(const std::string& path, const std::string& text);
  void commit();

 private:
  std::vector<std::string> paths_;
  std::string terminal_;
};

}  // namespace hlsc
