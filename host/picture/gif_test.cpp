// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/gif.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "host/error.h"
#include "host/picture/write_image.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;
using testing::ThrowsMessage;

class Gif : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  /// A picture of one colour.
  std::string picture(const std::string& name, std::uint32_t colour) const {
    const std::vector<std::uint32_t> pixels(48, colour);
    write_image(path(name), PictureView(8, 6, pixels));
    return path(name);
  }

  const TestFolder folder_;
};

TEST_F(Gif, HoldsThePicturesInOrderAndTheirPace) {
  const std::vector<std::string> pictures = {picture("a.png", 0x0000ff), picture("b.png", 0x00ff00),
                                             picture("c.png", 0xff0000)};
  write_gif(path("w.gif"), pictures, 12);
  const auto input = OIIO::ImageInput::open(path("w.gif"));
  ASSERT_TRUE(input) << OIIO::geterror();
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(input->seek_subimage(i, 0));
    EXPECT_EQ(input->spec().width, 8);
    EXPECT_EQ(input->spec().height, 6);
    // Twelve a second are eight hundredths of a second each.
    EXPECT_NEAR(input->spec().get_float_attribute("FramesPerSecond"), 12.5, 1e-3);
    const int channels = input->spec().nchannels;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(48 * channels));
    ASSERT_TRUE(input->read_image(i, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes.data()));
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(bytes[static_cast<std::size_t>(channel)], channel == i ? 255 : 0) << i;
    }
  }
  EXPECT_FALSE(input->seek_subimage(3, 0));
}

TEST_F(Gif, IsWholeOrNotThere) {
  const std::vector<std::string> pictures = {picture("a.png", 1), path("gone.png")};
  EXPECT_THAT([&] { write_gif(path("w.gif"), pictures, 12); },
              ThrowsMessage<UserError>(path("gone.png") +
                                       ": this file is no longer the picture that dynrt wrote; "
                                       "remove it and run the same command again"));
  EXPECT_FALSE(fs::exists(path("w.gif")));
  EXPECT_EQ(names_in(folder_.path()).size(), 1u);
}

TEST_F(Gif, APictureIsWholeIfItCanBeReadToItsEnd) {
  const std::string whole = picture("a.png", 0x123456);
  EXPECT_TRUE(is_whole_picture(whole, 8, 6));
  EXPECT_FALSE(is_whole_picture(whole, 6, 8));
  EXPECT_FALSE(is_whole_picture(path("gone.png"), 8, 6));
  EXPECT_FALSE(is_whole_picture(folder_.path().string(), 8, 6));
  fs::resize_file(whole, fs::file_size(whole) / 2);
  EXPECT_FALSE(is_whole_picture(whole, 8, 6));
  std::ofstream(path("text.png")) << "no picture";
  EXPECT_FALSE(is_whole_picture(path("text.png"), 8, 6));
}

}  // namespace
}  // namespace dynrt::host
