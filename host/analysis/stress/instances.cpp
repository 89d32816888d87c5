// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Objects that instances scale, shear, mirror and turn.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

const glm::dvec3 kEye(1, 0.75, 3);

Shot at_sphere(double size) {
  return pencil(size * kEye, {-1.0 - 0.3125, -0.75 - 0.3125, -3}, {0.03125, 0, 0}, {0, 0.03125, 0},
                21, 21);
}

Trial placed_sphere(const MemoryFormat& numbers, const glm::dmat4& transform, const Shot& shot) {
  Trial trial{.scene = {}, .shots = {shot}};
  add(trial.scene, sphere(numbers, 2), transform);
  return trial;
}

Case scale_case(const std::string& name, double size) {
  return Case(name, "a sphere scaled by " + name.substr(6) + ", seen from 3 of its radii",
              [=](Examiner& b) {
                b.check(placed_sphere(b.numbers(), scaling(glm::dvec3(size)), at_sphere(size)));
              });
}

/// Scaled by a power of two: the same bits, but for the exponents of distance and cosine.
void run_power_of_two(Examiner& b, int exponent) {
  const double size = std::exp2(exponent);
  const Rendered plain = b.check(placed_sphere(b.numbers(), glm::dmat4(1.0), at_sphere(1)));
  const Rendered large =
      b.check(placed_sphere(b.numbers(), scaling(glm::dvec3(size)), at_sphere(size)));
  const auto shift = static_cast<std::uint32_t>(exponent) << b.numbers().mantissa_bits;
  b.expect_same(large, plain, [&](HitRecord hit) {
    hit.t += shift;
    hit.cosine -= shift;
    return hit;
  });
}

/// Seen in a mirror, ray for ray: object and triangle meet the same numbers.
void run_mirrored(Examiner& b) {
  const glm::dvec3 mirror(-1, 1, 1);
  Shot shot = at_sphere(1);
  const Rendered plain = b.check(placed_sphere(b.numbers(), glm::dmat4(1.0), shot));
  for (glm::dvec3* v :
       {&shot.camera.position, &shot.camera.right, &shot.camera.up, &shot.camera.forward}) {
    *v *= mirror;
  }
  b.expect_same(b.check(placed_sphere(b.numbers(), scaling(mirror), shot)), plain);
}

glm::dmat4 sheared(double height) {
  glm::dmat4 shear(1.0);
  shear[1][0] = 10;
  shear[2][0] = 3;
  return shear * scaling({1, 1, height});
}

glm::dmat4 turned() {
  return glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
}

/// From within a turned sphere to its vertices, which the world has as doubles.
void run_turned_vertices(Examiner& b) {
  Trial trial = placed_sphere(b.numbers(), turned(), at_sphere(1));
  trial.shots.clear();
  for (const glm::dvec3& vertex : trial.scene.objects[0].vertices) {
    trial.shots.push_back(ray({0, 0, 0}, glm::dvec3(turned() * glm::dvec4(vertex, 1))));
  }
  b.check(trial);
}

Case placed(const std::string& name, const std::string& about, const glm::dmat4& transform,
            const Shot& shot, const Allowed& allowed = {}, const std::string& why = "") {
  return Case(
      name, about, [=](Examiner& b) { b.check(placed_sphere(b.numbers(), transform, shot)); },
      allowed, why);
}

}  // namespace

std::vector<Case> instance_cases() {
  return {
      scale_case("scale_1e-6", 1e-6),
      scale_case("scale_1e-3", 1e-3),
      scale_case("scale_1e3", 1e3),
      scale_case("scale_1e6", 1e6),
      Case("scale_2^-20", "a sphere scaled by 2^-20 gives the same bits, with other exponents",
           [](Examiner& b) { run_power_of_two(b, -20); }),
      Case("scale_2^20", "the same, by 2^20", [](Examiner& b) { run_power_of_two(b, 20); }),
      placed("sheared", "a sphere sheared by 10 and pressed to a thousandth", sheared(0x1p-10),
             pencil({0, 0, 3}, {-5.25, -0.65625, -3}, {0.5, 0, 0}, {0, 0.0625, 0}, 22, 22),
             {.lost = 1}, reasons::kCracks),
      placed("flat_1e-6", "a sphere pressed to a millionth, seen from above", scaling({1, 1, 1e-6}),
             at_sphere(1)),
      placed("turned", "a sphere turned by 0.7 about (1, 2, 3)", turned(), at_sphere(1)),
      Case("turned_vertices", "from the centre of the turned sphere to its vertices",
           run_turned_vertices, {.lost = 15}, reasons::kCracks),
      Case("mirrored", "a mirrored sphere gives the same bits for mirrored rays", run_mirrored),
  };
}

}  // namespace dynrt::host::stress
