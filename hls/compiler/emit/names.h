// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Names of signals: the C++ variable's where there is one, else the operation's with a number.
// Stage suffixes and port suffixes keep them apart from ports and keywords.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "schedule/circuit.h"

namespace hlsc {

/// A stem for each cell that has a value; all differ.
std::vector<std::string> signal_stems(const Circuit& circuit);

}  // namespace hlsc
