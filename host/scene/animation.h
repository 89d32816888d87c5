// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene at a moment of its animation: the places of its moving instances and of its camera. Times
// are in seconds. Positions, turns and sizes change evenly from key to key; a turn takes the
// shortest way about one axis; a camera's path is a smooth curve through its keys. Before the first
// key and after the last everything stands still, unless a node repeats.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace dynrt::host {

/// The time of the last key; 0 if nothing moves. A repeated motion counts once.
double duration(const Scene& scene);

/// The moments at which an animation is examined: at rest, at every key, and at 64 moments evenly
/// between the first key and the last.
std::vector<double> moments_of(const Scene& scene);

/// Object to world, of every instance.
std::vector<glm::dmat4> transforms_at(const Scene& scene, double time);

/// For a square image, as Scene::camera; nothing if the scene has no camera. Throws UserError,
/// naming the time, if the camera stands at the point that it looks at or looks along its up
/// direction.
std::optional<Camera> camera_at(const Scene& scene, double time);

/// Stores these in the scene. Throws UserError, naming the instance and the time, if a transform
/// has no inverse.
void move_to(Scene& scene, double time);

}  // namespace dynrt::host
