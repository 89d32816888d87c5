// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A line of bytes to a board and back: a serial device, or a simulated one whose time is its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace dynrt::host {

class ByteStream {
 public:
  using Time = std::chrono::nanoseconds;  ///< since any beginning

  virtual ~ByteStream() = default;
  /// As messages name it.
  const std::string& name() const { return name_; }

  /// Both move as many bytes as they can at once, and give their number.
  virtual std::size_t write(std::span<const std::uint8_t> bytes) = 0;
  virtual std::size_t read(std::span<std::uint8_t> bytes) = 0;
  /// Waits until bytes can be read, or until some can be written if there are any, at most until
  /// `deadline`. Throws UserError if the device was disconnected.
  virtual void wait(bool to_write, Time deadline) = 0;
  virtual Time now() const = 0;

 protected:
  explicit ByteStream(std::string name) : name_(std::move(name)) {}

 private:
  std::string name_;
};

}  // namespace dynrt::host
