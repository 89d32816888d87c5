// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What `dynrt info` writes for a host of one's own, put into the memory and the registers of
// dynrt_axi, gives the model's picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "Vaxi_fast_port.h"
#include "bus/axi_pins.h"
#include "bus/bus_board.h"
#include "configs/fast_port.h"
#include "core/scenes.h"
#include "host/board/native_core.h"
#include "host/board/registers.h"
#include "host/board/rtl_board.h"
#include "host/render/render.h"
#include "host/run_program.h"
#include "host/test_folder.h"
#include "units/pixel.h"

namespace dynrt::host::bus {
namespace {

namespace reg = registers;

constexpr FrameOptions kFrame{.width = 40, .height = 30, .timeout = 3'000'000};
constexpr std::uint64_t kMost = 1'000'000;  ///< clocks

Frame expected() {
  ModelBoard model(core_info_of_listed<config::fast_port>("fast_port"),
                   std::make_unique<NativeCoreOf<config::fast_port>>());
  return render(model, kFrame, laid_out("blocks", kFrame.width, kFrame.height, model.core()));
}

TEST(InfoFiles, GiveTheModelsPicture) {
  BusBoard<Vaxi_fast_port, AxiMemory, AxiLiteHost> board({}, 1);
  board.reset();
  const std::uint32_t limits = board.read_register(reg::kRegLimits)->data;
  const TestFolder folder;
  const Outcome info =
      run_program(DYNRT_PROGRAM,
                  fmt::format("info blocks --size {}x{} --packets {} --lines {} --memory "
                              "memory.bin --registers registers.json",
                              kFrame.width, kFrame.height, limits & 0xffff, limits >> 16),
                  folder.path());
  ASSERT_EQ(info.code, 0) << info.err;
  const std::string bytes = text_of(folder.path() / "memory.bin");
  const auto registers = nlohmann::json::parse(text_of(folder.path() / "registers.json"));
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto low = static_cast<std::uint8_t>(bytes[i]);
    const auto high = static_cast<std::uint8_t>(bytes[i + 1]);
    const auto half = static_cast<std::uint16_t>(low | high << 8);
    if (half != 0) write_port_half(board.memory().sram(), static_cast<unsigned>(i), half);
  }
  const auto number = [](const nlohmann::json& text) {
    return static_cast<std::uint32_t>(std::stoul(text.get<std::string>(), nullptr, 16));
  };
  const auto write = [&](std::uint32_t address, std::uint32_t word) {
    ASSERT_TRUE(board.write(address, std::span(&word, 1))) << address;
  };
  const auto is = [&](unsigned bit) {
    return (board.read_register(reg::kRegStatus)->data >> bit & 1) != 0;
  };
  while (is(reg::kStatusBusy)) board.clock();
  for (const auto& one : registers["writes"]) write(number(one["address"]), number(one["value"]));
  write(reg::kRegIrqEnable, 1);
  write(reg::kRegControl, 1u << reg::kControlStart);
  ASSERT_FALSE(is(reg::kStatusRefused));
  ASSERT_TRUE(board.run_until_interrupt(kMost));

  const Frame model = expected();
  ASSERT_GT(model.hit_count(), 100u);
  const unsigned pitch = registers["pixels"]["in_a_row"];
  const unsigned at = registers["pixels"]["byte"];
  ASSERT_EQ(registers["pixels"]["bytes_each"], 2);
  unsigned different = 0;
  for (unsigned y = 0; y < kFrame.height; ++y) {
    for (unsigned x = 0; x < kFrame.width; ++x) {
      const unsigned byte = at + 2 * (y * pitch + x);
      const Sram& sram = board.memory().sram();
      const auto pixel = uint<16>::from(port_byte(sram, byte) | port_byte(sram, byte + 1) << 8);
      const std::uint64_t colour = HalfPixel::colour(pixel).to_u64();
      different += colour != model.pixels[y * kFrame.width + x] ? 1 : 0;
    }
  }
  EXPECT_EQ(different, 0u);
}

}  // namespace
}  // namespace dynrt::host::bus
