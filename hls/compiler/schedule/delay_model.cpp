// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/delay_model.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "error.h"

namespace hlsc {

DelayModel load_delay_model(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    throw Error(
        {},
        fmt::format(
            "{}: cannot read this file; name a delay model such as hls/compiler/delay/ecp5.json",
            path));
  }
  const auto data = nlohmann::json::parse(file, nullptr, false);
  if (!data.is_object()) throw Error({}, fmt::format("{}: not a JSON object", path));
  const auto number = [&](const char* key, double least) {
    const auto found = data.find(key);
    if (found == data.end() || !found->is_number() || found->get<double>() < least) {
      throw Error({}, fmt::format("{}: the key \"{}\" is missing; give a number of at least {}",
                                  path, key, least));
    }
    return found->get<double>();
  };
  DelayModel m;
  m.name = data.value("name", path);
  m.clock_overhead = number("clock_overhead", 0);
  m.lut = number("lut", 0);
  m.lut_inputs = static_cast<unsigned>(number("lut_inputs", 3));
  m.fanout_two = number("fanout_two", 0);
  m.fanout = number("fanout", 0);
  m.carry_start = number("carry_start", 0);
  m.carry_bit = number("carry_bit", 0);
  m.compare_out = number("compare_out", 0);
  m.free_add_sub = number("free_add_sub", 0) != 0;
  m.division_digits = static_cast<unsigned>(number("division_digits", 1));
  m.multiply = number("multiply", 0);
  m.block_register = number("block_register", 0);
  m.multiplier_width = static_cast<unsigned>(number("multiplier_width", 2));
  m.unsigned_multiplier_width = static_cast<unsigned>(number("unsigned_multiplier_width", 1));
  m.ram_out = number("ram_out", 0);
  m.ram_in = number("ram_in", 0);
  m.lut_ram = number("lut_ram", 0);
  m.lut_ram_rows = static_cast<unsigned>(number("lut_ram_rows", 0));
  m.lut_ram_bits = static_cast<unsigned>(number("lut_ram_bits", 0));
  m.longest_shift = static_cast<int>(number("longest_shift", 4));
  m.token_in = number("token_in", 0);
  m.token_out = number("token_out", 0);
  m.token_enable = number("token_enable", 0);
  return m;
}

}  // namespace hlsc
