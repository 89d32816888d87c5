// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Stands for measure_command.cpp, stress_command.cpp and truth_report.cpp, and with them for the
// truth and the stress cases of host/analysis, in a program that is built alone
// (DYNRT_PROGRAM_ONLY), without CGAL and Embree. That program renders; these commands say how to
// build them.
#include "host/app/command.h"
#include "host/app/truth_report.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kNoTruth[] =
    "this program was built by scripts/demo without CGAL and Embree, which find what a ray really "
    "hits; scripts/test --build-only installs both and builds the whole program";

Command refused_command(CLI::App& program, const char* name, const char* about) {
  CLI::App* command = program.add_subcommand(name, about);
  command->allow_extras();  // whatever its flags are, the sentence is the same
  return {command, []() -> int { refuse(kNoTruth); }};
}

}  // namespace

void require_truth() { refuse(kNoTruth); }

Command add_measure_command(CLI::App& program) {
  return refused_command(program, "measure",
                         "compare a frame with exact results: not in this program, see README.md");
}
Command add_stress_command(CLI::App& program) {
  return refused_command(program, "stress",
                         "run hard and extreme cases: not in this program, see README.md");
}
WorkReport truth_report(const Prepared&) { refuse(kNoTruth); }

}  // namespace dynrt::host
