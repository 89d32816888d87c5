// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The boards of the program that the tests run. Configuration stand_in has the board's real Verilog
// around the stand-in core of host/board/test, which traces no rays, so its frames differ from the
// model's; model_only has no Verilog, and neither has lit, which has light rays and reflections.
#include "host/board/configurations.h"

#include "configs/thesis.h"
#include "configs/whitted.h"
#include "host/board/native_core.h"

namespace dynrt::host {

std::unique_ptr<ClockedBoard> make_stand_in_board();
std::unique_ptr<ClockedBoard> make_stand_in_board_traced(const std::string& trace, int seed);

namespace {

std::unique_ptr<NativeCore> make_core() { return std::make_unique<NativeCoreOf<config::thesis>>(); }
std::unique_ptr<NativeCore> make_lit_core() {
  return std::make_unique<NativeCoreOf<config::whitted>>();
}

CoreInfo thesis_info() { return core_info_of_listed<config::thesis>("thesis"); }
CoreInfo whitted_info() { return core_info_of_listed<config::whitted>("whitted"); }

std::string_view stand_in_json() {
  return R"({"counters": [{"name": "stand_in.transactions", "order_independent": true},
                          {"name": "start.tokens", "order_independent": true}]})";
}

}  // namespace

std::span<const Configuration> configurations() {
  static constexpr Configuration kTable[] = {
      {.name = "model_only", .core = thesis_info, .native = make_core},
      {.name = "stand_in",
       .core = thesis_info,
       .native = make_core,
       .rtl = make_stand_in_board,
       .traced = make_stand_in_board_traced,
       .core_json = stand_in_json},
      {.name = "lit", .core = whitted_info, .native = make_lit_core},
  };
  return kTable;
}

}  // namespace dynrt::host
