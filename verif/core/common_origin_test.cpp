// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores that subtract the common origin of a packet's rays once: every ray has the hit and the
// pixel that it has where each subtracts its own.
#include "configs/thesis.h"
#include "configs/watertight.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

/// As `fast`: packets of eight, of which the rays in a leaf are sent.
template <class General>
struct Eight : General {
  static constexpr unsigned kPacketRays = 8;
  static constexpr RaysSent kRaysSent = RaysSent::kActive;
};
template <class General>
struct AtOnce : General {
  static constexpr Divider kDivider = Divider::kThreeReciprocals;
};
template <class General>
struct Common : General {
  static constexpr Origins kOrigins = Origins::kCommon;
};
struct Lit : config::thesis {
  static constexpr unsigned kLights = 2;
};

TEST(CommonOrigin, RaysMeetThePlanesThatTheyMeetAlone) {
  expect_as_general<Common<config::thesis>>("thesis", "blocks");
  expect_as_general<Common<Eight<config::thesis>>>("thesis", "office");
  expect_as_reciprocal<Common<AtOnce<Eight<Reciprocal>>>>("office");
  expect_as_general<Common<config::watertight>>("watertight", "blocks");
}

TEST(CommonOrigin, RaysOfALightHaveOne) {
  const auto each = board_of<Lit>();
  const auto common = board_of<Common<Eight<Lit>>>();
  expect_same_picture(rendered(*common, "lamps", {}), rendered(*each, "lamps", {}), "lamps",
                      "common", "each");
}

}  // namespace
}  // namespace dynrt::host::specialised
