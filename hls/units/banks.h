// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The words of the board's six memory banks, for the native core.
#pragma once

#include <array>

#include "hls/ports.h"
#include "units/memory_format.h"

namespace dynrt {

/// Those of the scene, and those that the core writes.
template <class C>
struct Banks {
  template <class W>
  using Bank = hls::Rows<W>;
  std::array<Bank<SceneWord<typename C::Real>>, kSceneBanks> scene;
  std::array<Bank<Word>, kBanks - kFrameBank> out;

  /// A half of a word that the core writes, by its byte in a memory behind the port.
  void write_half(unsigned byte, uint<16> half) {
    const BankWord at = bank_word(byte);
    Word& word = out.at(at.bank - kFrameBank)[at.word];
    word = byte % 4 != 0 ? hls::concat(half, word.template trunc<16>())
                         : hls::concat(word.template bits<31, 16>(), half);
  }
};

}  // namespace dynrt
