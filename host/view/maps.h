// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Maps of a picture: the work of each packet, the errors of the hits, distances and normals.
#pragma once

#include <span>

#include "host/view/full_picture.h"
#include "host/view/loaded_scene.h"

namespace dynrt::host {

struct MapDefinition {
  const char* name;
  const char* about;  ///< with the unit
  const char* kind;   ///< "values", "classes" or "colours"
  bool watched;       ///< the frame must have been watched
};

std::span<const MapDefinition> view_maps();

/// The head has "name" and "kind"; a map of values also has "low" and "high". The words hold one
/// float for each pixel, or its colour in the format of the picture. A value that is not known,
/// such as the distance where nothing is hit, is NaN. Throws NotOurs for an unknown name.
Answer map_of(const LoadedScene& loaded, const FullPicture& picture, const std::string& name);

}  // namespace dynrt::host
