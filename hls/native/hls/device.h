// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What stands outside a join and answers its requests in its own time, as a memory does.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hls {

class Device {
 public:
  virtual ~Device() = default;
  /// Takes the request at the head of their queue, in this clock.
  virtual void take(std::uint64_t now) = 0;
  /// Takes the write at the head of theirs, in this clock; before a request that comes in it.
  virtual void take_write(std::uint64_t /*now*/) {}
  /// Puts those answers into their queue that begin in the next clock; gives their number. The
  /// first can be taken in the next clock, the others in those after it.
  virtual std::size_t answer(std::uint64_t now) = 0;
  /// The clock in which it has the next answers; kNever: when a request has come.
  virtual std::uint64_t next() const = 0;
};

}  // namespace hls
