// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// --specialise of the commands that render: the core made for the scene, built once.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/app/arguments.h"
#include "host/specialise/within.h"

namespace dynrt::host {

/// The configuration that renders a scene without being made for it: thesis, for a scene with light
/// or mirrors whitted, for one of other primitives than triangles primitives.
std::string general_configuration(const SceneArguments& scene);

/// The configuration that a scene is rendered with, and the general one that stands in for it.
struct ChosenCore {
  std::string
      configuration;    ///< a name or a file; with --specialise from the cache, if it is there
  std::string general;  ///< the same without --specialise, if the user named a general one
};

struct SpecialiseFlags {
  bool specialise = false;
  bool general_if_exceeded = false;

  /// Adds --specialise and, where frames may differ from what was analysed, --general-if-exceeded.
  void add_to(CLI::App& command, bool may_exceed);

  /// What to render with; builds it, where it must be. `more`: flags of scripts/specialise. Throws
  /// UserError with the reason if it cannot be made.
  ChosenCore choose(const SceneArguments& scene, const FrameArguments& frame,
                    const std::vector<std::string>& more = {}) const;

  /// Throws what was exceeded, and what to do about it, unless the general core is to stand in.
  void refuse_unless_general(const Exceeded& over) const;

 private:
  const CLI::App* command_ = nullptr;
};

/// What `prepare` gives on the board that `open` makes of a configuration; on the general one where
/// the scene exceeds the other and the flags allow it. Gives both.
template <class Open, class Prepare>
auto prepare_on(const SpecialiseFlags& flags, const ChosenCore& core, Open&& open,
                Prepare&& prepare) {
  auto board = open(core.configuration);
  try {
    auto prepared = prepare(board->core());
    return std::pair(std::move(board), std::move(prepared));
  } catch (const Exceeded& over) {
    flags.refuse_unless_general(over);
  }
  board = open(core.general);
  auto prepared = prepare(board->core());
  return std::pair(std::move(board), std::move(prepared));
}

}  // namespace dynrt::host
