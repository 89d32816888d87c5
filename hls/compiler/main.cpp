// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// hlsc: lowers a unit written in C++ to Verilog. `hlsc --help` lists what it takes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "backend.h"
#include "error.h"
#include "frontend/read_unit.h"

namespace {

struct Arguments {
  hlsc::UnitSource source;
  double clock_ns = 10;
  std::string delay;
  std::string verilog = "-";
  std::string report;
  std::string binding;
  std::string depfile;
  bool dump_netlist = false;
  bool dump_optimised = false;
};

void describe(CLI::App& app, Arguments& a) {
  app.add_option("--unit", a.source.unit, "C++ type of the unit, with its namespace")->required();
  app.add_option("--header", a.source.header, "header that defines it, as it is included")
      ->required();
  app.add_option("--module", a.source.module, "name of the Verilog module")->required();
  app.add_option("-I", a.source.folders, "folder to look for headers in; the language's too")
      ->allow_extra_args(false);
  app.add_option("--clang", a.source.clang, "clang to use")->capture_default_str();
  app.add_option("--clock-ns", a.clock_ns, "clock period to schedule for")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--delay", a.delay, "delay model of the device, such as delay/ecp5.json");
  app.add_option("-o", a.verilog, "Verilog file to write, - for the terminal")
      ->capture_default_str();
  app.add_option("--report", a.report, "file for stages, operations and registers");
  app.add_option("--binding", a.binding, "file for the test bench's header");
  app.add_option("--depfile", a.depfile, "file for the list of headers that were read");
  app.add_flag("--dump-ir", a.source.dump_ir, "print LLVM's IR as it is before if-conversion");
  app.add_flag("--dump-netlist", a.dump_netlist, "print the netlist and stop");
  app.add_flag("--dump-optimised", a.dump_optimised, "print the netlist as scheduled and stop");
}

/// Writes a file beside its place and moves it there, so that no half of one is left behind.
void write_file(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::ofstream file(part);
  file << text;
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0) {
    const std::string why = std::strerror(errno);
    std::remove(part.c_str());
    throw hlsc::Error({}, fmt::format("{} cannot be written: {}; name a file in a folder that "
                                      "exists and may be written",
                                      path, why));
  }
}

void lower(const Arguments& a, const hlsc::UnitNetlist& unit) {
  if (a.delay.empty()) {
    throw hlsc::Error({},
                      "--delay is missing; name a delay model such as "
                      "hls/compiler/delay/ecp5.json");
  }
  const hlsc::Options options{a.clock_ns, hlsc::load_delay_model(a.delay)};
  if (a.dump_optimised) {
    fmt::print("{}", hlsc::to_text(hlsc::optimise(unit.netlist, options)));
    return;
  }
  const hlsc::Lowered lowered = hlsc::lower(unit.netlist, options);
  std::string dependencies = a.verilog + ":";
  for (const std::string& file : unit.includes) dependencies += " \\\n  " + file;
  const std::vector<std::pair<std::string, std::string>> files{
      {a.verilog, lowered.verilog},
      {a.report, lowered.report},
      {a.binding, lowered.binding},
      {a.depfile, dependencies + "\n"},
  };
  for (const auto& [path, text] : files) {
    if (path == "-") {
      fmt::print("{}", text);
    } else if (!path.empty()) {
      write_file(path, text);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Lowers a unit written in C++ to Verilog.", "hlsc");
  describe(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    const hlsc::UnitNetlist unit = hlsc::read_unit(arguments.source);
    if (arguments.dump_netlist) {
      fmt::print("{}", hlsc::to_text(unit.netlist));
    } else {
      lower(arguments, unit);
    }
    return 0;
  } catch (const hlsc::Error& error) {
    fmt::print(stderr, "{}\n", error.text());
    return 1;
  }
}
