// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/image_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/picture/srgb.h"
#include "host/picture/write_image.h"

namespace dynrt::host {
namespace {

using testing::ThrowsMessage;

/// The content of a picture file with these pixels in a row.
std::vector<std::uint8_t> file_of(const std::string& extension,
                                  const std::vector<std::uint32_t>& pixels) {
  const std::string path =
      testing::TempDir() + "image_library_" + std::to_string(getpid()) + extension;
  write_image(path, PictureView(static_cast<unsigned>(pixels.size()), 1, pixels));
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> content{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove(path);
  return content;
}

MeanColour mean_of(const std::vector<std::uint8_t>& content) {
  return image_library().mean_colour(content);
}

TEST(MeanColour, IsOfLightAndNotOfLevels) {
  const MeanColour mean = mean_of(file_of(".png", {0x0000ff, 0x00bc00}));
  EXPECT_EQ(mean.error, "");
  EXPECT_NEAR(mean.linear[0], 0.5, 1e-12);
  EXPECT_NEAR(mean.linear[1], linear_of(0xbc / 255.0) / 2, 1e-12);  // a light of one half
  EXPECT_NEAR(mean.linear[1], 0.25, 2e-3);
  EXPECT_EQ(mean.linear[2], 0.0);
}

TEST(MeanColour, OfNumbersIsTheirMean) {
  const MeanColour mean = mean_of(file_of(".exr", {0xff0000, 0x000000, 0x000000, 0x000000}));
  EXPECT_EQ(mean.error, "");
  EXPECT_NEAR(mean.linear[2], 0.25, 1e-6);
}

TEST(MeanColour, SaysWhyThereIsNone) {
  std::vector<std::uint8_t> cut = file_of(".png", std::vector<std::uint32_t>(64, 0x123456));
  cut.resize(cut.size() / 2);
  EXPECT_NE(mean_of(cut).error, "");
  EXPECT_NE(mean_of({'h', 'e', 'l', 'l', 'o'}).error, "");
  EXPECT_NE(mean_of({}).error, "");
  for (const auto& damaged : {cut, std::vector<std::uint8_t>{'h', 'i'}}) {
    EXPECT_EQ(mean_of(damaged).error.find('\n'), std::string::npos);
  }
}

TEST(ImageLibrary, SaysWhyItIsNotThere) {
  EXPECT_THAT(
      [] { load_image_library("/gone/dynrt_images.so"); },
      ThrowsMessage<UserError>(testing::AllOf(
          testing::StartsWith(
              "pictures need dynrt's library dynrt_images.so, which cannot be loaded (/gone/"),
          testing::HasSubstr("No such file"),
          testing::EndsWith("; build it again or put it into the program's folder"))));
  EXPECT_THAT([] { load_image_library("libc.so.6"); },
              ThrowsMessage<UserError>(testing::HasSubstr("dynrt_image_library")));
}

}  // namespace
}  // namespace dynrt::host
