// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Keeps track of the requests in flight and of those to repeat. Line and board keep the order of
// all packets that are not lost. So an answer shows that every earlier request without an answer
// has lost it; and a board that misses a request takes no later one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace dynrt::host {

class LinkWindow {
 public:
  /// A write needs no answer of its own (`only_once`) if a later request was carried out.
  LinkWindow(std::size_t requests, std::size_t most_under_way, bool only_once)
      : requests_(requests), most_(most_under_way), only_once_(only_once) {}

  bool done() const { return base_ == requests_; }
  std::size_t answered() const { return base_; }
  std::uint64_t repeats() const { return repeats_; }

  /// The request to send now, if there is one. It counts as sent.
  std::optional<std::size_t> next();
  /// The request with this number on the line, counted from 0 and modulo 256, if it is in flight
  /// and not answered.
  std::optional<std::size_t> under_way(std::uint8_t number) const;

  /// Such a request is answered.
  void answer(std::size_t request);
  /// The board misses the request with this number on the line.
  void missing(std::uint8_t number);
  /// Nothing has come for a long time.
  void repeat_all();

 private:
  struct Entry {
    std::uint64_t sent = 0;  ///< counts the link packets on the line
    bool waits = true;       ///< to be sent
    bool done = false;
  };
  std::size_t distance(std::uint8_t number) const {
    return static_cast<std::uint8_t>(number - static_cast<std::uint8_t>(base_));
  }
  void advance();

  const std::size_t requests_;
  const std::size_t most_;
  const bool only_once_;
  std::size_t base_ = 0;       ///< the first that is not answered
  std::deque<Entry> entries_;  ///< from there on
  std::uint64_t sent_ = 0;
  std::uint64_t repeats_ = 0;
  std::size_t went_back_to_ = 0;
  std::size_t echoes_ =
      0;  ///< frames under way when it went back, each of which is missed likewise
};

}  // namespace dynrt::host
