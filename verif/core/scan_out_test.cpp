// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Double buffering with the whole core: while it renders a frame into one buffer, the display's
// pins show the other, pixel for pixel, and the frame takes not a clock longer for it. On the board
// that checks the Verilog's assertions, for every configuration of this build that has a scan-out.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/board/configurations.h"
#include "host/board/display.h"
#include "host/layout/lay_out.h"
#include "host/render/render.h"
#include "host/scene/load.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 24;
constexpr unsigned kHeight = 16;
constexpr DisplayMode kMode = {32, 33, 36, 40, 20, 21, 23, 25, false, false};
constexpr unsigned kClocks = 2;  ///< a pixel takes, the fewest: the bank is as busy as can be
constexpr std::uint64_t kTimeout = 1'000'000;

using Words = std::vector<std::uint32_t>;

/// The scene `blocks` on a board with a scan-out, seen from anywhere, in any buffer.
class Rendering {
 public:
  explicit Rendering(const Configuration& c) : board_(info_of(c), c.traced("", 1), {}) {
    options_.width = kWidth;
    options_.height = kHeight;
  }
  RtlBoard& board() { return board_; }

  /// Renders the scene from `position` into the buffer at `base`; the clocks that it takes.
  std::uint64_t render(const glm::dvec3& position, std::uint32_t base) {
    const Scene blocks = load_scene("blocks");
    const Camera camera = choose_camera(
        blocks,
        {.position = position, .look_at = glm::dvec3(0, 0.5, 0), .up = {}, .field_of_view = {}},
        kWidth, kHeight);
    const MemoryImage scene = lay_out(blocks, {camera, kWidth, kHeight}, board_.core());
    for (const MemoryRun& run : scene.runs()) board_.write(run.bank, run.address, run.words);
    FrameConfig frame = frame_config(board_.core(), options_, scene.frame);
    frame.frame_base = Word::from(base);
    board_.configure(frame);
    board_.start();
    return *board_.wait(kTimeout, {}).cycles;
  }
  Words pixels(std::uint32_t base) {
    Words words(std::size_t{kWidth} * kHeight);
    board_.read(kFrameBank, base, words);
    return words;
  }

 private:
  static CoreInfo info_of(const Configuration& c) {
    CoreInfo info = c.core();
    info.name = c.name;
    return info;
  }
  RtlBoard board_;
  FrameOptions options_;
};

/// The display with the picture in its middle and black around.
Words on_display(const Words& picture) {
  constexpr unsigned kLeft = (kMode.hdisplay - kWidth) / 2;
  constexpr unsigned kTop = (kMode.vdisplay - kHeight) / 2;
  Words pixels(std::size_t{kMode.hdisplay} * kMode.vdisplay, 0);
  for (unsigned y = 0; y < kHeight; ++y) {
    for (unsigned x = 0; x < kWidth; ++x) {
      pixels[(y + kTop) * kMode.hdisplay + x + kLeft] = picture[y * kWidth + x];
    }
  }
  return pixels;
}

void expect_shows(const DisplayFrame& frame, const Words& picture) {
  EXPECT_EQ(frame.fault, "");
  EXPECT_EQ(frame.mode, kMode);
  EXPECT_EQ(frame.pixel_time, kClocks);
  EXPECT_EQ(frame.pixels, on_display(picture));
}

TEST(ScanOut, ShowsOneBufferWhileTheOtherIsRendered) {
  constexpr std::uint32_t kBuffers[] = {0, 400'000};
  const glm::dvec3 kPositions[] = {{4, 3, 5}, {-5, 2, 3}, {1, 6, -4}};
  unsigned boards = 0;
  for (const Configuration& listed : configurations()) {
    if (!listed.lowered) continue;
    const auto& c = find_configuration(configurations(), std::string(listed.name), true);
    if (!RtlBoard(c.core(), c.rtl(), {}).core().scan_out) continue;
    SCOPED_TRACE(c.name);
    ++boards;
    std::vector<Words> expected;
    std::vector<std::uint64_t> alone;
    Rendering dark(c);
    for (const glm::dvec3& position : kPositions) {
      alone.push_back(dark.render(position, kBuffers[1]));
      expected.push_back(dark.pixels(kBuffers[1]));
    }
    ASSERT_NE(expected[0], expected[1]);
    ASSERT_NE(expected[1], expected[2]);

    Rendering lit(c);
    EXPECT_EQ(lit.render(kPositions[0], kBuffers[0]), alone[0]);
    Display display(lit.board(), kMode, kClocks, kBuffers[0], kWidth, kHeight);
    display.wait(1);
    for (unsigned i = 1; i < std::size(kPositions); ++i) {
      const std::size_t before = display.frames().size();
      EXPECT_EQ(lit.render(kPositions[i], kBuffers[i % 2]), alone[i]);
      display.wait(1);
      EXPECT_GT(display.frames().size(), before + 2) << "no display was whole in the frame's time";
      for (std::size_t f = before; f < display.frames().size(); ++f) {
        expect_shows(display.frames()[f], expected[i - 1]);
      }
      EXPECT_EQ(lit.pixels(kBuffers[i % 2]), expected[i]);

      display.show(kBuffers[i % 2]);
      while (display.shown() != kBuffers[i % 2]) expect_shows(display.wait(1), expected[i - 1]);
      display.wait(1);
      expect_shows(display.wait(1), expected[i]);
    }
  }
  EXPECT_GT(boards, 0u);
}

}  // namespace
}  // namespace dynrt::host
