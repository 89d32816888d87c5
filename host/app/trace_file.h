// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Guards the waveforms of a frame: the file is removed unless the frame was rendered, or the board
// never finished, which is what one wants to look at. Without --trace it does nothing.
#pragma once

#include <optional>
#include <string>

#include "host/picture/output_file.h"

namespace dynrt::host {

class TraceFile {
 public:
  explicit TraceFile(const std::string& path) {
    if (path.empty()) return;
    waves_.emplace(path);
    hierarchy_.emplace(path + ".hier");
  }
  void keep() {
    if (waves_) waves_->keep();
  }

 private:
  std::optional<UnfinishedFile> waves_;
  std::optional<UnfinishedFile> hierarchy_;  ///< lies beside the waveforms until they are complete
};

}  // namespace dynrt::host
