// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/text_encoding.h"

#include <gtest/gtest.h>

#include <string_view>

namespace dynrt::host {
namespace {

std::string utf16(std::u16string_view units, bool big_endian) {
  std::string bytes;
  for (const char16_t unit : units) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit);
    bytes += big_endian ? std::string{high, low} : std::string{low, high};
  }
  return bytes;
}

TEST(ToUtf8, LeavesTextWithoutAMark) {
  EXPECT_EQ(to_utf8(""), "");
  EXPECT_EQ(to_utf8("v 1 2 3\n"), "v 1 2 3\n");
  EXPECT_EQ(to_utf8("\xFF"), "\xFF");
}

TEST(ToUtf8, TakesOffTheMarkOfUtf8) { EXPECT_EQ(to_utf8("\xEF\xBB\xBFv 1"), "v 1"); }

TEST(ToUtf8, ReadsUtf16OfBothByteOrders) {
  for (const bool big_endian : {false, true}) {
    EXPECT_EQ(to_utf8(utf16(u"\xFEFFo \u00E9\u20AC\U0001F600\n", big_endian)),
              "o \xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\n");
    EXPECT_EQ(to_utf8(utf16(u"\xFEFF", big_endian)), "");
    EXPECT_EQ(to_utf8(utf16(u"\xFEFF"
                            "a",
                            big_endian) +
                      "b"),
              "a");
  }
}

TEST(ToUtf8, ReplacesHalfOfAPair) {
  const char16_t halves[] = {0xFEFF, 0xD83D, 'a', 0xDE00, 0xD83D};
  EXPECT_EQ(to_utf8(utf16({halves, std::size(halves)}, false)),
            "\xEF\xBF\xBD"
            "a\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace
}  // namespace dynrt::host
