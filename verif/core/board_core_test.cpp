// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every board hands out every key of its core's configuration as hls/configs/configs.json has it:
// the model and the Verilog, built into the program or loaded.
#include <gtest/gtest.h>

#include <string>

#include "host/board/configurations.h"
#include "host/format/configuration_json.h"

namespace dynrt::host {
namespace {

/// With the name that --config takes.
void expect_every_key(const std::string& board, const std::string& name) {
  SCOPED_TRACE(board + " of " + name);
  const CoreConfiguration* listed = listed_configuration(name);
  ASSERT_NE(listed, nullptr);
  const auto made = make_board(configurations(), {board, name, ""});
  EXPECT_EQ(json_of(made->core()).dump(2), json_of(*listed).dump(2));
  EXPECT_EQ(made->core().general, nullptr);
  EXPECT_EQ(made->has_scan_out(), board == "rtl" && listed->scan_out);
}

TEST(BoardCore, TheModelHasEveryKey) {
  ASSERT_FALSE(configurations().empty());
  for (const Configuration& c : configurations()) expect_every_key("model", std::string(c.name));
}

TEST(BoardCore, TheVerilogHasEveryKey) {
  for (const Configuration& c : configurations()) {
    if (c.lowered) expect_every_key("rtl", std::string(c.name));
  }
}

}  // namespace
}  // namespace dynrt::host
