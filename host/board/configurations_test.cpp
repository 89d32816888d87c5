// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/configurations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host/error.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

using testing::ThrowsMessage;

class EmptyCore final : public NativeCore {
 public:
  void write(unsigned, std::uint32_t, std::span<const std::uint32_t>) override {}
  void read(unsigned, std::uint32_t, std::span<std::uint32_t>) override {}
  std::optional<std::uint64_t> render(const FrameConfig&, const hls::ModuleSchedules*,
                                      FrameWatch*) override {
    return std::nullopt;
  }
  std::vector<Counter> counters() override { return {}; }
};

CoreInfo limits() {
  CoreInfo info;
  info.packets = 2;
  info.lines = 4;
  info.stack_depth = 5;
  info.lights = 6;
  info.reflections = 7;
  info.scan_out = true;
  return info;
}

CoreInfo wide() { return CoreInfo(kMemoryFormatOf<hls::Float<8, 23>>); }

constexpr Configuration kTable[] = {
    {.name = "small",
     .core = limits,
     .native = []() -> std::unique_ptr<NativeCore> { return std::make_unique<EmptyCore>(); }},
    {.name = "large",
     .core = limits,
     .native = []() -> std::unique_ptr<NativeCore> { return std::make_unique<EmptyCore>(); }},
    {.name = "wide", .core = wide, .native = []() -> std::unique_ptr<NativeCore> {
       return std::make_unique<EmptyCore>();
     }}};

TEST(Configurations, RefusesSchedulesOfTheVerilog) {
  EXPECT_THAT([] { make_board(kTable, {"rtl", "small", "", "schedules"}); },
              ThrowsMessage<UserError>(
                  "schedules: only board model counts its clocks with schedules, as the Verilog "
                  "has clocks of its own; take board model or leave the schedules out"));
}

auto making(const BoardRequest& request) {
  return [request] { make_board(kTable, request); };
}

TEST(Configurations, MakesTheModelOfTheNamedConfiguration) {
  const auto board = make_board(kTable, {.board = "model", .configuration = "large", .trace = ""});
  EXPECT_EQ(board->name(), "model");
  EXPECT_EQ(board->core().name, "large");
  EXPECT_EQ(board->core().packets, 2u);
  EXPECT_EQ(board->core().lines, 4u);
  EXPECT_EQ(board->core().stack_depth, 5u);
  EXPECT_EQ(board->core().lights, 6u);
  EXPECT_EQ(board->core().reflections, 7u);
}

TEST(Configurations, TheModelShowsNoPicture) {
  const auto board = make_board(kTable, {.board = "model", .configuration = "small", .trace = ""});
  EXPECT_TRUE(board->core().scan_out);
  EXPECT_FALSE(board->has_scan_out());
  EXPECT_THAT([&] { board->check_display(8, 8); },
              ThrowsMessage<UserError>(
                  "board model of configuration small has no scan-out; take board rtl and a "
                  "configuration with the key scan_out, such as thesis"));
}

TEST(Configurations, WhatIsUnknownIsNamed) {
  EXPECT_THAT(making({.board = "fpga", .configuration = "small", .trace = ""}),
              ThrowsMessage<UserError>(
                  "board fpga: there is no such board; the boards are rtl, model, ulx3s and "
                  "serial:DEVICE"));
  EXPECT_THAT(
      making({.board = "model", .configuration = "huge", .trace = ""}),
      ThrowsMessage<UserError>("configuration huge: there is no such configuration; name one of "
                               "small, large, wide, or a file FILE.json or FILE.so"));
  EXPECT_THAT(making({.board = "model", .configuration = "small", .trace = "a.fst"}),
              ThrowsMessage<UserError>("waveforms: only board rtl has signals to record; take "
                                       "board rtl or leave the waveforms out"));
  EXPECT_THAT(making({.board = "rtl", .configuration = "small", .trace = ""}),
              ThrowsMessage<UserError>(
                  "board rtl: the Verilog of configuration small is not part of this build; "
                  "configure with -DDYNRT_RTL=ON or take board model"));
}

TEST(Configurations, AFolderIsNoConfiguration) {
  const TestFolder folder;
  for (const char* name : {"made", "made.json"}) {
    const std::string path = folder.path(name);
    std::filesystem::create_directory(path);
    EXPECT_THAT(making({.board = "model", .configuration = path, .trace = ""}),
                ThrowsMessage<UserError>(
                    "configuration " + path +
                    ": this is a folder, but a configuration is a file; name one, such as the " +
                    path + "/configuration.json that dynrt specialise writes"));
  }
}

TEST(Configurations, TheRtlsMemoryHoldsNoWideFloats) {
  EXPECT_THAT(making({.board = "rtl", .configuration = "wide", .trace = ""}),
              ThrowsMessage<UserError>(
                  "configuration wide: a float of 32 bits needs memory words of 43 bits, but the "
                  "SRAM of board rtl has words of 32; take board model"));
  const auto board = make_board(kTable, {.board = "model", .configuration = "wide", .trace = ""});
  EXPECT_EQ(board->core().format->mantissa_bits, 23u);
  // Of the scene's banks a word is two of the bus.
  board->write(0, kBankWords - 2, std::vector<std::uint32_t>(4));
  EXPECT_THROW(board->write(0, kBankWords - 1, std::vector<std::uint32_t>(4)), std::out_of_range);
  EXPECT_THROW(board->write(3, kBankWords - 2, std::vector<std::uint32_t>(4)), std::out_of_range);
}

TEST(Configurations, CountersComeFromTheJoin) {
  const auto counters = counters_of(
      R"({"counters": [{"name": "step.tokens", "order_independent": true},
                       {"name": "list.stalls", "order_independent": false}]})");
  ASSERT_EQ(counters.size(), 2u);
  EXPECT_EQ(counters[0].name, "step.tokens");
  EXPECT_TRUE(counters[0].order_independent);
  EXPECT_EQ(counters[1].name, "list.stalls");
  EXPECT_FALSE(counters[1].order_independent);
}

}  // namespace
}  // namespace dynrt::host
