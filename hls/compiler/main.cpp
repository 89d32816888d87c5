// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// hlsc: lowers a unit written in C++ to Verilog. `hlsc --help` lists its flags; README.md in this
// folder says which C++ a unit may use.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "backend.h"
#include "error.h"
#include "frontend/read_unit.h"
#include "output_files.h"

namespace {

constexpr char kNoDelay[] =
    "--delay is missing; name a delay model such as hls/compiler/delay/ecp5.json";

constexpr char kClock[] =
    "--clock-ns {}: this is no period of a clock; give the ns from edge to edge, a number above 0 "
    "such as {}, or {} for the shortest that the unit reaches";

constexpr char kNoPass[] = "there is no pass '{}'; --print-after takes one of {}";

constexpr char kTimeByAlone[] =
    "--time-by {}: nothing shows its times; name the file that receives them with --timing";

constexpr unsigned kMostRoom = 1024;
constexpr double kMostUncertainty = 10;  // ns

constexpr char kUsualClock[] = "10";
constexpr char kLeast[] = "least";

struct Arguments {
  hlsc::UnitSource source;
  std::string clock_ns = kUsualClock;
  unsigned room = hlsc::kLeastRoom;
  double uncertainty_ns = 0;
  std::string delay;
  std::string verilog = "-";
  std::string report;
  std::string schedule;
  std::string timing;
  std::vector<std::string> time_by;
  std::string binding;
  std::string depfile;
  std::string precompile;
  std::string print_after;
  bool dump_netlist = false;
};

/// Without names that came before.
std::vector<std::string> once(const std::vector<std::string>& names) {
  std::vector<std::string> left;
  for (const std::string& name : names) {
    if (std::find(left.begin(), left.end(), name) == left.end()) left.push_back(name);
  }
  return left;
}

/// All passes in the order in which they run.
std::vector<std::string> pass_names() {
  std::vector<std::string> names = hlsc::ir_passes();
  for (const std::string& pass : once(hlsc::netlist_passes())) names.push_back(pass);
  return names;
}

void describe(CLI::App& app, Arguments& a) {
  app.add_option("--unit", a.source.unit, "C++ type of the unit, with its namespace");
  app.add_option("--header", a.source.header,
                 "header that defines the unit, as an #include names it")
      ->required();
  app.add_option("--module", a.source.module, "name of the Verilog module");
  app.add_option("-I", a.source.folders,
                 "folder with headers; give the language's lowered folder first")
      ->allow_extra_args(false);
  app.add_option("--clock-ns", a.clock_ns,
                 "clock period of the schedule, in ns; least: the shortest that the unit reaches")
      ->type_name("NS")
      ->capture_default_str();
  app.add_option("--room", a.room,
                 "tokens that each FIFO takes beyond those in the pipeline, at least")
      ->check(CLI::Range(hlsc::kLeastRoom, kMostRoom))
      ->capture_default_str();
  app.add_option("--uncertainty", a.uncertainty_ns,
                 "ns of each clock that stay free, for wires that the delay model does not know")
      ->type_name("NS")
      ->check(CLI::Range(0.0, kMostUncertainty))
      ->capture_default_str();
  app.add_option("--delay", a.delay, "delay model of the device family (JSON)");
  app.add_option("-o", a.verilog, "write the Verilog to this file; - is the terminal")
      ->capture_default_str();
  app.add_option("--report", a.report, "write a report of the schedule to this file");
  app.add_option("--schedule", a.schedule,
                 "write the stages of the schedule to this file, as JSON");
  app.add_option("--timing", a.timing,
                 "write when each register and RAM port gets its value to this file, as JSON");
  app.add_option("--time-by", a.time_by,
                 "a further delay model, which --timing shows and the schedule does not use")
      ->allow_extra_args(false);
  app.add_option("--binding", a.binding, "write a C++ header for the test bench to this file");
  app.add_option(
      "--depfile", a.depfile,
      "write a make rule to this file: the Verilog and every file that it was made from");
  app.add_option("--clang", a.source.clang, "the clang to run")->capture_default_str();
  app.add_option("--clang-arg", a.source.clang_args, "argument for clang, such as -DNAME=1")
      ->allow_extra_args(false);
  app.add_option("--precompile", a.precompile,
                 "lower no unit; write the header, precompiled, to this file")
      ->excludes("--unit")
      ->excludes("--module");
  app.add_option(
      "--precompiled", a.source.precompiled,
      "headers that --precompile wrote, with the same -I and --delay, and that need not be "
      "parsed again");
  app.callback([&app, &a] {
    for (const char* needed : {"--unit", "--module"}) {
      if (a.precompile.empty() && app.count(needed) == 0) throw CLI::RequiredError(needed);
    }
  });
  app.add_flag("--dump-netlist", a.dump_netlist,
               "print the netlist that the front end makes, and write no file");
  app.add_option("--print-after", a.print_after,
                 "print the netlist or IR after each run of this pass, and write no file")
      ->type_name("PASS");
  app.footer(fmt::format("Passes on LLVM's IR:\n  {}\nPasses on the netlist:\n  {}",
                         fmt::join(hlsc::ir_passes(), " "),
                         fmt::join(once(hlsc::netlist_passes()), " ")));
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

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Nothing if the unit says it.
std::optional<double> parse_period(const std::string& text) {
  if (text == kLeast) return std::nullopt;
  char* end = nullptr;
  const double period = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(period) || period <= 0) {
    throw hlsc::Error({}, fmt::format(kClock, text, kUsualClock, kLeast));
  }
  return period;
}

void run(const Arguments& a) {
  const std::optional<double> clock_ns = parse_period(a.clock_ns);
  const std::string& shown = a.print_after;
  if (!shown.empty() && !contains(pass_names(), shown)) {
    throw hlsc::Error({}, fmt::format(kNoPass, shown, fmt::join(pass_names(), ", ")));
  }
  const bool ir_alone = contains(hlsc::ir_passes(), shown);
  if (!a.time_by.empty() && a.timing.empty()) {
    throw hlsc::Error({}, fmt::format(kTimeByAlone, a.time_by.front()));
  }
  if (!a.dump_netlist && !ir_alone && a.delay.empty()) throw hlsc::Error({}, kNoDelay);
  hlsc::Options options{clock_ns.value_or(0), {}, a.room, a.uncertainty_ns};
  if (!a.delay.empty()) options.delay = hlsc::load_delay_model(a.delay);
  for (const std::string& path : a.time_by) options.time_by.push_back(hlsc::load_delay_model(path));
  hlsc::UnitSource source = a.source;
  if (!options.delay.has_multipliers()) source.clang_args.emplace_back("-DHLS_HARD_MULTIPLIERS=0");
  if (!a.precompile.empty()) {
    hlsc::precompile(source, a.precompile);
    return;
  }
  if (ir_alone) source.print_after = shown;
  const hlsc::UnitNetlist unit = hlsc::read_unit(source);
  if (a.dump_netlist) fmt::print("{}", hlsc::to_text(unit.netlist));
  if (a.dump_netlist || ir_alone) return;
  if (!shown.empty()) {
    hlsc::optimise(unit.netlist, options, [&shown](const std::string& pass, const auto& netlist) {
      if (pass == shown) fmt::print("; after {}\n{}", pass, hlsc::to_text(netlist));
    });
    return;
  }
  if (!clock_ns) options.clock_ns = hlsc::least_period(unit.netlist, options);
  const hlsc::Lowered lowered = hlsc::lower(unit.netlist, options);
  hlsc::OutputFiles files;
  files.add(a.verilog, lowered.verilog);
  files.add(a.report, lowered.report);
  files.add(a.schedule, lowered.schedule);
  files.add(a.timing, lowered.timing);
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
