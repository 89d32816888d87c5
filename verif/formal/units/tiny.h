// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The configuration thesis with numbers and tables small enough for a solver.
#pragma once

#include "configs/thesis.h"

namespace formal {

struct Tiny : dynrt::config::thesis {
  using Real = hls::Float<3, 3>;
  static constexpr unsigned kPackets = 2;
  static constexpr unsigned kLines = 2;
  static constexpr unsigned kStackDepth = 3;
  static constexpr unsigned kObjectSlots = 2;
  static constexpr unsigned kTriangleSlots = 2;
};

/// Of the mailbox, which compares numbers of matrices.
struct TinyMailbox : Tiny {
  static constexpr unsigned kMatrixBits = 4;
};

/// The same, of a mailbox that knows a packet's rays apart.
struct TinyMailboxOfRays : TinyMailbox {
  static constexpr dynrt::Datapath kDatapath = dynrt::Datapath::kFast;
};

/// Of the transformation: nine products and nine sums.
struct Tinier : Tiny {
  using Real = hls::Float<2, 2>;
};

}  // namespace formal
