// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From LLVM's debug locations to lines of the unit's own source. Code that was inlined from the
// language's headers or the system's is placed where the unit called it, and file names are printed
// as an #include names them, so that no generated file names a folder of the machine.
#pragma once

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Instruction.h>

#include <map>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace hlsc {

class SourceLines {
 public:
  explicit SourceLines(const std::vector<std::string>& include_folders);

  /// The innermost line that is not a library's; none where there is no such line.
  SourceLine of(const llvm::DILocation* location) const;
  SourceLine of(const llvm::Instruction& instruction) const;
  SourceLine at(const llvm::DIFile* file, unsigned line) const;
  /// True for the language's and the system's headers, whose variables and lines are not shown.
  bool is_library(const llvm::DIFile* file) const;

 private:
  struct File {
    std::string name;
    bool library;
  };
  const File& file(const llvm::DIFile* file) const;

  std::vector<std::string> folders_;  ///< absolute, with a slash at the end
  mutable std::map<const llvm::DIFile*, File> files_;
};

}  // namespace hlsc
