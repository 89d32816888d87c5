// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// record_frame SCENE CONFIG WxH FOLDER: renders a frame on the native model and writes the files
// with which core_bench.v renders and compares it: the scene banks, the frame's registers, the
// words of the framebuffer and of the hit records. Few cache lines, for they are cleared first, and
// few reflections, whose packets wait for each other.
//
// It refuses a frame that could not show a wrong core: the rays must hit several objects, and if
// the core has light rays, some must be blocked and darken their pixels.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <set>

#include "core/scenes.h"
#include "host/analysis/truth/measures.h"
#include "host/board/configurations.h"
#include "host/error.h"
#include "host/format/frame_words.h"
#include "host/picture/output_file.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

constexpr unsigned kLines = 16;
constexpr unsigned kReflections = 1;
constexpr std::uint64_t kMaxClocks = 10'000'000;
constexpr unsigned kVisible = 8;  // levels of 256, more than the core's rounding

std::string hex(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words) text += fmt::format("{:08x}\n", word);
  return text;
}

unsigned objects_hit(const Frame& frame) {
  std::set<std::uint32_t> objects;
  for (const HitRecord& hit : frame.hits) {
    if (hit.hit) objects.insert(hit.object);
  }
  return static_cast<unsigned>(objects.size());
}

/// How many rays the truth has that end in shadow and without which a pixel of the frame is visibly
/// darker than it would be with them.
std::size_t shadows(const Frame& frame, const TruthFrame& truth) {
  return static_cast<std::size_t>(
      std::ranges::count_if(truth.light_rays, [&](const LightRayTruth& ray) {
        if (!ray.shadow) return false;
        for (unsigned k = 0; k < 3; ++k) {
          const unsigned lit = std::min((truth.unlimited[ray.pixel][k] + ray.adds[k]) / 16, 255u);
          if ((frame.pixels[ray.pixel] >> 8 * k & 255) + kVisible < lit) return true;
        }
        return false;
      }));
}

void record(const std::string& scene, const std::string& configuration, const std::string& size,
            const std::string& folder) {
  const auto board = make_board(configurations(), {"model", configuration, ""});
  FrameOptions options;
  if (std::sscanf(size.c_str(), "%ux%u", &options.width, &options.height) != 2) {
    refuse("{}: not a size; write the pixels as WxH, for example 16x12", size);
  }
  options.lines = kLines;
  options.reflections = std::min(kReflections, board->core().reflections);
  const MemoryImage image = laid_out(scene, options.width, options.height, board->core());
  const Frame frame = render(*board, options, image);
  const FrameConfig config = frame_config(board->core(), options, image.frame);
  const unsigned objects = objects_hit(frame);
  if (objects < 2) {
    refuse("{}: the rays of {} hit {}; record a frame that shows several objects", scene, size,
           objects == 1 ? "one object" : "nothing");
  }
  std::string seen = fmt::format("{} objects hit", objects);
  if (board->core().lights > 0) {
    const TruthFrame truth =
        truth_of_frame(Truth(image.scene), image.view.camera, shading_of(board->core(), config));
    const std::size_t dark = shadows(frame, truth);
    if (dark == 0) {
      refuse("{}: no light ray of {} is blocked; record a frame with shadows", scene, size);
    }
    seen += fmt::format(", {} blocked of {} light rays", dark, truth.light_rays.size());
  }

  write_text(folder + "/frame.hex", hex(board->core().frame_words(config)));
  std::array<std::string, kSceneBanks> banks;
  for (const MemoryPart* part : {&image.objects.memory, &image.frame.memory}) {
    for (const MemoryRun& run : part->runs()) {
      banks.at(run.bank) += fmt::format("@{:x}\n{}", run.address, hex(run.words));
    }
  }
  for (unsigned b = 0; b < kSceneBanks; ++b) {
    write_text(fmt::format("{}/scene{}.hex", folder, b), banks[b]);
  }
  write_text(folder + "/expected3.hex", hex(frame.pixels));
  const std::size_t hit_words = frame.pixels.size() * kHitWords;
  for (unsigned bank = kHitBank; bank < kHitBank + 2; ++bank) {
    std::vector<std::uint32_t> words(hit_words);
    board->read(bank, 0, words);
    write_text(fmt::format("{}/expected{}.hex", folder, bank), hex(words));
  }
  write_text(folder + "/sizes.vh",
             fmt::format("`define PIXEL_WORDS {}\n`define HIT_WORDS {}\n`define MAX_CLOCKS {}\n",
                         frame.pixels.size(), hit_words, kMaxClocks));
  fmt::print("{} in {}: {}\n", scene, size, seen);
}

}  // namespace
}  // namespace dynrt::host

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: record_frame SCENE CONFIG WxH FOLDER\n");
    return 2;
  }
  try {
    dynrt::host::record(argv[1], argv[2], argv[3], argv[4]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "record_frame: {}\n", error.what());
    return 1;
  }
}
