// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From the user's flags to a scene in memory: load it, place the camera, add lights and mirrors,
// lay it out.
#pragma once

#include <string>

#include "host/app/prepared.h"
#include "host/app/scene_file.h"

namespace dynrt::host {

/// With a core: throws UserError if it has no rays for the flags of light and mirrors or lacks one
/// of the scene's primitives, naming the configurations that have them, and throws the errors of
/// lay_out(); notes the scene's lights and mirrors that it has no rays for. Without a core: lays
/// the scene out for the shipped number format, with every primitive, and does not check lights
/// and mirrors.
Prepared prepare(SceneFile& file, const CoreInfo* core = nullptr, const TreeOptions& trees = {});
/// For one core, of a file that nothing else reads.
Prepared prepare(const SceneArguments& arguments, const CoreInfo* core = nullptr,
                 const TreeOptions& trees = {});

/// Throws UserError that names the configurations of this build with the rays that `flag` needs.
void require_reflections(const CoreInfo& core, const std::string& flag);

}  // namespace dynrt::host
