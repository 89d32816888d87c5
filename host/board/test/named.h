// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "host/format/core_info.h"

namespace dynrt::host {

/// A core with every key as by default.
inline CoreInfo named(const std::string& name) {
  CoreInfo core;
  core.name = name;
  return core;
}

}  // namespace dynrt::host
