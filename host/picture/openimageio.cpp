// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The library dynrt_images: ImageLibrary by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/picture/image_library.h"
#include "host/picture/picture_messages.h"
#include "host/picture/srgb.h"

namespace dynrt::host {

namespace {

constexpr int kChannels = 3;

std::uint8_t level(std::uint32_t pixel, int channel) {
  return static_cast<std::uint8_t>(pixel >> (8 * channel));
}

std::vector<std::uint8_t> bytes_of(const PictureView& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.pixels.size() * kChannels);
  for (const std::uint32_t pixel : picture.pixels) {
    for (int channel = 0; channel < kChannels; ++channel) bytes.push_back(level(pixel, channel));
  }
  return bytes;
}

OIIO::ImageSpec spec_of(const PictureView& picture, OIIO::TypeDesc type) {
  return {static_cast<int>(picture.width), static_cast<int>(picture.height), kChannels, type};
}

OIIO::ImageBuf buffer_of(const PictureView& picture) {
  std::vector<float> values;
  values.reserve(picture.pixels.size() * kChannels);
  for (const std::uint32_t pixel : picture.pixels) {
    for (int channel = 0; channel < kChannels; ++channel) {
      values.push_back(static_cast<float>(level(pixel, channel)) / 255);
    }
  }
  const OIIO::ImageSpec spec = spec_of(picture, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf buffer(spec);
  buffer.set_pixels(OIIO::get_roi(spec), OIIO::TypeDesc::FLOAT, values.data());
  return buffer;
}

struct Levels {
  OIIO::ImageSpec spec;
  std::vector<std::uint8_t> bytes;
};

/// False where there is no picture of three channels or it ends too early.
bool read(const std::string& path, Levels& levels) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(path, missing)) return false;
  const auto input = OIIO::ImageInput::open(path);
  if (!input) {
    OIIO::geterror();  // else it is printed at the program's end
    return false;
  }
  levels.spec = input->spec();
  if (levels.spec.nchannels != kChannels) return false;
  levels.bytes.resize(levels.spec.image_pixels() * kChannels);
  const bool whole =
      input->read_image(0, 0, 0, kChannels, OIIO::TypeDesc::UINT8, levels.bytes.data());
  input->geterror();
  return whole;
}

/// A file's name with the extension that its first bytes indicate, as OpenImageIO needs one. TGA
/// files have no such bytes.
std::string name_of(std::string_view content) {
  constexpr std::pair<std::string_view, const char*> kBeginnings[] = {
      {"\x89PNG", "png"}, {"\xFF\xD8\xFF", "jpg"}, {"BM", "bmp"},   {"GIF8", "gif"},
      {"RIFF", "webp"},   {"II*", "tif"},          {"MM", "tif"},   {"v/1\x01", "exr"},
      {"#?", "hdr"},      {"DDS ", "dds"},         {"8BPS", "psd"}, {"", "tga"}};
  const auto found = std::ranges::find_if(
      kBeginnings, [&](const auto& entry) { return content.starts_with(entry.first); });
  return std::string("texture.") + found->second;
}

constexpr int kRows = 64;                        // that are read at once
constexpr std::uint64_t kMostPixels = 1u << 28;  // of a picture

/// Adds up the rows of a picture; false where it ends too early.
template <typename Level, typename Linear>
bool add_rows(OIIO::ImageInput& input, const Linear& linear, std::array<double, 3>& sum) {
  const OIIO::ImageSpec spec = input.spec();
  const int channels = std::min(spec.nchannels, kChannels);
  const bool tiled = spec.tile_width > 0;
  const int rows = tiled ? spec.height : std::min(kRows, spec.height);
  std::vector<Level> levels(static_cast<std::size_t>(rows) * spec.width * channels);
  const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Level>::value;
  for (int y = 0; y < spec.height; y += rows) {
    const int count = std::min(rows, spec.height - y);
    const bool read = tiled ? input.read_image(0, 0, 0, channels, type, levels.data())
                            : input.read_scanlines(0, 0, spec.y + y, spec.y + y + count, 0, 0,
                                                   channels, type, levels.data());
    if (!read) return false;
    const std::size_t size = static_cast<std::size_t>(count) * spec.width * channels;
    for (std::size_t i = 0; i < size; i += channels) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += linear(levels[i + (channels < kChannels ? 0 : k)]);  // grey, else
      }
    }
  }
  return true;
}

class OpenImageIo final : public ImageLibrary {
 public:
  void write(const std::string& file, const std::string& path,
             const PictureView& picture) const override {
    const auto output = OIIO::ImageOutput::create(file);
    const bool exr = file.ends_with(".exr");
    OIIO::ImageSpec spec = spec_of(picture, exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec.attribute("Software", "dynrt");
    const std::vector<std::uint8_t> bytes = bytes_of(picture);
    if (!output || !output->open(file, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close()) {
      refuse(messages::kCannotWrite, path, output ? output->geterror() : OIIO::geterror());
    }
  }

  void write_gif(const std::string& file, const std::string& path,
                 std::span<const std::string> pictures, float per_second) const override {
    const auto output = OIIO::ImageOutput::create(file);
    if (!output) refuse(messages::kCannotWrite, path, OIIO::geterror());
    Levels levels;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      if (!read(pictures[i], levels)) {
        refuse(
            "{}: this file is no longer the picture that dynrt wrote; remove it and run the same "
            "command again",
            pictures[i]);
      }
      OIIO::ImageSpec spec(levels.spec.width, levels.spec.height, kChannels, OIIO::TypeDesc::UINT8);
      spec.attribute("FramesPerSecond", per_second);
      const auto mode = i == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
      if (!output->open(file, spec, mode) ||
          !output->write_image(OIIO::TypeDesc::UINT8, levels.bytes.data())) {
        refuse(messages::kCannotWrite, path, output->geterror());
      }
    }
    if (!output->close()) refuse(messages::kCannotWrite, path, output->geterror());
  }

  std::optional<PictureSize> size_of(const std::string& file) const override {
    Levels levels;
    if (!read(file, levels)) return std::nullopt;
    return PictureSize{static_cast<unsigned>(levels.spec.width),
                       static_cast<unsigned>(levels.spec.height)};
  }

  PictureDifference difference(const PictureView& expected, const PictureView& found,
                               float beyond) const override {
    const auto results =
        OIIO::ImageBufAlgo::compare(buffer_of(expected), buffer_of(found), beyond, 0.0F);
    return {results.meanerror, results.rms_error, results.PSNR, results.maxerror, results.nfail};
  }

  MeanColour mean_colour(std::span<const std::uint8_t> content) const override {
    OIIO::Filesystem::IOMemReader bytes(const_cast<std::uint8_t*>(content.data()), content.size());
    const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    // libpng would complain on the terminal.
    if (text.starts_with("\x89PNG") && text.rfind("IEND") == text.npos)
      return {{}, "it is cut off"};
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);  // colours not multiplied by alpha
    OIIO::Filesystem::IOProxy* proxy = &bytes;
    wanted.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(name_of(text), &wanted, &bytes);
    if (!input) return {{}, one_line(OIIO::geterror())};
    const OIIO::ImageSpec spec = input->spec();
    const auto pixels = static_cast<double>(spec.image_pixels());
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || pixels > kMostPixels) {
      return {{}, "its size is out of range"};
    }
    std::array<double, 3> sum{};
    const auto& table = linear_levels();
    const bool whole =
        spec.format.is_floating_point()
            ? add_rows<float>(
                  *input, [](float level) { return static_cast<double>(level); }, sum)
            : add_rows<std::uint8_t>(*input, [&](std::uint8_t level) { return table[level]; }, sum);
    if (!whole) return {{}, one_line(input->geterror())};
    for (double& channel : sum) channel /= pixels;
    return {sum, {}};
  }

 private:
  static std::string one_line(std::string reason) {
    std::ranges::replace(reason, '\n', ' ');
    while (reason.ends_with(' ') || reason.ends_with('.')) reason.pop_back();
    return reason.empty() ? "it is damaged" : reason;
  }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const ImageLibrary* dynrt_image_library() {
  static const OpenImageIo library;
  return &library;
}

}  // namespace dynrt::host
