// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores that make camera rays beside the transformation: every ray has the hit and the pixel that
// it has where the transformation makes it.
#include "configs/thesis.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

template <class General>
struct Own : General {
  static constexpr CameraSource kCamera = CameraSource::kOwnUnit;
};
/// As `fast`: packets of eight, of which the rays in a leaf are sent.
struct Eight : Reciprocal {
  static constexpr unsigned kPacketRays = 8;
  static constexpr RaysSent kRaysSent = RaysSent::kActive;
};
struct Lit : config::thesis {
  static constexpr unsigned kLights = 2;
  static constexpr unsigned kReflections = 1;
};

TEST(OwnCamera, RaysHitWhatTransformedOnesHit) {
  expect_as_general<Own<config::thesis>>("thesis", "blocks");
  expect_as_reciprocal<Own<Eight>>("blocks");
}

TEST(OwnCamera, RaysOfAnUncompressedFrameHaveAnOriginEach) {
  const auto general = make_board(configurations(), {"model", "thesis", ""});
  const auto special = board_of<Own<Eight>>();
  FrameOptions options = small_frame();
  options.uncompressed = true;
  const Frame frame = render(*special, options, laid_out("blocks", special->core(), {}));
  const Frame expected = render(*general, options, laid_out("blocks", general->core(), {}));
  expect_same_picture(frame, expected, "blocks", "special", "thesis");
}

TEST(OwnCamera, LightAndMirrorsStartFromItsHits) {
  const auto general = board_of<Lit>();
  const auto special = board_of<Own<Lit>>();
  expect_same_picture(rendered(*special, "lamps", {}), rendered(*general, "lamps", {}), "lamps",
                      "special", "general");
}

/// Whether a frame whose packets send an origin with each ray is that of all others.
template <class C>
void expect_as_compressed() {
  const auto board = board_of<C>();
  FrameOptions options = small_frame();
  const MemoryImage lamps = laid_out("lamps", board->core(), {});
  const Frame expected = render(*board, options, lamps);
  options.uncompressed = true;
  const Frame frame = render(*board, options, lamps);
  expect_same_picture(frame, expected, "lamps", "uncompressed", "compressed");
}

/// As `fast`, whose light rays are made there all at once.
struct LitEight : Eight {
  static constexpr unsigned kLights = 2;
};

TEST(OwnCamera, LightRaysMadeAtOnceMeetWhatTransformedOnesMeet) {
  const auto general = board_of<LitEight>();
  const auto special = board_of<Own<LitEight>>();
  const Frame expected = rendered(*general, "lamps", {});
  const Frame frame = rendered(*special, "lamps", {});
  expect_same_picture(frame, expected, "lamps", "special", "general");
  EXPECT_LT(count_of(frame, "column_request.tokens"), count_of(expected, "column_request.tokens"));
}

TEST(OwnCamera, LightRaysOfAnUncompressedFrameHaveAnOriginEach) {
  expect_as_compressed<Lit>();
  expect_as_compressed<Own<Lit>>();
  expect_as_compressed<LitEight>();
  expect_as_compressed<Own<LitEight>>();
}

}  // namespace
}  // namespace dynrt::host::specialised
