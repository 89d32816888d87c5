// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The scene that a command renders, read from its file once.
#pragma once

#include <optional>

#include "host/app/arguments.h"
#include "host/scene/scene.h"

namespace dynrt::host {

class SceneFile {
 public:
  /// Reads nothing yet. With `again` the scene is kept, so that several cores may have a copy.
  explicit SceneFile(SceneArguments arguments, bool again = false)
      : arguments_(std::move(arguments)), again_(again) {}

  const SceneArguments& arguments() const { return arguments_; }

  /// The scene of the file, without the lights and mirrors of the flags; reads it if need be.
  /// Throws UserError.
  const Scene& scene();
  /// The same, to be changed by the caller; without `again` it is moved out.
  Scene take();
  /// The time that reading took.
  double seconds() const { return seconds_; }

 private:
  SceneArguments arguments_;
  bool again_;
  std::optional<Scene> scene_;
  double seconds_ = 0;
};

}  // namespace dynrt::host
