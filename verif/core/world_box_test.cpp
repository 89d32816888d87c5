// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores that test an object's box in the world before a packet enters the object: every ray has the
// hit and the pixel that it has without the test, and fewer objects are entered.
#include "configs/fast.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

struct Eight : config::fast {
  static constexpr ObjectBox kObjectBox = ObjectBox::kNodes;
};
template <class General>
struct World : General {
  static constexpr ObjectBox kObjectBox = ObjectBox::kWorld;
};
template <class General>
struct Stored : General {
  static constexpr TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;
};
/// The mailbox is often full, and the same box is tested again.
struct FewSlots : Eight {
  static constexpr unsigned kObjectSlots = 1;
};

/// As without the test; gives the frame.
template <class C>
Frame expect_as_without(const std::string& scene, const ChangeScene& change = {}) {
  const auto without = board_of<C>();
  const auto with = board_of<World<C>>();
  const Frame frame = rendered(*with, scene, change);
  const Frame expected = rendered(*without, scene, change);
  expect_same_picture(frame, expected, scene, "with boxes", "without");
  EXPECT_LE(count_of(frame, "traced_ray.tokens"), count_of(expected, "traced_ray.tokens"));
  return frame;
}

TEST(WorldBox, RaysHitWhatTheyHitWithoutTheTest) {
  for (const char* scene : {"blocks", "office", "conference", "trees4000"}) {
    expect_as_without<Eight>(scene);
  }
  expect_as_without<Stored<Eight>>("conference");
  expect_as_without<FewSlots>("conference");
}

TEST(WorldBox, PacketsEnterFewerObjects) {
  const Frame frame = expect_as_without<Eight>("trees4000");
  const Frame all = rendered(*board_of<Eight>(), "trees4000", {});
  const std::uint64_t rejected =
      count_of(all, "send_job.tokens") - count_of(frame, "send_job.tokens");
  EXPECT_GT(rejected, count_of(frame, "box_job.tokens") / 3);
}

TEST(WorldBox, ACameraInsideABoxSeesWhatIsInIt) {
  const auto inside = [](Scene& scene) { scene.camera->position = {0.1, 0.2, 0.3}; };
  expect_as_without<Eight>("conference", inside);
}

struct Lit : Eight {
  static constexpr unsigned kLights = 2;
};
/// Whose light rays are made one after the other.
struct LitInTurn : Lit {
  static constexpr CameraSource kCamera = CameraSource::kTransformation;
};

TEST(WorldBox, LightRaysMeetTheBoxesAsTheyLieFromTheLight) {
  for (const char* scene : {"lamps", "blocks"}) {
    expect_as_without<Lit>(scene, [](Scene& s) {
      if (s.lights.empty())
        s.lights = {{"left", {-3, 8, 1}, {9, 9, 9}}, {"right", {4, 6, 2}, {9, 9, 9}}};
    });
  }
  const Frame frame = expect_as_without<LitInTurn>("lamps");
  EXPECT_GT(count_of(frame, "box_job.tokens"), 0u);
}

}  // namespace
}  // namespace dynrt::host::specialised
