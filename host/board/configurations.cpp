// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/configurations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "host/board/load_configuration.h"
#include "host/board/rtl_board.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr unsigned kSramBits = 32;  ///< of a word of the RTL's banks
constexpr int kTraceSeed = 1;       ///< waveforms are the same every time

std::string list_of(std::span<const Configuration> table,
                    const std::function<bool(const Configuration&)>& condition) {
  return fmt::format("{}", fmt::join(names_of(table, condition), ", "));
}

bool any(const Configuration&) { return true; }
bool has_rtl(const Configuration& configuration) {
  return configuration.rtl != nullptr || configuration.lowered;
}

}  // namespace

const Configuration& find_configuration(std::span<const Configuration> table,
                                        const std::string& name, bool rtl) {
  const auto found = std::ranges::find(table, name, &Configuration::name);
  if (found == table.end()) {
    // A user may name the folder that dynrt specialise has written.
    std::error_code unreachable;
    if (std::filesystem::is_directory(name, unreachable)) {
      refuse(
          "configuration {}: this is a folder, but a configuration is a file; name one, such as "
          "the {} that dynrt specialise writes",
          name, (std::filesystem::path(name) / "configuration.json").string());
    }
    if (!is_configuration_file(name)) {
      refuse(
          "configuration {}: there is no such configuration; name one of {}, or a file FILE.json "
          "or FILE.so",
          name, list_of(table, any));
    }
    return load_configuration(name, rtl);
  }
  if (found->native != nullptr || found->rtl != nullptr) return *found;
  if (rtl && !found->lowered) return *found;  // no library has more
  return load_listed_configuration(name, rtl);
}

std::vector<std::string_view> names_of(std::span<const Configuration> table,
                                       const std::function<bool(const Configuration&)>& condition) {
  std::vector<std::string_view> names;
  for (const Configuration& configuration : table) {
    if (condition(configuration)) names.push_back(configuration.name);
  }
  return names;
}

std::unique_ptr<Board> make_board(std::span<const Configuration> table,
                                  const BoardRequest& request) {
  const bool rtl = request.board == "rtl";
  if (!rtl && request.board != "model") {
    refuse("board {}: there is no such board; the boards are rtl, model, ulx3s and serial:DEVICE",
           request.board);
  }
  const Configuration& configuration = find_configuration(table, request.configuration, rtl);
  CoreInfo core = configuration.core();
  core.name = configuration.name;
  add_general(core);
  if (!rtl) {
    if (!request.trace.empty()) {
      refuse(
          "waveforms: only board rtl has signals to record; take board rtl or leave the waveforms "
          "out");
    }
    return std::make_unique<ModelBoard>(std::move(core), configuration.native(), request.schedule);
  }
  if (!request.schedule.empty()) {
    refuse(
        "schedules: only board model counts its clocks with schedules, as the Verilog has clocks "
        "of its own; take board model or leave the schedules out");
  }
  if (core.format->word_bits > kSramBits) {
    refuse(
        "configuration {}: a float of {} bits needs memory words of {} bits, but the SRAM of board "
        "rtl has words of {}; take board model",
        configuration.name, 1 + core.format->exponent_bits + core.format->mantissa_bits,
        core.format->word_bits, kSramBits);
  }
  if (configuration.rtl == nullptr) {
    if (std::ranges::none_of(table, has_rtl)) {
      refuse(
          "board rtl: the Verilog of configuration {} is not part of this build; configure with "
          "-DDYNRT_RTL=ON or take board model",
          configuration.name);
    }
    refuse(
        "configuration {}: it has only the native model, so it has no board rtl; take a "
        "configuration with Verilog ({}), or give it \"rtl\": true in hls/configs/configs.json and "
        "build again",
        configuration.name, list_of(table, has_rtl));
  }
  return std::make_unique<RtlBoard>(
      std::move(core),
      request.trace.empty() ? configuration.rtl() : configuration.traced(request.trace, kTraceSeed),
      counters_of(configuration.core_json()));
}

std::vector<Counter> counters_of(std::string_view core_json) {
  std::vector<Counter> counters;
  const auto core = nlohmann::json::parse(core_json);
  for (const auto& counter : core.at("counters")) {
    counters.push_back(
        {.name = counter.at("name"), .order_independent = counter.at("order_independent")});
  }
  return counters;
}

}  // namespace dynrt::host
