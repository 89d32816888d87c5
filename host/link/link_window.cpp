// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/link_window.h"

namespace dynrt::host {

std::optional<std::size_t> LinkWindow::next() {
  std::size_t i = 0;
  while (i < entries_.size() && (entries_[i].done || !entries_[i].waits)) ++i;
  if (i == entries_.size()) {
    if (i == most_ || base_ + i == requests_) return std::nullopt;
    entries_.emplace_back();
  }
  Entry& entry = entries_[i];
  if (entry.sent != 0) ++repeats_;
  entry.sent = ++sent_;
  entry.waits = false;
  return base_ + i;
}

std::optional<std::size_t> LinkWindow::under_way(std::uint8_t number) const {
  const std::size_t i = distance(number);
  if (i >= entries_.size() || entries_[i].done || entries_[i].sent == 0) return std::nullopt;
  return base_ + i;
}

void LinkWindow::answer(std::size_t request) {
  const std::size_t i = request - base_;
  const std::uint64_t sent = entries_[i].sent;
  entries_[i].done = true;
  for (std::size_t j = 0; j < i; ++j) {
    Entry& earlier = entries_[j];
    if (only_once_) {
      earlier.done = true;
    } else if (!earlier.done && earlier.sent < sent) {
      earlier.waits = true;
    }
  }
  if (request >= went_back_to_) echoes_ = 0;
  advance();
}

void LinkWindow::missing(std::uint8_t number) {
  const std::size_t first = distance(number);
  if (first > entries_.size()) return;  // of an earlier exchange
  const std::size_t request = base_ + first;
  if (echoes_ > 0 && request == went_back_to_) {
    --echoes_;
    return;
  }
  // Those before it were carried out, and answered.
  for (std::size_t i = 0; i < first; ++i) {
    if (only_once_) {
      entries_[i].done = true;
    } else if (!entries_[i].done) {
      entries_[i].waits = true;
    }
  }
  std::size_t under_way = 0;
  for (std::size_t i = first; i < entries_.size(); ++i) {
    if (entries_[i].done || entries_[i].waits) continue;
    entries_[i].waits = true;
    ++under_way;
  }
  went_back_to_ = request;
  echoes_ = under_way > 0 ? under_way - 1 : 0;
  advance();
}

void LinkWindow::repeat_all() {
  for (Entry& entry : entries_) entry.waits = true;
  echoes_ = 0;
}

void LinkWindow::advance() {
  while (!entries_.empty() && entries_.front().done) {
    entries_.pop_front();
    ++base_;
  }
}

}  // namespace dynrt::host
