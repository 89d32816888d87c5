// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Guards the waveforms of a frame: removes the file on an error, unless the board never finished,
// as the waveforms then show why. Without --trace it does nothing.
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
  std::optional<UnfinishedFile> hierarchy_;  ///< temporary file until the waveforms are complete
};

}  // namespace dynrt::host
