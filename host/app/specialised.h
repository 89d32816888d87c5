// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// --specialise of the commands that render: the core made for the scene, built once.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "host/app/special_core.h"
#include "host/specialise/within.h"

namespace dynrt::host {

/// The configuration that renders a scene, and the general one that can replace it.
struct ChosenCore {
  /// A name or a file, or empty if the user named none; with --specialise from the cache, if it is
  /// there.
  std::string configuration;
  std::string general;  ///< the same without --specialise, if the user named a general one
};

struct SpecialiseFlags {
  bool specialise = false;
  bool general_if_exceeded = false;

  /// Adds --specialise and, if frames may differ from those that were analysed,
  /// --general-if-exceeded.
  void add_to(CLI::App& command, bool may_exceed);

  /// The scene that these flags may ask for several times.
  SceneFile file(const SceneArguments& scene) const {
    return SceneFile(scene, specialise || general_if_exceeded);
  }

  /// The configurations to render with on a board; builds them if needed. Of `wishes` only the keys
  /// to keep and the frames of a walk count. Throws UserError with the reason if a configuration
  /// cannot be made, or if the board has a core of its own.
  ChosenCore choose(SceneFile& scene, const FrameArguments& frame, const std::string& board,
                    SpecialiseWishes wishes = {}) const;

  /// Throws the error, with advice, unless the general core may replace the specialised one.
  void refuse_unless_general(const Exceeded& over) const;

 private:
  const CLI::App* command_ = nullptr;
};

}  // namespace dynrt::host
