// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Names of C++ variables, carried by LLVM values as their own names, because those survive every
// pass and debug records do not survive if-conversion.
#pragma once

#include <llvm/IR/Function.h>

#include <string>

#include "frontend/source_lines.h"

namespace hlsc {

/// Marks names that come from variables; they end with "$", after which LLVM puts numbers of its
/// own to keep them apart.
inline constexpr char kNamePrefix[] = "hls$";

/// Gives every value the name of the first variable of the unit's own source that held it, and
/// removes the debug records. A struct's part is named variable_field.
void name_values(llvm::Function& function, const SourceLines& lines);

/// The variable's name, or nothing.
std::string value_name(const llvm::Value& value);

}  // namespace hlsc
