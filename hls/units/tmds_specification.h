// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// TMDS as its specification has it (Digital Visual Interface 1.0, 3.2.2 and 3.3.2): what the unit
// tmds_encoder is held against, and what a monitor at the pins of a link decodes by. Bit i of a
// character is q_out[i] there; bit 0 is sent first.
#pragma once

#include <array>
#include <bit>
#include <optional>

namespace dynrt::tmds {

/// The characters of the blanking, by the control signals {C1, C0}.
inline constexpr std::array<unsigned, 4> kControl = {0b1101010100, 0b0010101011, 0b0101010100,
                                                     0b1010101011};

/// The control signals of a character; none where it is a pixel's.
inline std::optional<unsigned> control_of(unsigned character) {
  for (unsigned c = 0; c < kControl.size(); ++c) {
    if (kControl[c] == character) return c;
  }
  return std::nullopt;
}

/// A channel of pixels: figure 3-5, in its names.
struct Channel {
  int cnt = 0;  ///< disparity; 0 in the blanking

  unsigned encode(unsigned d) {
    const int n1_of_d = std::popcount(d);
    std::array<int, 9> q_m{};
    const bool xnor = n1_of_d > 4 || (n1_of_d == 4 && (d & 1) == 0);
    q_m[0] = static_cast<int>(d & 1);
    for (unsigned i = 1; i < 8; ++i) {
      const int differs = q_m[i - 1] ^ static_cast<int>(d >> i & 1);
      q_m[i] = xnor ? 1 - differs : differs;
    }
    q_m[8] = xnor ? 0 : 1;
    int n1 = 0;
    for (unsigned i = 0; i < 8; ++i) n1 += q_m[i];
    const int n0 = 8 - n1;

    std::array<int, 10> q_out{};
    q_out[8] = q_m[8];
    if (cnt == 0 || n1 == n0) {
      q_out[9] = 1 - q_m[8];
      cnt += q_m[8] == 0 ? n0 - n1 : n1 - n0;
    } else if ((cnt > 0 && n1 > n0) || (cnt < 0 && n0 > n1)) {
      q_out[9] = 1;
      cnt += 2 * q_m[8] + (n0 - n1);
    } else {
      q_out[9] = 0;
      cnt += -2 * (1 - q_m[8]) + (n1 - n0);
    }
    unsigned character = 0;
    for (unsigned i = 0; i < 8; ++i) q_out[i] = q_out[9] != 0 ? 1 - q_m[i] : q_m[i];
    for (unsigned i = 0; i < 10; ++i) character |= static_cast<unsigned>(q_out[i]) << i;
    return character;
  }
};

/// The byte of a pixel's character: figure 3-6.
inline unsigned decode(unsigned character) {
  const unsigned d = (character >> 9 & 1) != 0 ? ~character & 0xff : character & 0xff;
  unsigned q = d & 1;
  for (unsigned i = 1; i < 8; ++i) {
    const unsigned differs = (d >> i ^ d >> (i - 1)) & 1;
    q |= ((character >> 8 & 1) != 0 ? differs : 1 - differs) << i;
  }
  return q;
}

}  // namespace dynrt::tmds
