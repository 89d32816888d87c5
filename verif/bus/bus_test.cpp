// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores behind AXI4 and Wishbone render the pictures of their models, however the memory behaves;
// and an error of the memory ends in a register, not in a frame that never ends.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "Vaxi_fast_port.h"
#include "Vaxi_fast_port_32.h"
#include "Vwishbone_fast_port.h"
#include "Vwishbone_fast_port_32.h"
#include "bus/axi_pins.h"
#include "bus/bus_board.h"
#include "bus/wishbone_pins.h"
#include "configs/fast_port.h"
#include "configs/fast_port_32.h"
#include "core/scenes.h"
#include "host/board/configurations.h"
#include "host/board/native_core.h"
#include "host/board/rtl_board.h"
#include "host/render/compare.h"
#include "host/render/render.h"
#include "host/test_error.h"

namespace dynrt::host::bus {
namespace {

namespace reg = registers;

constexpr Temper kQuick{};
constexpr Temper kMoody{.ready = 50, .answers = 50, .most_clocks = 60};
constexpr Temper kSlow{.ready = 20, .answers = 90, .most_clocks = 300};
constexpr Temper kHasty{.ready = 90, .answers = 10, .most_clocks = 4};

std::vector<Counter> counters_of_configuration(const std::string& name) {
  std::ifstream file(GENERATED_FOLDER "/" + name + "/dynrt_core.json");
  return counters_of(std::string(std::istreambuf_iterator<char>(file), {}));
}

/// A top of configuration C behind a bus.
template <class C, class V, template <class> class Memory, template <class> class Host>
struct Top {
  using Config = C;
  using Board = BusBoard<V, Memory, Host>;
};
struct AxiOf16Bytes : Top<config::fast_port, Vaxi_fast_port, AxiMemory, AxiLiteHost> {
  static constexpr const char* kName = "fast_port";
  static constexpr std::uint64_t kBase = 0x12'4000'0000;
};
struct AxiOf4Bytes : Top<config::fast_port_32, Vaxi_fast_port_32, AxiMemory, AxiLiteHost> {
  static constexpr const char* kName = "fast_port_32";
  static constexpr std::uint64_t kBase = 0xfe'0000'0000;
};
struct WishboneOf16Bytes
    : Top<config::fast_port, Vwishbone_fast_port, WishboneMemory, WishboneHost> {
  static constexpr const char* kName = "fast_port";
  static constexpr std::uint64_t kBase = 0xc200'0000;
};
struct WishboneOf4Bytes
    : Top<config::fast_port_32, Vwishbone_fast_port_32, WishboneMemory, WishboneHost> {
  static constexpr const char* kName = "fast_port_32";
  static constexpr std::uint64_t kBase = 0;
};

template <class T>
class Buses : public testing::Test {
 public:
  using Bus = typename T::Board;

  void make(const Temper& temper, int seed) {
    CoreInfo info = core_info_of<typename T::Config>();
    info.name = T::kName;
    auto bus = std::make_unique<Bus>(temper, seed);
    bus_ = bus.get();
    board_ = std::make_unique<RtlBoard>(info, std::move(bus), counters_of_configuration(T::kName));
    board_->write_register(reg::kRegMemoryBaseLow, static_cast<std::uint32_t>(T::kBase));
    board_->write_register(reg::kRegMemoryBaseHigh, static_cast<std::uint32_t>(T::kBase >> 32));
    bus_->memory().set_base(T::kBase);
  }
  MemoryImage scene() const {
    return laid_out("blocks", options_.width, options_.height, board_->core());
  }
  Frame expected() {
    CoreInfo info = core_info_of<typename T::Config>();
    info.name = T::kName;
    ModelBoard model(std::move(info), std::make_unique<NativeCoreOf<typename T::Config>>());
    return render(model, options_, scene());
  }
  void expect_frame(const Frame& expected) {
    const Frame frame = render(*board_, options_, scene());
    const Comparison comparison = compare(frame, expected);
    EXPECT_GT(comparison.hits, comparison.pixels / 8);
    EXPECT_EQ(comparison.pixels, std::uint64_t{options_.width} * options_.height);
    EXPECT_TRUE(comparison.identical()) << comparison.first->text("rtl", "model");
    EXPECT_EQ(board_->read_register(reg::kRegMemoryError), 0u);
  }

  FrameOptions options_{.width = 40, .height = 30, .timeout = 3'000'000};
  Bus* bus_ = nullptr;
  std::unique_ptr<RtlBoard> board_;
};
using Tops = testing::Types<AxiOf16Bytes, AxiOf4Bytes, WishboneOf16Bytes, WishboneOf4Bytes>;
TYPED_TEST_SUITE(Buses, Tops);

TYPED_TEST(Buses, RenderTheModelsFrameWhateverTheMemoryDoes) {
  this->make(kQuick, 1);
  const Frame expected = this->expected();
  int seed = 1;
  for (const Temper& temper : {kQuick, kMoody, kSlow, kHasty}) {
    SCOPED_TRACE(fmt::format("memory {}", seed));
    this->make(temper, ++seed);
    // Twice, as a core must begin its second frame as it did its first.
    this->expect_frame(expected);
    this->expect_frame(expected);
    EXPECT_GT(this->bus_->memory().reads(), 100u);
    EXPECT_GT(this->bus_->memory().writes(), 100u);
  }
}

TYPED_TEST(Buses, AFrameThatIsGivenUpLeavesNothingBehind) {
  this->make(kMoody, 7);
  const Frame expected = this->expected();
  const MemoryImage scene = this->scene();
  for (const MemoryRun& run : scene.runs()) this->board_->write(run.bank, run.address, run.words);
  std::uint64_t clocks = 700;
  for (int i = 0; i < 12; ++i) {
    this->board_->configure(frame_config(this->board_->core(), this->options_, scene.frame));
    this->board_->start();
    EXPECT_FALSE(this->bus_->run_until_interrupt(clocks));
    clocks += 997;
    this->board_->write_register(reg::kRegControl, 1u << reg::kControlReset);
    // The core stays in its reset until the memory has answered.
    for (int waits = 0; this->board_->read_register(reg::kRegStatus) >> reg::kStatusBusy & 1;) {
      ASSERT_LT(++waits, 500);
    }
  }
  this->expect_frame(expected);
}

/// The frame ends, the registers tell of the first error that the memory gave, and so does who
/// waits for the frame.
template <class Test>
void expect_fault_is_told(Test& test, std::function<unsigned(bool, unsigned)> faults) {
  test.bus_->memory().set_faults(std::move(faults));
  const MemoryImage scene = test.scene();
  for (const MemoryRun& run : scene.runs()) test.board_->write(run.bank, run.address, run.words);
  test.board_->configure(frame_config(test.board_->core(), test.options_, scene.frame));
  test.board_->start();
  ASSERT_TRUE(test.bus_->run_until_interrupt(test.options_.timeout));
  const std::optional<Fault> fault = test.bus_->memory().first_fault();
  ASSERT_TRUE(fault);
  EXPECT_EQ(test.board_->read_register(reg::kRegStatus) >> reg::kStatusMemoryError & 1, 1u);
  const std::uint32_t told = test.board_->read_register(reg::kRegMemoryError);
  EXPECT_EQ(told, 1u << reg::kMemoryErrorSeen |
                      std::uint32_t{fault->write} << reg::kMemoryErrorWrite |
                      fault->response << reg::kMemoryErrorResponse);
  EXPECT_EQ(test.board_->read_register(reg::kRegMemoryErrorAddress), fault->byte);
  EXPECT_EQ(user_error([&] { test.board_->wait(1, {}); }),
            fmt::format("board rtl: {} answered a {} of byte {:#x} of the core's memory, so the "
                        "frame may be wrong; look at what stands behind the core's port at that "
                        "address",
                        fault->response == 3 ? "no memory, but an error of the bus,"
                                             : "an error of the memory",
                        fault->write ? "write" : "read", fault->byte));
  EXPECT_EQ(test.board_->read_register(reg::kRegMemoryError), 0u);
  EXPECT_EQ(test.board_->read_register(reg::kRegMemoryErrorAddress), 0u);
  test.bus_->memory().set_faults({});
  test.bus_->memory().forget_fault();
}

TYPED_TEST(Buses, AnErrorIsToldAndTheFrameEnds) {
  this->make(kMoody, 3);
  const Frame expected = this->expected();
  unsigned reads = 0, writes = 0;
  const auto number = [](unsigned nth, unsigned& count, unsigned response) {
    return ++count == nth ? response : 0u;
  };
  // A read, a write, a kind of item, and everything.
  expect_fault_is_told(*this,
                       [&](bool write, unsigned) { return write ? 0u : number(90, reads, 2); });
  expect_fault_is_told(*this,
                       [&](bool write, unsigned) { return write ? number(40, writes, 3) : 0u; });
  for (const auto [from, to] : {std::pair{0u, kEntriesAt}, std::pair{kEntriesAt, kColumnsAt},
                                std::pair{kColumnsAt, kPixelsAt}, std::pair{kPixelsAt, kHitsAt}}) {
    expect_fault_is_told(*this,
                         [=](bool, unsigned byte) { return byte >= from && byte < to ? 3u : 0u; });
  }
  expect_fault_is_told(*this, [](bool, unsigned) { return 2u; });
  this->expect_frame(expected);
}

TYPED_TEST(Buses, RegistersAnswer) {
  this->make(kQuick, 5);
  auto& bus = *this->bus_;
  EXPECT_EQ(bus.read_register(reg::kRegId)->data, reg::kIdValue);
  // No register: behind the last, behind the frame's, of the display, behind all.
  const std::uint32_t behind_frame =
      reg::kRegFrame + 4 * this->board_->read_register(reg::kRegFrameWords);
  for (const std::uint32_t address :
       {reg::kRegMemoryBaseHigh + 4, behind_frame, reg::kRegScan, 0xffcu}) {
    EXPECT_TRUE(bus.read_register(address)->error) << address;
    EXPECT_EQ(bus.read_register(address)->data, 0u) << address;
    EXPECT_TRUE(bus.try_write(address, 1, 15)->error) << address;
  }
  // Less than a whole word.
  EXPECT_FALSE(bus.try_write(reg::kRegFrame, 0x12345678, 15)->error);
  for (unsigned strobe = 0; strobe < 15; ++strobe) {
    EXPECT_TRUE(bus.try_write(reg::kRegFrame, 0, strobe)->error) << strobe;
  }
  EXPECT_EQ(bus.read_register(reg::kRegFrame)->data, 0x12345678u);
  // Many, in any timing.
  std::mt19937 random(1);
  for (unsigned i = 0; i < 500; ++i) {
    const auto word = static_cast<std::uint32_t>(random());
    const auto at = static_cast<std::uint32_t>(reg::kRegFrame + 4 * (random() % 8));
    ASSERT_FALSE(bus.try_write(at, word, 15)->error);
    ASSERT_EQ(bus.read_register(at)->data, word);
  }
}

}  // namespace
}  // namespace dynrt::host::bus
