// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The exception of hlsc for a unit that cannot be lowered: one sentence with the mistake and its
// remedy, at a line of the unit's source. The program prints it and exits with 1.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "netlist/netlist.h"

namespace hlsc {

class Error : public std::runtime_error {
 public:
  Error(SourceLine where, const std::string& message)
      : std::runtime_error(message), where_(std::move(where)) {}

  const SourceLine& where() const { return where_; }

  /// "units/mailbox.h:42: error: ..."; without the place if it is not known.
  std::string text() const {
    if (where_.file.empty()) return std::string("hlsc: error: ") + what();
    if (where_.line == 0) return where_.file + ": error: " + what();
    return where_.file + ":" + std::to_string(where_.line) + ": error: " + what();
  }

 private:
  SourceLine where_;
};

}  // namespace hlsc
