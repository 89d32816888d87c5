// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt specialise: the smallest core that renders a scene, its Verilog, and its savings. `dynrt
// needs` finds the needs of the scene; a script measures, lowers and synthesizes.
#include "host/app/command.h"
#include "host/app/script_command.h"

namespace dynrt::host {

Command add_specialise_command(CLI::App& program) {
  const ScriptCommand command = add_script_command(
      program, "specialise",
      "make the smallest core that renders a scene, and show what this saves", "specialise");
  return {command.app, command.run};
}

}  // namespace dynrt::host
