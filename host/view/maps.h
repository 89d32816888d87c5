// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of what a frame took and how right it is, in place of its colours.
#pragma once

#include <span>

#include "host/view/scenery.h"
#include "host/view/still.h"

namespace dynrt::host {

struct MapDefinition {
  const char* name;
  const char* about;  ///< with the unit
  const char* kind;   ///< "values", "classes" or "colours"
  bool watched;       ///< the frame must have been watched
};

std::span<const MapDefinition> view_maps();

/// The head has "name", "kind", and of values "low" and "high"; the words are a float for each
/// pixel, or its colour as the picture's pixels have it. Throws NotOurs for an unknown name. What
/// is not known, such as the distance where nothing is hit, is not a number.
Answer map_of(const Scenery& scenery, const Still& still, const std::string& name);

}  // namespace dynrt::host
