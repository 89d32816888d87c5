// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of the SDRAM controller. Its smallest piece is a pair of words of 16 bits, 4 bytes.
#pragma once

#include "hls/fields.h"
#include "hls/int.h"

namespace dynrt {

using hls::uint;

inline constexpr unsigned kSdramAddressBits = 25;  ///< of a byte: 32 MB
/// Requests that may wait in the controller's queues, all of them for one bank if they are;
/// whoever sends them counts `taken`.
inline constexpr unsigned kSdramQueue = 16;

/// A place in the chip. Rows of 1 KB go round the banks.
struct SdramPlace {
  uint<8> pair;  ///< of the row
  uint<2> bank;
  uint<13> row;
  HLS_FIELDS(pair, bank, row)
};

/// Pairs that follow each other within 32 bytes, read or written.
struct SdramBurst {
  SdramPlace place;  ///< of the first pair
  uint<3> last;      ///< pairs less one
  bool write = false;
  uint<5> tag;  ///< the sender's, and back with each word
  HLS_FIELDS(place, last, write, tag)
};

/// A clock of the controller: a burst comes, or none.
struct SdramRequest {
  bool valid = false;
  SdramBurst burst;
  HLS_FIELDS(valid, burst)
};

/// The pins ras_n, cas_n, we_n, lowest first.
enum class SdramCommand : unsigned char {
  kNone = 0b111,
  kActivate = 0b110,
  kRead = 0b101,
  kWrite = 0b001,
  kPrecharge = 0b010,
  kRefresh = 0b100,
  kMode = 0b000,
};

/// The pins in a clock, and what goes over the data pins for this command. A word that is read
/// comes a CAS latency later.
struct SdramPins {
  SdramCommand command = SdramCommand::kNone;
  uint<2> bank;
  uint<13> address;
  bool ready = false;  ///< the chip is set up
  bool reads = false;
  bool writes = false;
  uint<4> word;       ///< within 32 bytes
  bool last = false;  ///< of its burst
  uint<5> tag;
  uint<3> taken;  ///< requests that have left their queues
  HLS_FIELDS(command, bank, address, ready, reads, writes, word, last, tag, taken)
};

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::SdramCommand> = 3;
