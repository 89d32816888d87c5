// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What somebody who watches the native model render a frame has seen of it: the work, the clocks
// and the way of each packet, the work of each unit in the course of the frame. The same in every
// configuration; units/core_watch.h makes it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace dynrt {

/// Thrown out of a frame that is no longer wanted.
struct FrameStopped : std::exception {
  const char* what() const noexcept override { return "the frame is no longer wanted"; }
};

/// What a packet comes to on its way.
enum class PacketEvent : std::uint8_t { kRays, kNode, kList, kEntry, kBox, kObject, kTriangle };
struct PacketStep {
  std::uint32_t number = 0;  ///< address of the node or list, number of the matrix
  std::uint32_t clock = 0;   ///< since the packet's begin
  PacketEvent event = PacketEvent::kNode;
  bool top = false;  ///< in the tree of the instances
};

/// From the camera's job of a packet until its pixels are written.
struct PacketWork {
  std::uint32_t x = 0, y = 0;          ///< of its first pixel
  std::uint64_t begin = 0, end = 0;    ///< clocks
  std::uint32_t nodes = 0, lists = 0;  ///< fetched
  std::uint32_t entries = 0;           ///< of lists, that came to the mailbox
  std::uint32_t objects = 0, triangles = 0;
  std::uint32_t misses = 0;  ///< of all caches
  std::vector<PacketStep> way{};
};

/// A channel between units, by their ports: "unit.port".
struct WatchedChannel {
  std::string name;
  std::vector<std::string> from, to;
};

/// A FIFO on the way of a channel's tokens, in a frame with clocks.
struct WatchedFifo {
  std::string channel;
  std::string port;    ///< its writer's or, behind a fork, its reader's; empty: behind an arbiter
  unsigned depth = 0;  ///< 0: it is outside of the core
  std::uint64_t tokens = 0;
  std::uint64_t clocks = 0;  ///< in which they were in it, all tokens together
  std::size_t most = 0;      ///< tokens in it in one clock
};

/// A unit's clocks without a transaction, by what it waits for.
struct WatchedWait {
  std::size_t unit = 0, fifo = 0;       ///< places in the lists of these
  bool for_room = false;                ///< in the FIFO; else for a token
  std::vector<std::uint32_t> clocks{};  ///< by part
};

struct FrameWatch {
  // What is wanted.
  bool ways = false;   ///< of all packets
  unsigned parts = 0;  ///< of the frame, at most, for which units' work is counted; even, or 0
  const std::atomic<unsigned>* stop = nullptr;  ///< throws FrameStopped once it is not 0

  // What was seen.
  unsigned columns = 0, rows = 0;              ///< pixels of a packet
  std::vector<PacketWork> packets{};           ///< in the order of their ends
  std::vector<std::string> units{}, groups{};  ///< each unit's name and that of its group
  std::vector<WatchedChannel> channels{};
  std::uint64_t part_clocks = 1;                   ///< of a part
  std::vector<std::vector<std::uint32_t>> work{};  ///< transactions, by unit and part
  std::vector<WatchedFifo> fifos{};                ///< if there are clocks and parts are wanted
  std::vector<WatchedWait> waits{};
};

}  // namespace dynrt
