// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Of a picture's bursts the pixels of its rows remain, in order, the first one marked.
#include "units/picture_pixels.h"

#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

template <class Pixel>
class PicturePixelsTest : public testing::Test {
 protected:
  using Place = uint<8 * Pixel::kBytes>;

  /// Takes all bursts of a picture, which holds random pixels, and expects those of its rows.
  void expect_picture(unsigned width, unsigned height, test::Random& random) {
    bench_.value(bench_.unit.config).width = Word::from(width);
    bench_.value(bench_.unit.config).height = Word::from(height);
    const unsigned pitch = row_pitch(width);
    const unsigned in_rows = pitch * height;
    const unsigned places =
        (in_rows + kBurstPixels<Pixel> - 1) / kBurstPixels<Pixel> * kBurstPixels<Pixel>;
    std::vector<PicturePixel> expected;
    for (unsigned i = 0; i < places; ++i) {
      const auto place = Place::from(random.next());
      bench_.feed(bench_.unit.place, place);
      if (i % pitch < width && i < in_rows) expected.push_back({Pixel::colour(place), i == 0});
    }
    bench_.run();
    EXPECT_TRUE(test::same(bench_.take(bench_.unit.pixel), expected)) << width << "x" << height;
  }
  test::UnitBench<PicturePixels<Pixel>> bench_;
};
using Pixels = testing::Types<WordPixel, HalfPixel>;
TYPED_TEST_SUITE(PicturePixelsTest, Pixels);

TYPED_TEST(PicturePixelsTest, KeepsThePixelsOfRows) {
  test::Random random(1);
  for (unsigned width = 1; width < 40; ++width) {
    for (unsigned height = 1; height < 9; ++height) this->expect_picture(width, height, random);
  }
  this->expect_picture(640, 480, random);
  this->expect_picture(4095, 3, random);
}

}  // namespace
}  // namespace dynrt
