// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The first step of the lowering: a unit's C++ becomes LLVM IR. A small source file that includes
// the unit's header, names its type and calls its step() goes through clang++-19 as a process; the
// folder hls/lowered stands first on the include path, so that ports are calls of undefined
// functions.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>
#include <vector>

namespace hlsc {

/// The unit to lower, and the flags with which clang finds it.
struct UnitSource {
  std::string unit;                     ///< C++ type, with namespace and template arguments
  std::string header;                   ///< as an #include names it
  std::vector<std::string> folders;     ///< include path, in order
  std::vector<std::string> clang_args;  ///< passed on, e.g. -DNAME=1
  std::string clang = "clang++-19";
  std::string precompiled;  ///< file of precompile(), with the same folders and arguments, or none
  std::string module;       ///< name of the Verilog module
  std::string print_after;  ///< print the IR after this one of ir_passes(), for work on hlsc itself
};

/// Names in the small source file: the initial unit and the call of its step().
inline constexpr char kInitialUnit[] = "hls_initial";
inline constexpr char kStepFunction[] = "hls_step";

struct CompiledUnit {
  std::unique_ptr<llvm::Module> module;
  std::vector<std::string> includes;  ///< every file that clang read, sorted, for a dependency file
};

/// Throws Error with clang's diagnostics if clang rejects the unit.
CompiledUnit compile_unit(const UnitSource& source, llvm::LLVMContext& context);

/// Writes what clang knows of source.header to a file, for units that include the same headers.
void precompile(const UnitSource& source, const std::string& file);

}  // namespace hlsc
