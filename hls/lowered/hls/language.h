// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The language and the part of the standard library that units include. hlsc reads these headers
// precompiled (hlsc --precompile): parsing them takes longer than lowering most units.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "hls/fields.h"
#include "hls/float.h"
#include "hls/int.h"
#include "hls/reciprocal.h"
#include "ports.h"  // the lowered one, beside this file
