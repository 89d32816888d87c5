// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene at a moment of its animation: where its moving instances and its camera then are. Times
// in seconds. Positions, turns and sizes go evenly from key to key, turns the shortest way about
// one axis; a camera's path is a smooth curve through its keys. Before the first key and after the
// last all stand still, unless a node repeats.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace dynrt::host {

/// The time of the last key of all; 0 when nothing moves. What repeats counts once.
double duration(const Scene& scene);

/// Where an animation is looked at: at rest, at every key, and at 64 moments evenly between the
/// first and the last.
std::vector<double> moments_of(const Scene& scene);

/// Object to world, of every instance.
std::vector<glm::dmat4> transforms_at(const Scene& scene, double time);

/// For a square image, as Scene::camera; nothing when the scene has none. Throws UserError, naming
/// the time, when the camera there stands at the point that it looks at or looks along its up.
std::optional<Camera> camera_at(const Scene& scene, double time);

/// Makes these the scene's own. Throws UserError, naming the instance and the time, when a
/// transform has no inverse there.
void move_to(Scene& scene, double time);

}  // namespace dynrt::host
