// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every field in which two boards can differ is made to differ once.
#include "host/render/compare.h"

#include <gtest/gtest.h>

#include <functional>

namespace dynrt::host {
namespace {

Frame a_frame() {
  Frame frame;
  frame.width = 4;
  frame.height = 3;
  frame.pixels.resize(12, 0x00102030);
  // 0x3f0000 is one: exponent 63, mantissa 0.
  frame.hits.resize(12, {true, 5, 6, 0x3f0000, 0x3e0000, 0x3d0000, 0x3f8000});
  frame.hits[0].hit = false;
  frame.counters = {{"step.tokens", 100, true},
                    {"node_fill.transactions", 7, false},
                    {"list.stalls", 3, false},
                    {"list.tokens", 1, true}};
  return frame;
}

std::string difference_after(const std::function<void(Frame&)>& change) {
  Frame other = a_frame();
  change(other);
  const Comparison comparison = compare(a_frame(), other);
  EXPECT_FALSE(comparison.identical());
  return comparison.first ? comparison.first->text("rtl", "model") : "none";
}

TEST(Compare, IdenticalFramesAreIdentical) {
  const Comparison comparison = compare(a_frame(), a_frame());
  EXPECT_TRUE(comparison.identical());
  EXPECT_EQ(comparison.pixels, 12u);
  EXPECT_EQ(comparison.hits, 11u);
  EXPECT_EQ(comparison.counters, 2u);
  EXPECT_EQ(comparison.different_hits + comparison.different_pixels + comparison.different_counters,
            0u);
}

TEST(Compare, FindsAPlantedDifferenceInEveryField) {
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[6].hit = false; }),
            "pixel (2, 1), hit: rtl has yes, model has no");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[6].object = 8; }),
            "pixel (2, 1), object: rtl has 5, model has 8");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[11].triangle ^= 1; }),
            "pixel (3, 2), triangle: rtl has 6, model has 7");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[6].t = 0x3f0001; }),
            "pixel (2, 1), t: rtl has 1 (0x3f0000), model has 1.0000152587890625 (0x3f0001)");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[6].u = 0x3f0000; }),
            "pixel (2, 1), u: rtl has 0.5 (0x3e0000), model has 1 (0x3f0000)");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[6].v = 0xbd0000; }),
            "pixel (2, 1), v: rtl has 0.25 (0x3d0000), model has -0.25 (0xbd0000)");
  EXPECT_EQ(difference_after([](Frame& f) { f.hits[0].cosine = 0x3f0000; }),
            "pixel (0, 0), cosine: rtl has 1.5 (0x3f8000), model has 1 (0x3f0000)");
  EXPECT_EQ(difference_after([](Frame& f) { f.pixels[3] = 0xff; }),
            "pixel (3, 0), colour: rtl has 0x102030, model has 0x0000ff");
  EXPECT_EQ(difference_after([](Frame& f) { f.counters[0].value = 101; }),
            "step.tokens: rtl has 100, model has 101");
  EXPECT_EQ(difference_after([](Frame& f) { f.height = 2; }), "size: rtl has 4x3, model has 4x2");
}

TEST(Compare, TheFirstDifferenceIsTheFirstPixelsAndAllAreCounted) {
  Frame other = a_frame();
  other.counters[0].value = 1;
  other.hits[9].v = 0;
  other.pixels[5] = 0;
  other.hits[7].u = 0;
  const Comparison comparison = compare(a_frame(), other);
  EXPECT_EQ(comparison.first->field, "colour");
  EXPECT_EQ(comparison.first->x, 1u);
  EXPECT_EQ(comparison.first->y, 1u);
  EXPECT_EQ(comparison.different_hits, 2u);
  EXPECT_EQ(comparison.different_pixels, 1u);
  EXPECT_EQ(comparison.different_counters, 1u);
}

TEST(Compare, CountersThatDependOnTheOrderMayDifferOrBeAbsent) {
  Frame other = a_frame();
  other.counters = {
      {"node_fill.transactions", 8, false}, {"list.tokens", 1, true}, {"step.tokens", 100, true}};
  const Comparison comparison = compare(a_frame(), other);
  EXPECT_TRUE(comparison.identical());
  EXPECT_EQ(comparison.counters, 2u);
}

TEST(Compare, ACounterThatOneBoardLacksIsADifference) {
  EXPECT_EQ(difference_after([](Frame& f) { f.counters.pop_back(); }),
            "list.tokens: rtl has 1, model has none");
  EXPECT_EQ(difference_after([](Frame& f) { f.counters.push_back({"leaf.tokens", 0, true}); }),
            "leaf.tokens: rtl has none, model has 0");
  EXPECT_EQ(difference_after([](Frame& f) { f.counters[0].order_independent = false; }),
            "step.tokens: rtl has 100, model has none");
  Frame renamed = a_frame();
  renamed.counters[3].name = "list.words";
  const Comparison comparison = compare(a_frame(), renamed);
  EXPECT_EQ(comparison.counters, 1u);
  EXPECT_EQ(comparison.different_counters, 2u);
}

TEST(Compare, CountersAreThoseOfTheSameCore) {
  Frame other = a_frame();
  other.core.name = "of other parts";
  other.counters = {{"step.tokens", 101, true}};
  EXPECT_TRUE(compare(a_frame(), other).identical());
  other.pixels[3] = 0xff;
  EXPECT_FALSE(compare(a_frame(), other).identical());
  Frame uncounted = a_frame();
  uncounted.core.counters = false;
  uncounted.counters.clear();
  EXPECT_TRUE(compare(uncounted, uncounted).identical());
  EXPECT_TRUE(compare(a_frame(), uncounted).identical());
}

TEST(Compare, NothingComparedIsNotIdentical) {
  const auto difference = [](const Frame& frame) {
    const Comparison comparison = compare(frame, frame);
    EXPECT_FALSE(comparison.identical());
    return comparison.first ? comparison.first->text("rtl", "model") : "none";
  };
  Frame no_counters = a_frame();
  no_counters.counters = {{"node_fill.transactions", 7, false}};
  EXPECT_EQ(difference(no_counters), "counters to compare: rtl has none, model has none");
  Frame no_pixels = a_frame();
  no_pixels.width = 0;
  no_pixels.pixels.clear();
  no_pixels.hits.clear();
  EXPECT_EQ(difference(no_pixels), "pixels to compare: rtl has none, model has none");
}

}  // namespace
}  // namespace dynrt::host
