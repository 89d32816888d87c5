// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Flags that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/app/core_clock.h"
#include "host/board/configurations.h"
#include "host/render/render.h"
#include "host/scene/camera.h"

namespace dynrt::host {

/// A material that reflects this part of the light, 0 to 1.
struct Mirror {
  std::string material;
  double part = kMirrorShare;
};

/// The scene, the picture's size, the camera and the light.
struct SceneArguments {
  std::string scene;
  unsigned width = 512, height = 384;  ///< in pixels
  CameraOverrides camera;
  std::vector<PointLight> lights;  ///< beside the scene's own
  std::vector<Mirror> mirrors;
  std::map<std::string, std::vector<std::string>> given;  ///< flags, and their values as written

  void add_to(CLI::App& command, bool scene_required);
  /// Of a frame of that size. Throws FrameRefused for one that no frame has.
  FrameOptions frame_options() const;
};

/// Without a pixel or an interrupt, after which a frame is given up.
inline constexpr std::uint64_t kTimeout = 10'000'000;

/// Of the flag --board, where it takes hardware only, and where it takes the model too.
std::string hardware_help();
std::string board_help();

/// The clocks of the memory behind a core's port.
struct MemoryArguments {
  std::optional<unsigned> latency, row_clocks;

  void add_to(CLI::App& command);
  void put_into(FrameOptions& options) const;
};

/// How a frame is rendered, and the files that are written.
struct FrameArguments {
  std::string configuration = kDefaultConfiguration;
  std::optional<unsigned> packets, lines, reflections;
  std::string order = "morton";
  bool uncompressed = false;
  ClockFlags clock;
  MemoryArguments memory;
  std::optional<std::uint64_t> timeout;  ///< clocks; without the flag kTimeout
  std::string out;
  std::string json;

  void add_to(CLI::App& command, const std::string& default_out,
              const std::string& about_out = "image to write, .png or .exr");
  /// Checks everything but the outputs that can be checked before a board is open.
  FrameOptions options(const SceneArguments& scene) const;
  /// Throws UserError for a timeout on a board that has no clock.
  void check_timeout(const std::string& board) const;
};

/// Frames of a walk without --frames.
inline constexpr unsigned kWalkFrames = 24;

/// The part of an animation that a walk shows, in seconds.
struct SpanArguments {
  std::optional<double> from, to;

  void add_to(CLI::App& command);
};

/// Adds --config to a command.
void add_configuration_flag(CLI::App& command, std::string& configuration);
/// Adds --packets and --lines to a command.
void add_limit_flags(CLI::App& command, std::optional<unsigned>& packets,
                     std::optional<unsigned>& lines);
/// Adds --json to a command.
void add_json_flag(CLI::App& command, std::string& json);

/// For flags that take a number: the mistake in the text, or an empty string.
std::string not_a_count(const std::string& text);
std::string not_a_number(const std::string& text);

}  // namespace dynrt::host
