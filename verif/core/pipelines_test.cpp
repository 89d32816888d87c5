// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores of several pipelines: whichever traces a packet, its rays have the hits and the pixels that
// they have in a core of one, and all have something to trace.
#include "configs/fast.h"
#include "configs/thesis.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

struct Lit : config::thesis {
  static constexpr unsigned kLights = 2;
  static constexpr unsigned kReflections = 1;
};
struct Slow : config::fast {
  static constexpr unsigned kMemoryClocks = 4;
};
template <class C, unsigned Number>
struct Several : C {
  static constexpr unsigned kPipelines = Number;
};

template <class C, unsigned Number>
void expect_as_one(const std::string& scene) {
  const Frame one = rendered(*board_of<C>(), scene, {});
  const auto board = board_of<Several<C, Number>>();
  // Twice, as a core must begin its second frame as it did its first.
  rendered(*board, scene, {});
  const Frame several = rendered(*board, scene, {});
  expect_same_picture(several, one, scene, "with several pipelines", "with one");
  std::uint64_t steps = 0;
  for (unsigned p = 0; p < Number; ++p) {
    const std::uint64_t of_pipeline =
        count_of(several, fmt::format("p{}_node_request.tokens", p).c_str());
    EXPECT_GT(of_pipeline, 0u) << "pipeline " << p << " has nothing to do";
    steps += of_pipeline;
  }
  EXPECT_EQ(steps, count_of(one, "node_request.tokens"));
}

TEST(Pipelines, RaysHitWhatTheyHitWithOne) {
  expect_as_one<config::thesis, 2>("office");
  expect_as_one<config::thesis, 16>("blocks");
  expect_as_one<config::fast, 3>("conference");
  expect_as_one<config::fast, 4>("trees4000");
}

TEST(Pipelines, LightAndReflectedRaysToo) { expect_as_one<Lit, 2>("lamps"); }

TEST(Pipelines, ASlowerMemoryChangesNoHit) {
  const Frame slow = rendered(*board_of<Slow>(), "office", {});
  expect_same_picture(slow, rendered(*board_of<config::fast>(), "office", {}), "office",
                      "with a slow memory", "with a quick one");
}

}  // namespace
}  // namespace dynrt::host::specialised
