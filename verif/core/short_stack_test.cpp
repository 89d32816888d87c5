// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores whose stacks keep a few entries: every ray has the hit and the pixel that it has with whole
// stacks, though packets start again at the root.
#include "configs/fast.h"
#include "configs/thesis.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

struct Whole : config::fast {
  static constexpr unsigned kStackEntries = 64;
};
struct WholeWithoutBoxes : Whole {
  static constexpr ObjectBox kObjectBox = ObjectBox::kNodes;
};
struct Lit : config::thesis {
  static constexpr Origins kOrigins = Origins::kCommon;
  static constexpr unsigned kLights = 2;
};
template <class General, unsigned Entries>
struct Short : General {
  static constexpr unsigned kStackEntries = Entries;
};

std::uint64_t steps(const Frame& frame) { return count_of(frame, "node_request.tokens"); }

/// With so few entries that packets start again, and with as many as `fast` has.
template <class C>
void expect_as_whole(const std::string& scene) {
  const Frame whole = rendered(*board_of<C>(), scene, {});
  const auto expect_same = [&](const Frame& frame) {
    expect_same_picture(frame, whole, scene, "with short stacks", "with whole ones");
  };
  const Frame two = rendered(*board_of<Short<C, 2>>(), scene, {});
  expect_same(two);
  EXPECT_GT(steps(two), steps(whole)) << "no packet started again";
  const Frame eight = rendered(*board_of<Short<C, 8>>(), scene, {});
  expect_same(eight);
  EXPECT_LT(steps(eight), steps(two));
}

TEST(ShortStack, RaysHitWhatTheyHitWithWholeStacks) {
  for (const char* scene : {"blocks", "office", "conference", "trees4000"}) {
    expect_as_whole<WholeWithoutBoxes>(scene);
  }
  expect_as_whole<Whole>("conference");
}

TEST(ShortStack, TheRaysOfALightToo) { expect_as_whole<Lit>("lamps"); }

}  // namespace
}  // namespace dynrt::host::specialised
