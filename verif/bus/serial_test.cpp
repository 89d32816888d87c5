// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt_serial, whose host is at the end of a serial line and whose memory is behind AXI4:
// everything goes over the line's pins, as on a board, and frames are those of the model, however
// the memory behaves. The rules of the bus hold in every clock.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "Vserial_fast_port.h"
#include "bus/axi_pins.h"
#include "configs/fast_port.h"
#include "core/specialised.h"
#include "host/board/registers.h"
#include "host/link/link.h"
#include "host/ulx3s/board_at_link.h"
#include "host/ulx3s/linked_board.h"
#include "link/test_board.h"
#include "ulx3s/serial_pins.h"

namespace dynrt::host::bus {
namespace {

namespace reg = registers;
using config::fast_port;

/// The top, its memory, and the host's end of the line. Time is counted in clocks.
class SimulatedSerial final : public ByteStream {
 public:
  SimulatedSerial(const Temper& temper, int seed)
      : ByteStream("the simulated board"), memory_(temper, seed) {
    context_->randReset(2);
    context_->randSeed(seed);
    context_->fatalOnError(false);  // $stop throws an exception
    top_ = std::make_unique<Vserial_fast_port>(context_.get());
    memory_.drive(*top_);
    top_->serial_i = 1;
    top_->rst_ni = 0;
    for (int i = 0; i < 4; ++i) clock();
    top_->rst_ni = 1;
    run(100);  // an idle line
  }
  ~SimulatedSerial() override {
    Verilated::threadContextp(context_.get());
    top_->final();
  }

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) pins_.send(byte);
    return bytes.size();
  }
  std::size_t read(std::span<std::uint8_t> bytes) override {
    std::deque<std::uint8_t>& received = pins_.received();
    const std::size_t count = std::min(bytes.size(), received.size());
    std::copy_n(received.begin(), count, bytes.begin());
    received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void wait(bool /*to_write*/, Time deadline) override {
    while (pins_.received().empty() && now() < deadline) run(100);
  }
  Time now() const override { return Time(clocks_ * kClockNs); }

  void run(unsigned clocks) {
    for (unsigned i = 0; i < clocks; ++i) clock();
  }
  AxiMemory<Vserial_fast_port>& memory() { return memory_; }

 private:
  static constexpr unsigned kClockNs = 12;

  void clock() {
    eval(0);
    if (top_->rst_ni) {
      memory_.sample(*top_);
      pins_.sample(clocks_, top_->serial_o != 0);
    }
    eval(1);
    memory_.drive(*top_);
    top_->serial_i = pins_.drive(clocks_);
    ++clocks_;
  }
  void eval(unsigned level) {
    Verilated::threadContextp(context_.get());
    set(top_->clk_i, level);
    top_->eval();
    if (context_->gotError()) {
      throw std::logic_error(fmt::format("an assertion does not hold in clock {}", clocks_));
    }
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Vserial_fast_port> top_;
  AxiMemory<Vserial_fast_port> memory_;
  SerialPins pins_{SERIAL_DIVISOR};
  std::uint64_t clocks_ = 0;
};

constexpr Temper kQuick{};
constexpr Temper kMoody{.ready = 50, .answers = 50, .most_clocks = 60};

/// A few triangles of each object, which a line carries in no time.
void make_small(Scene& scene) {
  constexpr std::size_t kTriangles = 6;
  for (Mesh& mesh : scene.objects) {
    if (mesh.triangles.size() <= kTriangles) continue;
    mesh.triangles.resize(kTriangles);
    mesh.material.resize(kTriangles);
  }
}

class Serial : public testing::TestWithParam<Temper> {
 public:
  Serial() {
    auto simulated = std::make_unique<SimulatedSerial>(GetParam(), 1);
    simulated_ = simulated.get();
    link_ = std::make_unique<BoardLink>(std::move(simulated));
    options_.width = 16;
    options_.height = 12;
    options_.timeout = 3'000'000;
  }
  /// The board that "serial:DEVICE" names.
  void make_board() {
    const LinkedCore& core = linked_core(*link_, "serial");
    auto linked =
        std::make_unique<LinkedBoard>(std::move(link_), nullptr, [this] { simulated_->run(1000); });
    board_ = std::make_unique<BoardAtLink>("serial", core, std::move(linked), nullptr);
    scene_ = laid_out("blocks", options_.width, options_.height, board_->core(), make_small);
  }
  void expect_frame() {
    const Frame frame = render(*board_, options_, *scene_);
    const Frame expected = render(*specialised::board_of<fast_port>(), options_, *scene_);
    EXPECT_GT(frame.hit_count(), 0u);
    EXPECT_EQ(frame.pixels, expected.pixels);
    EXPECT_EQ(frame.hits, expected.hits);
  }

  SimulatedSerial* simulated_;
  std::unique_ptr<BoardLink> link_;
  std::unique_ptr<BoardAtLink> board_;
  FrameOptions options_{.hits = true};
  std::optional<MemoryImage> scene_;
};
INSTANTIATE_TEST_SUITE_P(Memories, Serial, testing::Values(kQuick, kMoody),
                         [](const auto& info) { return info.index == 0 ? "Quick" : "Moody"; });

TEST_P(Serial, SaysWhatItIs) {
  EXPECT_EQ(link_->board().configuration, "fast_port");
  EXPECT_EQ(link_->board().clock_hz, 81'250'000u);
  EXPECT_EQ(link_->board().memory_bytes, 32u << 20);
  EXPECT_EQ(link_->board().divisor, SERIAL_DIVISOR);
}

/// Both below 16 MB, where the core reads too, and above, where it writes alone.
TEST_P(Serial, CarriesTheMemory) {
  const std::vector<std::uint8_t> low = random_bytes(700, 1), high = random_bytes(700, 2);
  link_->write_memory(36, low);
  link_->write_memory(kPixelsAt + 36, high);
  std::vector<std::uint8_t> back(700);
  link_->read_memory(36, back);
  EXPECT_EQ(back, low);
  link_->read_memory(kPixelsAt + 36, back);
  EXPECT_EQ(back, high);
  EXPECT_EQ(link_->counts().repeats, 0u);
  const BankWord at = bank_word(kPixelsAt + 36);
  EXPECT_EQ(simulated_->memory().sram().word(at.bank, at.word),
            std::uint32_t{high[0]} | high[1] << 8 | high[2] << 16 | std::uint32_t{high[3]} << 24);
}

/// Answered on the line, the last writes wait for a memory that takes nothing for a while. A read
/// of the memory waits for them, so they are behind it.
TEST_P(Serial, MovesTheMemoryBehindARead) {
  constexpr std::uint32_t kBase = 1u << 27;
  const std::vector<std::uint8_t> before = random_bytes(400, 1), behind = random_bytes(400, 2);
  simulated_->memory().stall(60'000);
  link_->write_memory(0, before);
  std::vector<std::uint8_t> back(400);
  link_->read_memory(0, std::span(back).first(4));
  link_->write_registers(reg::kRegMemoryBaseLow, std::array{kBase});
  simulated_->memory().set_base(kBase);
  link_->write_memory(4096, behind);
  link_->read_memory(0, back);
  EXPECT_EQ(back, before);
  link_->read_memory(4096, back);
  EXPECT_EQ(back, behind);
}

TEST_P(Serial, RendersTheModelsFrame) {
  make_board();
  expect_frame();
  options_.buffer = 1;
  expect_frame();
}

TEST_P(Serial, AFrameThatIsGivenUpLeavesNothingBehind) {
  make_board();
  expect_frame();
  for (unsigned clocks = 100; clocks < 2000; clocks += 311) {
    board_->configure(frame_config(board_->core(), options_, scene_->frame));
    board_->start();
    simulated_->run(clocks);
    board_->write_register(reg::kRegControl, 1u << reg::kControlReset);
    for (int waits = 0; board_->read_register(reg::kRegStatus) >> reg::kStatusBusy & 1;) {
      ASSERT_LT(++waits, 100);
    }
  }
  expect_frame();
}

TEST_P(Serial, TellsOfAnErrorOfTheMemory) {
  make_board();
  expect_frame();
  simulated_->memory().set_faults([](bool write, unsigned byte) {
    return !write && byte >= kEntriesAt && byte < kColumnsAt ? 2u : 0u;
  });
  board_->configure(frame_config(board_->core(), options_, scene_->frame));
  board_->start();
  for (int waits = 0; board_->read_register(reg::kRegStatus) >> reg::kStatusBusy & 1;) {
    ASSERT_LT(++waits, 10'000);
  }
  EXPECT_EQ(board_->read_register(reg::kRegMemoryError),
            1u << reg::kMemoryErrorSeen | 2u << reg::kMemoryErrorResponse);
  EXPECT_EQ(board_->read_register(reg::kRegMemoryErrorAddress),
            simulated_->memory().first_fault()->byte);
}

TEST_P(Serial, TellsOfAnErrorWhileResultsAreRead) {
  make_board();
  simulated_->memory().set_faults(
      [](bool write, unsigned byte) { return !write && byte >= kPixelsAt ? 2u : 0u; });
  const std::string said = fmt::format("answered a read of byte {:#x}", unsigned{kPixelsAt});
  EXPECT_THAT([&] { render(*board_, options_, *scene_); },
              testing::ThrowsMessage<UserError>(testing::HasSubstr(said)));
  simulated_->memory().set_faults([](bool, unsigned) { return 0u; });
  expect_frame();
}

}  // namespace
}  // namespace dynrt::host::bus
