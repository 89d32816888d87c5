// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The reader asks for every burst of a picture, once, in order, and never for more than there is
// room for.
#include "units/picture_reader.h"

#include <optional>
#include <utility>
#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

constexpr unsigned kAhead = 5;

template <class Pixel>
class PictureReaderTest : public testing::Test {
 protected:
  static constexpr unsigned kInBurst = kBurstPixels<Pixel>;

  void picture(unsigned width, unsigned height) {
    bench_.value(bench_.unit.config).width = Word::from(width);
    bench_.value(bench_.unit.config).height = Word::from(height);
    bursts_ = (row_pitch(width) * height + kInBurst - 1) / kInBurst;
  }
  /// The bursts asked for in a transaction.
  std::vector<unsigned> step(bool room = false, std::optional<unsigned> base = std::nullopt) {
    bench_.feed(bench_.unit.events, {base.has_value(), uint<20>::from(base.value_or(0)), room});
    bench_.run();
    std::vector<unsigned> asked;
    for (const PictureRead& read : bench_.take(bench_.unit.read)) {
      EXPECT_EQ(read.last, uint<4>(kBurstBytes / 8 - 1));
      const auto address = static_cast<unsigned>(read.address.to_u64());
      EXPECT_EQ(address % kBurstBytes, 0u);
      asked.push_back((address - kPixelsAt) / kBurstBytes);
    }
    return asked;
  }
  /// Those of several transactions, in each of which a burst leaves the FIFO, or none.
  std::vector<unsigned> steps(unsigned count, bool room) {
    std::vector<unsigned> asked;
    for (unsigned i = 0; i < count; ++i) {
      for (const unsigned burst : step(room)) asked.push_back(burst);
    }
    return asked;
  }
  std::vector<unsigned> from(unsigned first, unsigned count) {
    std::vector<unsigned> bursts;
    for (unsigned i = 0; i < count; ++i) bursts.push_back(first + i);
    return bursts;
  }
  unsigned bursts_ = 0;  ///< of the picture

 private:
  test::UnitBench<PictureReader<Pixel, 8, kAhead>> bench_;
};
using Pixels = testing::Types<WordPixel, HalfPixel>;
TYPED_TEST_SUITE(PictureReaderTest, Pixels);

TYPED_TEST(PictureReaderTest, AsksForThePictureAndNoMore) {
  for (const auto& [width, height] : {std::pair{37u, 11u}, {64u, 8u}, {1u, 1u}, {640u, 480u}}) {
    SCOPED_TRACE(width);
    this->picture(width, height);
    std::vector<unsigned> asked = this->step(false, 100 * TestFixture::kInBurst);
    bool left = false;  // what was asked for leaves the FIFO at once
    for (unsigned i = 0; i < this->bursts_ + 20; ++i) {
      const std::vector<unsigned> now = this->step(left);
      left = !now.empty();
      asked.insert(asked.end(), now.begin(), now.end());
    }
    EXPECT_EQ(asked, this->from(100, this->bursts_));
  }
}

TYPED_TEST(PictureReaderTest, WaitsForRoom) {
  this->picture(100, 100);
  this->step(false, 0);
  EXPECT_EQ(this->steps(20, false), this->from(0, kAhead));
  EXPECT_TRUE(this->step(true).empty());  // seen in the next transaction
  EXPECT_EQ(this->step(true), this->from(kAhead, 1));
  EXPECT_EQ(this->steps(3, false), this->from(kAhead + 1, 1));
}

TYPED_TEST(PictureReaderTest, ReadsAPictureToItsEndAndThenTheLatest) {
  this->picture(TestFixture::kInBurst, 7);
  this->step(false, 0);
  EXPECT_EQ(this->steps(4, false), this->from(0, 3));
  this->step(false, 50 * TestFixture::kInBurst);  // and asks for the fourth
  this->step(false, 90 * TestFixture::kInBurst);  // and the fifth
  EXPECT_TRUE(this->steps(2, false).empty());
  EXPECT_TRUE(this->step(true).empty());
  EXPECT_EQ(this->steps(2, true), this->from(5, 2));
  EXPECT_TRUE(this->step(true).empty());  // begins
  EXPECT_EQ(this->steps(2, true), this->from(90, 2));
}

TYPED_TEST(PictureReaderTest, AsksForNothingOfAnEmptyPicture) {
  this->picture(0, 7);
  this->step(false, 0);
  EXPECT_TRUE(this->steps(20, false).empty());
}

}  // namespace
}  // namespace dynrt
