// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/matrix_owners.h"

#include <algorithm>

#include "host/memory/matrix_numbers.h"

namespace dynrt::host {

MatrixOwners::MatrixOwners(const Scene& scene, const ObjectImage& objects, const FrameImage& frame)
    : scene_(scene), first_instance_(frame.first_instance), stride_(has_mirrors(scene) ? 2 : 1) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    numbers_.push_back(matrix_numbers(scene, scene.objects[i], objects.objects[i].first_matrix,
                                      objects.core.triangle_matrix));
    numbers_.back().pop_back();
  }
}

std::optional<PrimitiveId> MatrixOwners::of(std::uint32_t object, std::uint32_t triangle) const {
  const std::optional<std::uint32_t> instance = instance_of(object);
  if (!instance) return std::nullopt;
  const auto primitive = primitive_of(scene_.instances[*instance].object, triangle);
  if (!primitive) return std::nullopt;
  return PrimitiveId{*instance, *primitive};
}

std::optional<std::uint32_t> MatrixOwners::primitive_of(std::uint32_t object,
                                                        std::uint32_t matrix) const {
  const auto& numbers = numbers_[object];
  const auto at = std::ranges::lower_bound(numbers, matrix);
  if (at == numbers.end() || *at != matrix) return std::nullopt;
  return static_cast<std::uint32_t>(at - numbers.begin());
}

std::optional<std::uint32_t> MatrixOwners::instance_of(std::uint32_t matrix) const {
  if (matrix < first_instance_ || (matrix - first_instance_) % stride_ != 0) return std::nullopt;
  const std::uint32_t instance = (matrix - first_instance_) / stride_;
  if (instance >= scene_.instances.size()) return std::nullopt;
  return instance;
}

}  // namespace dynrt::host
