// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The boards that a program has. Its table, which CMake makes, lists every configuration of
// hls/configs/configs.json; a few are built in, with their native core and, where the Verilog was
// built, the Verilated board. It holds only the limits of the others, which are loaded on first use
// (load_configuration.h).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/board/board.h"
#include "host/board/clocked_board.h"
#include "host/board/model_board.h"

namespace dynrt::host {

struct Configuration {
  std::string_view name;
  CoreInfo (*core)() = nullptr;
  bool lowered = false;             ///< builds make its Verilog
  MakeNativeCore native = nullptr;  ///< null, and so is what follows: not built in
  MakeBoard rtl = nullptr;          ///< null, and so is what follows: built without the Verilog
  MakeTracedBoard traced = nullptr;
  std::string_view (*core_json)() =
      nullptr;  ///< the core as its join describes it: dynrt_core.json
};

/// The configuration that frames are rendered with where no other is named.
inline constexpr const char* kDefaultConfiguration = "fast";

struct BoardRequest {
  std::string board = "rtl";
  std::string configuration = kDefaultConfiguration;  ///< a name of the table, FILE.so or FILE.json
  std::string trace;                                  ///< an FST file, or empty
  std::string schedule = {};  ///< of the model: the folder of its units' schedules, or empty
  bool shows = false;         ///< its VGA display will show the picture
};

/// The table of this build.
std::span<const Configuration> configurations();

/// The names of those for which a condition holds, in the table's order.
std::vector<std::string_view> names_of(std::span<const Configuration> table,
                                       const std::function<bool(const Configuration&)>& condition);

/// The configuration of a name of the table, FILE.so or FILE.json, loaded if it is not built in,
/// and with `rtl` with its Verilated boards if it has any. Throws UserError for an unknown one.
const Configuration& find_configuration(std::span<const Configuration> table,
                                        const std::string& name, bool rtl);

/// Throws UserError for an unknown board or configuration, and for waveforms of the model or
/// schedules of the Verilog.
std::unique_ptr<Board> make_board(std::span<const Configuration> table,
                                  const BoardRequest& request);

/// Counters of a core in the order of their addresses, from its dynrt_core.json.
std::vector<Counter> counters_of(std::string_view core_json);

}  // namespace dynrt::host
