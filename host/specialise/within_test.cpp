// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/within.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/specialise/test_needs.h"

namespace dynrt::host {
namespace {

using testing::needs_of;
using testing::one_triangle;
using testing::scene_of;

CoreInfo made_for_a_sail() {
  CoreInfo info;
  info.name = "mine";
  info.made_for = "sail";
  info.levels = 2;
  info.stack_depth = 3;
  info.address_bits = 4;
  info.matrix_bits = 3;
  info.lights = 1;
  CoreConfiguration whitted;
  whitted.lights = 8;
  info.general = std::make_shared<CoreConfiguration>(whitted);
  return info;
}

TEST(Within, WhatWasAnalysedFits) {
  SceneNeeds needs = needs_of(scene_of(one_triangle("sail")));
  needs.lights = 1;
  needs.top_stack.pushes = 3;
  EXPECT_FALSE(excess(needs, made_for_a_sail()));
  EXPECT_NO_THROW(check_within(needs, made_for_a_sail(), "frame 1"));
}

TEST(Within, ADeeperTreeIsRefusedWithBothValues) {
  SceneNeeds needs = needs_of(scene_of(one_triangle("sail")));
  needs.top_stack.pushes = 4;
  EXPECT_THAT([&] { check_within(needs, made_for_a_sail(), "frame 7 of 24"); },
              ::testing::ThrowsMessage<Exceeded>(::testing::HasSubstr(
                  "frame 7 of 24 needs stack_depth 4, and configuration mine, made for 'sail', has "
                  "3;")));
}

/// The first key that is exceeded, with both values.
void expect_excess(const SceneNeeds& needs, const CoreInfo& board, const std::string& key,
                   const std::string& needed, const std::string& has) {
  const auto over = excess(needs, board);
  ASSERT_TRUE(over) << key;
  EXPECT_EQ(over->key, key);
  EXPECT_EQ(over->needs, needed) << key;
  EXPECT_EQ(over->has, has) << key;
}

TEST(Within, EveryKeyIsHeldAgainstTheScene) {
  const SceneNeeds fits = needs_of(scene_of(one_triangle("sail")));
  const CoreInfo board = made_for_a_sail();
  SceneNeeds needs = fits;
  needs.lights = 2;
  expect_excess(needs, board, "lights", "2", "1");
  needs = fits;
  needs.object_stack.pushes = 5;
  expect_excess(needs, board, "stack_depth", "5", "3");
  needs = fits;
  needs.places.nodes = 17;
  expect_excess(needs, board, "address_bits", "5", "4");
  needs = fits;
  needs.places.matrices = 9;
  expect_excess(needs, board, "matrix_bits", "4", "3");
  needs = fits;
  needs.one_level = false;
  CoreInfo one = board;
  one.levels = 1;
  EXPECT_FALSE(excess(fits, one));
  expect_excess(needs, one, "levels", "2", "1");
  needs = fits;
  needs.primitives.spheres = 1;
  expect_excess(needs, board, "primitives", "triangle, sphere", "triangle");
  needs = fits;
  needs.colours = {1, 2};
  CoreInfo plain = board;
  EXPECT_FALSE(excess(needs, plain));
  plain.one_colour = true;
  expect_excess(needs, plain, "one_colour", "false", "true");
}

TEST(Within, ACoreMadeFromOneWithoutLightsIgnoresThemAsThatDoes) {
  SceneNeeds needs = needs_of(scene_of(one_triangle("sail")));
  needs.lights = 2;
  CoreInfo board = made_for_a_sail();
  board.lights = 0;
  board.general = std::make_shared<CoreConfiguration>();
  EXPECT_FALSE(excess(needs, board));
}

}  // namespace
}  // namespace dynrt::host
