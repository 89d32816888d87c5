// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What somebody who watches a join with clocks sees of its FIFOs: how long tokens stay in them, and
// which of them a unit waits for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace hls {

/// A queue on the way of a channel's tokens.
struct FifoRecord {
  std::string channel;
  /// The writer that it belongs to or, behind a fork, the reader; empty: what stands between an
  /// arbiter and its reader.
  std::string port;
  unsigned depth = 0;  ///< tokens that it holds; 0: it is outside
};

/// What a FIFO lacks for a unit's transaction.
enum class Lack : std::uint8_t { kToken, kRoom };

class ClockWatch {
 public:
  virtual ~ClockWatch() = default;
  /// A unit made no transaction from clock `from` on and before clock `to`.
  virtual void waited(std::size_t unit, std::size_t fifo, Lack lack, std::uint64_t from,
                      std::uint64_t to) = 0;
  /// A token was in a FIFO in the clocks from `from` to `to`, both included. Tokens are told in
  /// their order.
  virtual void passed(std::size_t fifo, std::uint64_t from, std::uint64_t to) = 0;
};

}  // namespace hls
