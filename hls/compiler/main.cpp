// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// hlsc: lowers a unit written in C++ to Verilog. `hlsc --help` lists what it takes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>

#include "error.h"
#include "frontend/read_unit.h"

namespace {

struct Arguments {
  hlsc::UnitSource source;
  bool dump_netlist = false;
};

void describe(CLI::App& app, Arguments& a) {
  app.add_option("--unit", a.source.unit, "C++ type of the unit, with its namespace")->required();
  app.add_option("--header", a.source.header, "header that defines it, as it is included")
      ->required();
  app.add_option("--module", a.source.module, "name of the Verilog module")->required();
  app.add_option("-I", a.source.folders, "folder to look for headers in; the language's too")
      ->allow_extra_args(false);
  app.add_option("--clang", a.source.clang, "clang to use")->capture_default_str();
  app.add_flag("--dump-ir", a.source.dump_ir, "print LLVM's IR as it is before if-conversion");
  app.add_flag("--dump-netlist", a.dump_netlist, "print the netlist and stop");
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Lowers a unit written in C++ to Verilog.", "hlsc");
  describe(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    const hlsc::UnitNetlist unit = hlsc::read_unit(arguments.source);
    fmt::print("{}", hlsc::to_text(unit.netlist));
    return 0;
  } catch (const hlsc::Error& error) {
    fmt::print(stderr, "{}\n", error.text());
    return 1;
  }
}
