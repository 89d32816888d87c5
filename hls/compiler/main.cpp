// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// hlsc: lowers a unit written in C++ to Verilog. `hlsc --help` lists what it takes; README.md
// beside this file says what a unit may contain.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "backend.h"
#include "error.h"
#include "frontend/read_unit.h"
#include "output_files.h"

namespace {

constexpr char kNoDelay[] =
    "--delay is missing; name a delay model such as hls/compiler/delay/ecp5.json";

struct Arguments {
  hlsc::UnitSource source;
  double clock_ns = 10;
  std::string delay;
  std::string verilog = "-";
  std::string report;
  std::string schedule;
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
  app.add_option("-I", a.source.folders,
                 "folder to look for headers in; the language's lowered folder first")
      ->allow_extra_args(false);
  app.add_option("--clock-ns", a.clock_ns, "clock period to schedule for, in ns")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--delay", a.delay, "delay model of the device family (JSON)");
  app.add_option("-o", a.verilog, "Verilog to write, - for the terminal")->capture_default_str();
  app.add_option("--report", a.report, "schedule report to write");
  app.add_option("--schedule", a.schedule, "the schedule's stages as JSON to write");
  app.add_option("--binding", a.binding, "C++ header for the test bench to write");
  app.add_option("--depfile", a.depfile,
                 "make rule to write: the Verilog and all it was made from");
  app.add_option("--clang", a.source.clang, "clang to use")->capture_default_str();
  app.add_option("--clang-arg", a.source.clang_args, "argument for clang, such as -DNAME=1")
      ->allow_extra_args(false);
  app.add_flag("--dump-netlist", a.dump_netlist, "print the netlist instead of lowering it");
  app.add_flag("--dump-optimised", a.dump_optimised,
               "print the netlist as it is scheduled instead");
  app.add_flag("--dump-ir", a.source.dump_ir, "print LLVM's IR as it is before if-conversion");
}

std::string make_rule(const std::string& target, const std::vector<std::string>& files) {
  std::string rule = target + ":";
  for (std::string file : files) {
    for (std::size_t i = 0; (i = file.find(' ', i)) != std::string::npos; i += 2) {
      file.insert(i, "\\");
    }
    rule += " \\\n  " + file;
  }
  return rule + "\n";
}

void run(const Arguments& a) {
  if (!a.dump_netlist && a.delay.empty()) throw hlsc::Error({}, kNoDelay);
  const hlsc::UnitNetlist unit = hlsc::read_unit(a.source);
  if (a.dump_netlist) {
    fmt::print("{}", hlsc::to_text(unit.netlist));
    return;
  }
  const hlsc::Options options{a.clock_ns, hlsc::load_delay_model(a.delay)};
  if (a.dump_optimised) {
    fmt::print("{}", hlsc::to_text(hlsc::optimise(unit.netlist, options)));
    return;
  }
  const hlsc::Lowered lowered = hlsc::lower(unit.netlist, options);
  hlsc::OutputFiles files;
  files.add(a.verilog, lowered.verilog);
  files.add(a.report, lowered.report);
  files.add(a.schedule, lowered.schedule);
  files.add(a.binding, lowered.binding);
  files.add(a.depfile, make_rule(a.verilog, unit.includes));
  files.commit();
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Lowers a unit written in C++ to Verilog.", "hlsc");
  describe(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
    return 0;
  } catch (const hlsc::Error& error) {
    fmt::print(stderr, "{}\n", error.text());
  } catch (const std::exception& error) {
    fmt::print(stderr, "hlsc: error: {}\n", error.what());
  }
  return 1;
}
