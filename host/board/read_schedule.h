// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The schedules that hlsc writes beside the Verilog of a configuration's units (hlsc --schedule),
// by which the native model counts clocks.
#pragma once

#include <string>

#include "hls/module_schedule.h"

namespace dynrt::host {

/// Every schedule in a folder. Throws UserError where there is none or one cannot be read.
hls::ModuleSchedules read_schedule(const std::string& folder);

}  // namespace dynrt::host
