// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a walk: frame_0000.png and so on, and walk.json, which identifies the walk and
// holds the figures of each frame. Every file is either complete or absent, so an interrupted walk
// continues where it stopped.
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

/// Throws UserError, before any work is done, if the folder cannot hold frames.
void check_walk_folder(const std::string& path);

/// Identifies a walk: its flags and their values, as text. A message names the first flag whose
/// value differs.
using WalkSettings = std::vector<std::pair<std::string, std::string>>;
/// Name of the setting that holds the scene's fingerprint. Messages do not show its value.
inline constexpr char kSceneContent[] = "scene content";
/// Of a board that exists: another bitstream may have another.
inline constexpr char kBoardClock[] = "clock of the board";

class WalkFolder {
 public:
  /// Reads the frames of an earlier run with the same settings; with `again`, removes the frames of
  /// any run. Throws UserError for frames of another walk. Writes nothing yet.
  WalkFolder(std::string path, WalkSettings settings, bool again);

  /// The record of a frame that is already there, complete and of the right size.
  std::optional<WalkRecord> kept(unsigned frame, unsigned width, unsigned height) const;
  void write(const Frame& frame, const WalkRecord& record);
  /// Writes walk.json; call it after the last frame.
  void save();

  std::string name(unsigned frame) const;
  void remove() const;  ///< with all files of the walk; the folder stays if it holds others

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
