// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/matrix_owners.h"

#include <gtest/gtest.h>

#include "host/layout/test_scene.h"

namespace dynrt::host {
namespace {

TEST(MatrixOwners, KnowEveryInstanceAndEveryPrimitive) {
  const testing::Laid laid(testing::two_objects(), Camera{.position = {0, 1, 20}});
  const MatrixOwners owners(laid.scene, laid.objects, laid.frame);
  for (std::uint32_t i = 0; i < laid.scene.instances.size(); ++i) {
    const std::uint32_t matrix = laid.frame.first_instance + i;
    EXPECT_EQ(owners.instance_of(matrix), i);
    const std::uint32_t object = laid.scene.instances[i].object;
    const std::uint32_t first = laid.objects.objects[object].first_matrix;
    const auto count = static_cast<std::uint32_t>(laid.scene.objects[object].triangles.size());
    ASSERT_GT(count, 2u);
    EXPECT_EQ(owners.of(matrix, first), (PrimitiveId{i, 0}));
    EXPECT_EQ(owners.of(matrix, first + count - 1), (PrimitiveId{i, count - 1}));
    EXPECT_EQ(owners.primitive_of(object, first + 1), 1u);
    EXPECT_EQ(owners.of(matrix, first + count), std::nullopt);
  }
  const auto behind =
      laid.frame.first_instance + static_cast<std::uint32_t>(laid.scene.instances.size());
  EXPECT_EQ(owners.instance_of(behind), std::nullopt);
  EXPECT_EQ(owners.of(behind, 0), std::nullopt);
  if (laid.frame.first_instance > 0) {
    EXPECT_EQ(owners.instance_of(laid.frame.first_instance - 1), std::nullopt);
  }
}

}  // namespace
}  // namespace dynrt::host
