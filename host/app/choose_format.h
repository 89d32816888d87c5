// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bits of the numbers of a core made for a scene, by the error that the user allows.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/app/arguments.h"
#include "host/specialise/decide.h"

namespace dynrt::host {

struct FormatWish {
  std::optional<double> max_error;
  std::string measure;  ///< that it bounds, or empty: as `dynrt choose` has it

  void add_to(CLI::App& command);
  /// Throws UserError for a bound that is none.
  void check() const;
  /// The keys of the cheapest format of hls/configs/formats.json that keeps the bound, as `dynrt
  /// choose` finds it. The measurements are kept beside the folder `out`.
  std::vector<Decision> choose(const SceneArguments& scene, const std::string& general,
                               const std::string& out, unsigned jobs) const;
};

}  // namespace dynrt::host
