// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The interface to watch the FIFOs of a join with clocks: the time of tokens in them, and the waits
// of units for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace hls {

/// A queue on the way of a channel's tokens.
struct FifoRecord {
  std::string channel;
  /// The writer that it belongs to or, behind a fork, the reader; empty for a FIFO between an
  /// arbiter and its reader.
  std::string port;
  unsigned depth = 0;  ///< tokens that it holds; 0: it is outside
};

/// The reason why a unit waits for a FIFO: it has no token, or no space.
enum class Lack : std::uint8_t { kToken, kRoom };

class ClockWatch {
 public:
  virtual ~ClockWatch() = default;
  /// A unit made no transaction from clock `from` on and before clock `to`.
  virtual void waited(std::size_t unit, std::size_t fifo, Lack lack, std::uint64_t from,
                      std::uint64_t to) = 0;
  /// A token was in a FIFO in the clocks from `from` to `to`, both included. Tokens are reported in
  /// order.
  virtual void passed(std::size_t fifo, std::uint64_t from, std::uint64_t to) = 0;
};

}  // namespace hls
