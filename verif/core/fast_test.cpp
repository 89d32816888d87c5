// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The fast datapath. Where the rays of a packet start at one point, a plane's distance from there
// is found once, an object's box is tested in the world before the object is entered, and stacks
// keep four entries: every ray has the hit and the pixel that it has where each has its own origin.
#include "configs/fast.h"

#include "configs/whitted.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
/// `fast` with stacks of other sizes, below.
struct WholeStacks : config::fast {};
struct StacksOfTwo : config::fast {};
}  // namespace dynrt::host::specialised

template <>
inline constexpr unsigned dynrt::kStackEntries<dynrt::host::specialised::WholeStacks> = 64;
template <>
inline constexpr unsigned dynrt::kStackEntries<dynrt::host::specialised::StacksOfTwo> = 2;

namespace dynrt::host::specialised {
namespace {

/// Each ray has its origin in the traversal: whole stacks, and no boxes in the world.
template <class General>
struct Each : General {
  static constexpr Origins kOrigins = Origins::kEach;
};
struct InThreeColumns : config::fast {
  static constexpr TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;
};
/// The mailbox is often full, and the same box is tested again.
struct FewSlots : config::fast {
  static constexpr unsigned kObjectSlots = 1;
};
struct Lit : config::fast {
  static constexpr unsigned kLights = 2;
};

/// As where each ray has its origin; gives the frame.
template <class C>
Frame expect_as_each(const std::string& scene, const ChangeScene& change = {}) {
  const Frame frame = rendered(*board_of<C>(), scene, change);
  const Frame expected = rendered(*board_of<Each<C>>(), scene, change);
  expect_same_picture(frame, expected, scene, "from one point", "from each origin");
  EXPECT_LE(count_of(frame, "traced_ray.tokens"), count_of(expected, "traced_ray.tokens"));
  return frame;
}

TEST(Fast, RaysFromOnePointHitWhatTheyHitFromTheirOwnOrigins) {
  for (const char* scene : {"blocks", "office", "conference"}) expect_as_each<config::fast>(scene);
  expect_as_each<InThreeColumns>("conference");
  expect_as_each<FewSlots>("conference");
}

TEST(Fast, PacketsEnterFewerObjects) {
  const Frame frame = expect_as_each<config::fast>("trees4000");
  const Frame all = rendered(*board_of<Each<config::fast>>(), "trees4000", {});
  const std::uint64_t rejected =
      count_of(all, "send_job.tokens") - count_of(frame, "send_job.tokens");
  EXPECT_GT(rejected, count_of(frame, "box_job.tokens") / 3);
}

TEST(Fast, ACameraInsideABoxSeesWhatIsInIt) {
  expect_as_each<config::fast>("conference",
                               [](Scene& scene) { scene.camera->position = {0.1, 0.2, 0.3}; });
}

TEST(Fast, RaysOfALightHaveOneOriginToo) {
  for (const char* scene : {"lamps", "blocks"}) {
    expect_as_each<Lit>(scene, [](Scene& s) {
      if (s.lights.empty())
        s.lights = {{"left", {-3, 8, 1}, {9, 9, 9}}, {"right", {4, 6, 2}, {9, 9, 9}}};
    });
  }
}

TEST(Fast, APacketThatStartsAgainHitsWhatItHitsWithAWholeStack) {
  const auto steps = [](const Frame& frame) { return count_of(frame, "node_request.tokens"); };
  for (const char* scene : {"blocks", "office", "conference", "trees4000"}) {
    const Frame whole = rendered(*board_of<WholeStacks>(), scene, {});
    const Frame two = rendered(*board_of<StacksOfTwo>(), scene, {});
    const Frame four = rendered(*board_of<config::fast>(), scene, {});
    expect_same_picture(two, whole, scene, "with two entries", "with whole stacks");
    expect_same_picture(four, whole, scene, "with four entries", "with whole stacks");
    EXPECT_GT(steps(two), steps(four));
    EXPECT_GT(steps(four), steps(whole)) << "no packet started again";
  }
}

/// Whether a frame whose packets send an origin with each ray is that of all others.
template <class C>
void expect_as_compressed() {
  const auto board = board_of<C>();
  FrameOptions options = small_frame();
  const MemoryImage lamps = laid_out("lamps", board->core(), {});
  const Frame expected = render(*board, options, lamps);
  options.uncompressed = true;
  expect_same_picture(render(*board, options, lamps), expected, "lamps", "uncompressed",
                      "compressed");
}

/// With mirrors too, which the datapath has where each ray has its origin.
struct Mirrors : Each<Lit> {
  static constexpr unsigned kReflections = 3;
  static constexpr Crossing kCrossing = Crossing::kRemember;
};

TEST(Fast, RaysOfAnUncompressedFrameHaveAnOriginEach) {
  expect_as_compressed<config::fast>();
  expect_as_compressed<Lit>();
  expect_as_compressed<Each<Lit>>();
  expect_as_compressed<Mirrors>();
}

/// Packets of another size, whose groups of signs are traced one after the other.
struct Splits : Mirrors {
  static constexpr unsigned kPacketRays = 4;
  static constexpr bool kMainFirst = false;
  static constexpr Crossing kCrossing = Crossing::kSplit;
};
/// As `whitted` has them but for the datapath.
struct Whitted : config::whitted {
  static constexpr unsigned kLights = 2;
  static constexpr unsigned kReflections = 3;
};

TEST(Fast, ReflectedRaysMayCross) {
  FrameOptions options = small_frame();
  options.reflections = 3;
  const auto frame_of = [&](const auto& board) {
    return render(*board, options, laid_out("lamps", board->core()));
  };
  const Frame frame = frame_of(board_of<Mirrors>());
  expect_same_picture(frame_of(board_of<Splits>()), frame, "lamps", "split", "remember");
  // The thesis's datapath rounds otherwise, so distances differ; the triangles hardly do.
  const Frame thesis = frame_of(board_of<Whitted>());
  std::size_t others = 0;
  for (std::size_t i = 0; i < frame.hits.size(); ++i) {
    others += frame.hits[i].hit != thesis.hits[i].hit ||
              frame.hits[i].triangle != thesis.hits[i].triangle;
  }
  EXPECT_LT(others, frame.hits.size() / 200);
  const Comparison pictures = compare(frame, thesis);
  EXPECT_LT(pictures.different_pixels, pictures.pixels / 4)
      << "reflections differ in more than rounding";
}

}  // namespace
}  // namespace dynrt::host::specialised
