// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Quake 3 map as a scene: one object of everything that is drawn (sky and invisible faces are
// not), its quadratic Bezier patches cut into triangles. The map's (x, y, z) with z up becomes
// (x, z, -y). Textures are not read; a triangle's colour is the colour of its texture's name times
// the light that the map's makers baked into it; both factors can be left out.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/scene.h"

namespace dynrt::host {

/// The file that the Debian package openarena-081-maps installs.
inline constexpr char kMapPackage[] = "/usr/share/games/openarena/baseoa/pak1-maps.pk3";
inline constexpr int kFinestTessellation = 32;

struct MapOptions {
  int tessellation = 6;     ///< level L: 2 L^2 triangles for every 3x3 control points of a patch
  bool baked_light = true;  ///< else a triangle has its texture's colour
  /// The colour of a texture by its name, such as "textures/acc_dm5/rust"; none: light grey.
  std::function<glm::dvec3(const std::string& texture)> colour = {};
};

/// `bytes` is the content of a .bsp file. The camera stands where the first player would start.
/// Throws UserError if the map has a mistake (bsp.h).
Scene map_scene(std::string_view bytes, const std::string& label, const MapOptions& options = {});

/// A map by its name, "oa_dm5", out of a .pk3 file. Throws UserError with the names of the file's
/// maps if it has no such map. An empty name means its only map.
Scene load_map(const std::string& pk3, const std::string& name, const MapOptions& options = {});

/// The same from the Debian package; throws UserError with the command that installs it.
Scene load_package_map(const std::string& name, const MapOptions& options = {},
                       const std::string& pk3 = kMapPackage);

}  // namespace dynrt::host
