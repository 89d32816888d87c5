// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// record_frame SCENE CONFIG WxH FOLDER: renders a frame on the native model and writes what
// core_bench.v needs to render it elsewhere and to compare: the scene banks, the frame's registers,
// the words of the framebuffer and of the hit records. Few cache lines, for they are cleared first.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/text.h"
#include "host/board/frame_words.h"
#include "host/error.h"
#include "host/render/output_file.h"

namespace dynrt::host {
namespace {

constexpr unsigned kLines = 16;
constexpr std::uint64_t kMaxClocks = 10'000'000;

std::string hex(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words) text += fmt::format("{:08x}\n", word);
  return text;
}

void record(const std::string& scene, const std::string& configuration, const std::string& size,
            const std::string& folder) {
  const auto board = make_board(configurations(), {"model", configuration, ""});
  FrameOptions options;
  std::tie(options.width, options.height) = parse_size(size);
  options.lines = kLines;
  SceneArguments arguments;
  arguments.scene = scene;
  const Prepared prepared = prepare(arguments, options.width, options.height, &board->info());
  const Frame frame = render_on(*board, options, prepared);
  if (frame.hit_count() == 0)
    refuse("{}: no ray of {} hits; record a frame that shows something", scene, size);

  const FrameConfig config =
      frame_config(board->info(), options, addresses_of(prepared.frame, prepared.scene));
  write_text(folder + "/frame.hex", hex(board->info().frame_words(config)));
  std::array<std::string, kSceneBanks> banks;
  for (const MemoryPart* part : {&prepared.objects.memory, &prepared.frame.memory}) {
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
