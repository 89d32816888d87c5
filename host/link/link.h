// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's end of the line to a board (docs/explanation/link.md). Requests have numbers, and
// several are in flight at once. If the board misses a link packet, the host repeats the requests
// from that one on, as the board takes them only in order. If the host misses an answer, it repeats
// that request alone. Each call returns when everything is answered, and throws UserError, in
// bounded time, when the board stops answering.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/link/byte_stream.h"
#include "host/link/link_frame.h"
#include "host/link/link_window.h"

namespace dynrt::host {

/// A board's description of itself.
struct LinkIdentification {
  std::string configuration;
  unsigned version = 0;  ///< of the link
  unsigned beat_bytes = 0;
  std::uint32_t clock_hz = 0;
  std::uint32_t memory_bytes = 0;
  std::uint32_t divisor = 0;
  unsigned pixel_mhz = 0;  ///< of the display; 0: there is none
};

struct LinkPatience {
  std::chrono::milliseconds quiet{250};  ///< without progress, after which requests are repeated
  unsigned repeats = 8;                  ///< in a row without progress
};

struct LinkCounts {
  std::uint64_t requests = 0;     ///< answered
  std::uint64_t repeats = 0;      ///< link packets that were sent again
  std::uint64_t missed = 0;       ///< answers of the board that a link packet is missing
  std::uint64_t bad_answers = 0;  ///< damaged link packets of the board
  std::uint64_t timeouts = 0;
  std::uint64_t sent = 0;      ///< bytes on the line
  std::uint64_t received = 0;  ///< likewise
  std::uint64_t busy = 0;      ///< of each exchange, the bytes of the direction with more of them
  std::uint64_t carried = 0;   ///< bytes of memory and registers, in both directions
  friend bool operator==(const LinkCounts&, const LinkCounts&) = default;
};

/// Called with the bytes that have been moved.
using LinkProgress = std::function<void(std::uint64_t bytes)>;

class BoardLink {
 public:
  /// Identifies the board. Throws UserError if nothing answers, or something else than dynrt.
  explicit BoardLink(std::unique_ptr<ByteStream> line, LinkPatience patience = {});

  const LinkIdentification& board() const { return board_; }
  /// Throws UserError if the board has another configuration.
  void expect_configuration(std::string_view name) const;

  /// Addresses and lengths of writes are even. Parts must not overlap.
  void write_memory(std::span<const MemoryBytes> parts, const LinkProgress& progress = {});
  void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes);
  void read_memory(std::uint32_t address, std::span<std::uint8_t> bytes,
                   const LinkProgress& progress = {});
  /// Consecutive registers, by the address of a byte.
  void write_registers(std::uint32_t address, std::span<const std::uint32_t> words);
  void read_registers(std::uint32_t address, std::span<std::uint32_t> words);
  /// Writes one register and reads another in one turn of the line.
  std::uint32_t write_then_read(std::uint32_t to, std::uint32_t value, std::uint32_t from);

  const LinkCounts& counts() const { return counts_; }

 private:
  /// Requests that are sent together; the board answers each with data of a known length.
  struct Requests {
    std::vector<LinkRequestFrame> frames = {};
    std::size_t most_under_way = 1;
    bool writes = false;
    std::function<void(std::size_t request, std::span<const std::uint8_t> data)> take = {};
    LinkProgress progress = {};
  };

  void identify();
  void exchange(Requests& requests);
  void take(Requests& requests, LinkWindow& window, const LinkAnswerFrame& answer);
  /// The answers that come until the deadline, or until something was written, if there is any.
  std::vector<LinkAnswerFrame> receive(bool to_write, ByteStream::Time deadline);
  void send(std::vector<std::uint8_t>& bytes);
  [[noreturn]] void give_up(std::size_t answered, std::size_t requests) const;
  void check_range(std::uint32_t address, std::size_t bytes) const;
  const std::string& name() const { return line_->name(); }

  std::unique_ptr<ByteStream> line_;
  const LinkPatience patience_;
  AnswerReader reader_;
  LinkIdentification board_;
  LinkCounts counts_;
  std::uint8_t sequence_ = 0;  ///< of the next request
};

}  // namespace dynrt::host
