// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Which functions stand for accesses to ports, and what each does: the language annotates them
// (hls/lowered/hls/ports.h).
#pragma once

#include <llvm/IR/Function.h>
#include <llvm/IR/Module.h>

#include <optional>

#include "hls/port_kind.h"

namespace hlsc {

struct PortAccessInfo {
  hls::PortAccess access;
  unsigned leaf_width;     ///< 0 where no leaf is moved
  unsigned address_width;  ///< 0 where there is no address
};

/// Makes every annotation an attribute of its function, which no pass drops, and removes the list
/// of annotations, which counts as a use of each function.
void keep_annotations(llvm::Module& module);

/// What a call of the function does on a port; nothing where it is no port access.
std::optional<PortAccessInfo> port_access(const llvm::Function& function);

}  // namespace hlsc
