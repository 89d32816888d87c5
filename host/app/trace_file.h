// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Guards the waveforms of a frame: the file is removed unless the frame was rendered, or the board
// never finished, which is what one wants to look at. Without --trace it does nothing.
#pragma once

#include <filesystem>
#include <string>

#include "host/render/write_image.h"

namespace dynrt::host {

class TraceFile {
 public:
  /// Throws UserError if the file cannot be written.
  explicit TraceFile(std::string path) : path_(std::move(path)) {
    if (!path_.empty()) check_output_path(path_);
  }
  ~TraceFile() {
    std::error_code ignored;
    if (!keep_ && !path_.empty()) std::filesystem::remove(path_, ignored);
  }
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  void keep() { keep_ = true; }

 private:
  std::string path_;
  bool keep_ = false;
};

}  // namespace dynrt::host
