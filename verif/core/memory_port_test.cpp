// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores whose scene lies behind one port: whatever the width of the port, the second level of cache
// and the number of pipelines, rays have the hits and the pixels that they have where it lies in
// banks; pixels of 16 bits have what these leave of the colours.
#include "configs/fast.h"
#include "configs/thesis.h"
#include "core/specialised.h"
#include "units/pixel.h"

namespace dynrt::host::specialised {
namespace {

template <class C, unsigned Bytes, unsigned SecondLevel = 0, unsigned Pipelines = 1,
          unsigned PixelBits = 32>
struct Behind : C {
  static constexpr auto kMemory = MemoryPath::kPort;
  static constexpr unsigned kPortBytes = Bytes;
  static constexpr unsigned kSecondLevel = SecondLevel;
  static constexpr unsigned kPipelines = Pipelines;
  static constexpr unsigned kPixelBits = PixelBits;
};
template <class C, unsigned Nodes>
struct Lines : C {
  static constexpr unsigned kLineNodes = Nodes;
};
template <class C, unsigned Bytes>
using ShortPixels = Behind<C, Bytes, 0, 1, 16>;

template <class C, class Port>
void expect_as_from_banks(const std::string& scene) {
  Frame banks = rendered(*board_of<C>(), scene, {});
  for (std::uint32_t& pixel : banks.pixels) {
    pixel = static_cast<std::uint32_t>(
        PixelOf<Port>::colour(PixelOf<Port>::of(hls::uint<32>::from(pixel))).to_u64());
  }
  const auto board = board_of<Port>();
  // Twice, as a core must begin its second frame as it did its first.
  rendered(*board, scene, {});
  const Frame port = rendered(*board, scene, {});
  expect_same_picture(port, banks, scene, "behind a port", "in banks");
  EXPECT_GT(count_of(port, "memory_gather.transactions"), 0u);
}

TEST(MemoryPort, RaysHitWhatTheyHitWithBanks) {
  using config::fast, config::thesis;
  expect_as_from_banks<thesis, Behind<thesis, 2>>("office");
  expect_as_from_banks<fast, Behind<fast, 4>>("blocks");
  expect_as_from_banks<fast, Behind<fast, 8>>("trees4000");
  expect_as_from_banks<fast, Behind<fast, 32>>("office");
}

TEST(MemoryPort, WithASecondLevelToo) {
  using config::fast, config::thesis;
  expect_as_from_banks<thesis, Behind<thesis, 8, 4>>("office");
  expect_as_from_banks<fast, Behind<fast, 2, 16>>("cistern");
  expect_as_from_banks<fast, Behind<fast, 32, 128>>("conference");
  expect_as_from_banks<fast, Behind<fast, 16, 64, 4>>("trees4000");
}

TEST(MemoryPort, WithLinesOfSeveralNodes) {
  using config::fast, config::thesis;
  expect_as_from_banks<thesis, Lines<Behind<thesis, 16>, 2>>("office");
  expect_as_from_banks<fast, Lines<Behind<fast, 4>, 4>>("trees4000");
  expect_as_from_banks<fast, Lines<Behind<fast, 2, 16>, 4>>("cistern");
  expect_as_from_banks<fast, Lines<Behind<fast, 16, 64, 2>, 2>>("conference");
}

TEST(MemoryPort, ALineOfSeveralNodesSavesReads) {
  using config::fast;
  const auto asked = [](const auto& board) {
    return count_of(rendered(*board, "office", {}), "memory_lookup.transactions");
  };
  const std::uint64_t one = asked(board_of<Behind<fast, 16>>());
  EXPECT_LT(asked(board_of<Lines<Behind<fast, 16>, 2>>()), one * 4 / 5);
}

TEST(MemoryPort, TakesPixelsOfSixteenBits) {
  using config::fast, config::thesis;
  expect_as_from_banks<thesis, ShortPixels<thesis, 8>>("office");
  expect_as_from_banks<fast, ShortPixels<fast, 4>>("office");
  expect_as_from_banks<fast, Behind<fast, 16, 64, 2, 16>>("cistern");
}

TEST(MemoryPort, ALineIsReadOnceForAllThatWaitForIt) {
  using config::fast;
  const auto reads = [](const auto& board) {
    return count_of(rendered(*board, "office", {}), "memory_gather.transactions");
  };
  const std::uint64_t beats = reads(board_of<Behind<fast, 32, 128>>());
  const std::uint64_t every = reads(board_of<Behind<fast, 32>>());
  EXPECT_LT(2 * beats, every);
}

}  // namespace
}  // namespace dynrt::host::specialised
