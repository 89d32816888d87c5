// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/write_image.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include "host/error.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;
using testing::ThrowsMessage;

struct Pixels {
  unsigned width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
};

class WriteImage : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::size_t files() const { return names_in(folder_.path()).size(); }

  const TestFolder folder_;
  const Pixels picture_{3, 2, {0x0000ff, 0x00ff00, 0xff0000, 0x000000, 0xffffff, 0x804020}};
};

std::vector<float> read_back(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  EXPECT_TRUE(input) << OIIO::geterror();
  if (!input) return {};
  EXPECT_EQ(input->spec().width, 3);
  EXPECT_EQ(input->spec().height, 2);
  std::vector<float> values(18);
  EXPECT_EQ(input->spec().nchannels, 3);
  EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data()));
  return values;
}

TEST_F(WriteImage, PngAndExrHoldThePixels) {
  const std::vector<float> expected = {1, 0, 0, 0, 1, 0, 0,          0,          1,  //
                                       0, 0, 0, 1, 1, 1, 32 / 255.f, 64 / 255.f, 128 / 255.f};
  for (const char* name : {"image.png", "image.exr"}) {
    write_image(path(name), picture_);
    EXPECT_THAT(read_back(path(name)), testing::Pointwise(testing::FloatNear(1e-3f), expected))
        << name;
  }
  EXPECT_EQ(files(), 2u);
}

TEST_F(WriteImage, ReplacesAnOlderFile) {
  std::ofstream(path("image.png")) << "not an image";
  write_image(path("image.png"), picture_);
  EXPECT_EQ(read_back(path("image.png")).size(), 18u);
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteImage, AFileThatCannotBeWrittenIsAnErrorAndNothingIsLeft) {
  fs::create_directory(path("image.png"));
  EXPECT_THAT(
      [&] { write_image(path("image.png"), picture_); },
      ThrowsMessage<UserError>(path("image.png") + ": cannot write this file (Is a directory); "
                                                   "name a file in a folder that can be written"));
  EXPECT_EQ(files(), 1u);
}

/// No file may grow beyond so many bytes, as if the disk were full; the signal that comes with it
/// is ignored.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(WriteImage, AFullDiskLeavesThePreviousImageWhole) {
  write_image(path("a.png"), picture_);
  const auto size = fs::file_size(path("a.png"));
  Pixels large;
  large.width = large.height = 64;
  for (unsigned i = 0; i < 64 * 64; ++i) large.pixels.push_back(i * 2654435761u);
  {
    const SmallDisk disk(1000);
    EXPECT_THAT([&] { write_image(path("a.png"), large); },
                ThrowsMessage<UserError>(testing::StartsWith(path("a.png") + ": ")));
  }
  EXPECT_EQ(fs::file_size(path("a.png")), size);
  EXPECT_EQ(files(), 1u);
  write_image(path("a.png"), large);
  EXPECT_GT(fs::file_size(path("a.png")), 1000u);
}

}  // namespace
}  // namespace dynrt::host
