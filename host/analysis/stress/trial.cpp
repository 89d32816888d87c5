// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/trial.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host/analysis/truth/rays.h"
#include "host/layout/fit.h"
#include "host/scene/camera.h"

namespace dynrt::host::stress {

namespace {

Shot shot(const Camera& camera, unsigned width, unsigned height) {
  Shot shot;
  shot.camera = camera;
  shot.options.width = width;
  shot.options.height = height;
  return shot;
}

/// A direction as the transformation unit computes it (units/transformation.h): terms that are zero
/// add a smallest number, which changes only a component of zero.
double component(const MemoryFormat& n, double across, double x, double down, double y,
                 double first) {
  const double sum =
      n.round(n.round(n.round(across) * n.round(x)) + n.round(n.round(down) * n.round(y)));
  const double c = n.round(sum + n.round(first));
  return std::abs(c) <= 4 * n.smallest ? 0 : c;
}

}  // namespace

Shot pencil(const glm::dvec3& origin, const glm::dvec3& first, const glm::dvec3& across,
            const glm::dvec3& down, unsigned width, unsigned height) {
  Camera camera;
  camera.position = origin;
  camera.right = across * static_cast<double>(width);
  camera.up = -down * static_cast<double>(height);
  camera.forward = first + 0.5 * (camera.right - camera.up) - 0.5 * (across + down);
  return shot(camera, width, height);
}

Shot ray(const glm::dvec3& origin, const glm::dvec3& direction) {
  return pencil(origin, direction, glm::dvec3(0.0), glm::dvec3(0.0), 1, 1);
}

Shot picture(const glm::dvec3& position, const glm::dvec3& target, double field_of_view,
             unsigned width, unsigned height) {
  return shot(look_at(position, target, {0, 1, 0}, field_of_view,
                      static_cast<double>(width) / static_cast<double>(height)),
              width, height);
}

TruthRay ray_of(const Shot& shot, unsigned x, unsigned y, Rays rays, const MemoryFormat& numbers) {
  const auto [width, height] = std::pair(shot.options.width, shot.options.height);
  if (rays == Rays::kOfCamera) return primary_ray(shot.camera, width, height, x, y);
  const glm::dmat4x3 matrix = camera_matrix(shot.camera, width, height);
  TruthRay ray;
  for (int k = 0; k < 3; ++k) {
    ray.origin[k] = on_grid(numbers, matrix[3][k]);
    ray.direction[k] = component(numbers, matrix[0][k], x, matrix[1][k], y, matrix[2][k]);
  }
  return ray;
}

Trial fitted(Trial trial, const MemoryFormat& numbers) {
  const Fit space = fit(trial.scene, trial.shots.at(0).camera, numbers);
  move_into(space, trial.scene);
  for (Shot& shot : trial.shots) shot.camera = moved_into(space.world, shot.camera);
  return trial;
}

Scene scene_of(Mesh mesh) {
  Scene scene;
  add(scene, std::move(mesh));
  return scene;
}

void add(Scene& scene, Mesh mesh, const glm::dmat4& transform) {
  if (scene.materials.empty()) scene.materials.push_back({.name = "grey"});
  scene.name = "stress";
  const auto number = static_cast<std::uint32_t>(scene.objects.size());
  if (mesh.name.empty()) mesh.name = fmt::format("object {}", number);
  scene.instances.push_back({.name = mesh.name, .object = number, .transform = transform});
  scene.objects.push_back(std::move(mesh));
}

}  // namespace dynrt::host::stress
