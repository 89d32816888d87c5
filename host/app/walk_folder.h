// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The folder that a walk's frames are written to, frame_0000.png and on, and walk.json beside them,
// which says of which walk they are and what was measured of each. Every file is whole or not
// there, so that an interrupted walk goes on where it stopped.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/app/walk.h"
#include "host/render/frame.h"

namespace dynrt::host {

/// Throws UserError, before any work is done, for a place where no frames can be written.
void check_walk_folder(const std::string& path);

/// What makes frames those of one walk, in words: flags and their values. The first whose value
/// differs is named.
using WalkSettings = std::vector<std::pair<std::string, std::string>>;
/// Of the setting that holds the scene's fingerprint, whose value says nothing to the user.
inline constexpr char kSceneContent[] = "scene content";

class WalkFolder {
 public:
  /// Takes over what a walk of the same settings has left; `again`: removes what any has left. Else
  /// throws UserError for frames of another walk. Writes nothing yet.
  WalkFolder(std::string path, WalkSettings settings, bool again);

  /// Of a frame that is already there, whole and of the right size.
  std::optional<WalkRecord> kept(unsigned frame, unsigned width, unsigned height) const;
  void write(const Frame& frame, const WalkRecord& record);
  /// What is told of the frames; to be called after the last one.
  void save();

  std::string name(unsigned frame) const;
  void remove() const;  ///< with all that a walk writes; the folder stays if it holds more

 private:
  using Clock = std::chrono::steady_clock;
  void read();
  std::vector<std::filesystem::path> files() const;
  void remove_files(const std::function<bool(const std::filesystem::path&)>& which) const;

  const std::string path_;
  const WalkSettings settings_;
  nlohmann::ordered_json records_ = nlohmann::ordered_json::object();  ///< by the frame's name
  Clock::time_point saved_{};
  Clock::duration save_takes_{};
};

nlohmann::ordered_json json_of(const WalkRecord& record);

}  // namespace dynrt::host
