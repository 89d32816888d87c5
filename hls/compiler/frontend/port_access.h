// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The functions that stand for accesses to ports, and their effects: the language annotates them
// (hls/lowered/hls/ports.h).
#pragma once

#include <llvm/IR/Function.h>
#include <llvm/IR/Module.h>

#include <optional>

#include "hls/port_kind.h"

namespace hlsc {

struct PortAccessInfo {
  hls::PortAccess access;
  unsigned leaf_width;     ///< 0 if no leaf is moved
  unsigned address_width;  ///< 0 if there is no address
};

/// Makes every annotation an attribute of its function, which no pass drops, and removes the list
/// of annotations, which counts as a use of each function.
void keep_annotations(llvm::Module& module);

/// The effect of a call of the function on a port; nothing if it is no port access.
std::optional<PortAccessInfo> port_access(const llvm::Function& function);

}  // namespace hlsc
