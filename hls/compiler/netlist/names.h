// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Printed names of the netlist's enumerations.
#pragma once

#include "netlist/netlist.h"

namespace hlsc {

const char* op_name(Op op);
const char* kind_name(PortKind kind);

}  // namespace hlsc
