// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/render.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "hls/bits.h"
#include "host/error.h"
#include "host/format/frame_words.h"
#include "host/render/frame_refused.h"
#include "units/memory_format.h"

namespace dynrt::host {

namespace {

constexpr unsigned kFullAmbient = 256;
constexpr unsigned kAmbient = 64;  ///< where there are lights: a quarter
constexpr std::uint32_t kBufferPixels = kBankWords / kFrameBuffers;
static_assert(kMaxPixels <= kBufferPixels && kBufferPixels % kPitchStep == 0 &&
              kBufferPixels % 16 == 0);  // of 16 bits, those of a display's burst

/// An image's words, so many for each pixel, without the gaps between its rows.
std::vector<std::uint32_t> without_gaps(std::vector<std::uint32_t> words, unsigned pitch,
                                        const FrameOptions& image, unsigned of_pixel) {
  if (pitch == image.width) return words;
  const std::size_t row = std::size_t{image.width} * of_pixel;
  for (std::size_t y = 0; y < image.height; ++y) {
    std::ranges::copy_n(words.begin() + static_cast<std::ptrdiff_t>(y * pitch * of_pixel),
                        static_cast<std::ptrdiff_t>(row),
                        words.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  words.resize(row * image.height);
  return words;
}

std::vector<std::uint32_t> read_pixels(Board& board, std::uint32_t first,
                                       const FrameOptions& image) {
  const unsigned pitch = board.core().pitch(image.width);
  std::vector<std::uint32_t> pixels(std::size_t{pitch} * image.height);
  board.read_pixels(first, pixels);
  return without_gaps(std::move(pixels), pitch, image, 1);
}

/// Those of one of the banks.
std::vector<std::uint32_t> read_hit_words(Board& board, unsigned bank, const FrameOptions& image) {
  const unsigned pitch = board.core().pitch(image.width);
  std::vector<std::uint32_t> words(std::size_t{pitch} * image.height * kHitWords);
  board.read(bank, 0, words);
  return without_gaps(std::move(words), pitch, image, kHitWords);
}

template <unsigned W>
std::uint32_t number(hls::uint<W> bits) {
  return static_cast<std::uint32_t>(bits.to_u64());
}

std::vector<HitRecord> read_hits(Board& board, const FrameOptions& image) {
  const auto first = read_hit_words(board, kHitBank, image);
  const auto second = read_hit_words(board, kHitBank + 1, image);
  std::vector<HitRecord> hits(std::size_t{image.width} * image.height);
  for (std::size_t p = 0; p < hits.size(); ++p) {
    const auto place = hls::unpack<HitPlace>(&first[p * kHitWords]);
    const auto surface = hls::unpack<HitSurface>(&second[p * kHitWords]);
    hits[p] = {.hit = place.hit,
               .object = number(place.object),
               .triangle = number(surface.triangle),
               .t = number(place.t),
               .u = number(surface.u),
               .v = number(place.v),
               .cosine = number(surface.cosine)};
  }
  return hits;
}

template <class... Args>
[[noreturn]] void refuse_option(const char* option, fmt::format_string<const Args&...> message,
                                const Args&... args) {
  throw FrameRefused(option, fmt::format(message, args...));
}

}  // namespace

void check_size(unsigned width, unsigned height) {
  const std::uint64_t pixels = std::uint64_t{width} * height;
  if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide || pixels > kMaxPixels) {
    refuse_option("size",
                  "an image of {}x{} pixels is impossible: it has 1 to {} pixels a side and at "
                  "most {} in all; the board's framebuffer and hit records hold no more",
                  width, height, kMaxSide, kMaxPixels);
  }
}

namespace {

void check_pitch(const CoreInfo& core, unsigned width, unsigned height) {
  const unsigned pitch = core.pitch(width);
  if (std::uint64_t{pitch} * height <= kMaxPixels) return;
  refuse_option("size",
                "configuration {} cannot hold an image of {}x{} pixels: its rows begin {} pixels "
                "apart in the memory, which holds {} pixels",
                core.name, width, height, pitch, kMaxPixels);
}

}  // namespace

FrameConfig frame_config(const CoreInfo& core, const FrameOptions& options,
                         const SceneAddresses& scene) {
  check_size(options.width, options.height);
  check_pitch(core, options.width, options.height);
  const unsigned packets = options.packets.value_or(core.packets);
  const unsigned lines = options.lines.value_or(core.lines);
  if (packets == 0 || packets > core.packets) {
    refuse_option("packets", "configuration {} holds 1 to {} packets, not {}", core.name,
                  core.packets, packets);
  }
  if (options.uncompressed && !core.uncompressed) {
    if (core.is_specialised()) refuse_excess({"uncompressed", "true", "false"}, core, "the frame");
    refuse_option("uncompressed",
                  "configuration {} transforms one origin for all rays of a packet and cannot "
                  "transform one for each ray; take another configuration",
                  core.name);
  }
  const unsigned least = core.least_lines();
  if (!std::has_single_bit(lines) || lines < least || lines > core.lines) {
    refuse_option("lines", "the caches of configuration {} have {}, {}, {} up to {} lines, not {}",
                  core.name, least, 2 * least, 4 * least, core.lines, lines);
  }
  FrameConfig frame;
  frame.packets = to_word(packets);
  frame.line_mask = to_word(lines - 1);
  frame.width = to_word(options.width);
  frame.height = to_word(options.height);
  frame.scanline = to_word(options.order == RayOrder::kScanline);
  frame.morton_bits = to_word(morton_bits(options.width, options.height, core.packet_rays));
  frame.start_node = to_word(scene.start_node);
  frame.camera_matrix = to_word(scene.camera_matrix);
  frame.background = to_word(options.background);
  frame.frame_base = to_word(options.buffer % kFrameBuffers * kBufferPixels);
  frame.write_hits = to_word(options.hits);
  frame.uncompressed = to_word(options.uncompressed);
  // A core without light rays has the eye light alone.
  const unsigned lights = std::min(scene.lights, core.lights);
  frame.lights = to_word(lights);
  frame.light_matrix = to_word(scene.light_matrix);
  frame.colour = to_word(scene.colour);
  frame.object = to_word(scene.first_instance);
  frame.others_node = to_word(scene.others_node);
  frame.box_column = to_word(scene.box_column);
  frame.boxes_apart = to_word(scene.boxes_apart);
  frame.ambient = to_word(lights > 0 ? kAmbient : kFullAmbient);
  const unsigned reflections = options.reflections.value_or(core.reflections);
  if (reflections > core.reflections) {
    refuse_option("reflections", "configuration {} traces at most {} reflections of a ray, not {}",
                  core.name, core.reflections, reflections);
  }
  frame.reflections = to_word(reflections);
  memory_timing(core, options);
  return frame;
}

std::optional<MemoryTiming> memory_timing(const CoreInfo& core, const FrameOptions& options) {
  const auto clocks = [&](const char* option, std::optional<unsigned> given, unsigned low,
                          unsigned high, unsigned otherwise) {
    if (given && core.memory == MemoryPath::kBanks) {
      refuse_option(
          option,
          "the scene of configuration {} lies in banks of SRAM, whose clocks are its own; a "
          "configuration with \"memory\": \"port\" has a memory whose clocks can be chosen",
          core.name);
    }
    if (given && (*given < low || *given > high)) {
      refuse_option(option, "the emulated memory takes {} to {} clocks, not {}", low, high, *given);
    }
    return given.value_or(otherwise);
  };
  MemoryTiming timing;
  timing.latency =
      clocks("memory-latency", options.memory_latency, 1, kMaxMemoryLatency, timing.latency);
  timing.row_clocks = clocks("row-clocks", options.row_clocks, 0, kMaxRowClocks, timing.row_clocks);
  if (core.memory == MemoryPath::kBanks) return std::nullopt;
  return timing;
}

Frame render(Board& board, const FrameOptions& options, const SceneAddresses& scene,
             std::span<const MemoryRun> memory, const PixelProgress& progress) {
  const FrameConfig config = frame_config(board.core(), options, scene);
  const BusTraffic before = board.traffic();
  std::optional<MemoryTiming> timing;
  if (board.emulates_memory()) timing = memory_timing(board.core(), options);
  if (timing) board.set_memory_timing(*timing);
  for (const MemoryRun& part : memory) board.write(part.bank, part.address, part.words);
  board.finish_writes();
  Frame frame;
  frame.upload = board.traffic() - before;
  board.configure(config);
  board.start();
  frame.board = board.name();
  frame.core = board.core();
  frame.width = options.width;
  frame.height = options.height;
  frame.timing = timing;
  frame.clock_hz = board.clock_hz();
  frame.bus = board.bus();
  frame.packets = static_cast<unsigned>(config.packets.to_u64());
  frame.lines = static_cast<unsigned>(config.line_mask.to_u64()) + 1;
  frame.run = board.wait(options.timeout, progress);
  frame.pixels = read_pixels(board, number(config.frame_base), options);
  if (options.hits) frame.hits = read_hits(board, options);
  board.finish_reads();
  frame.counters = board.counters();
  frame.traffic = board.traffic() - before;
  return frame;
}

Frame render(Board& board, const FrameOptions& options, const MemoryImage& image,
             const PixelProgress& progress) {
  check_laid_out_for(image, board.core());
  return render(board, options, image.frame, image.runs(), progress);
}

}  // namespace dynrt::host
