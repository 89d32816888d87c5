// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tiny.h"
#include "units/packet_decision.h"
