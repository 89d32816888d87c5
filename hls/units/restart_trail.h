// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Restart trail: the way back of a packet whose stack keeps only its latest entries (Laine,
// "Restart Trail for Stackless BVH Traversal", HPG 2010). A fork is a node with two children. Of
// each fork above its node a packet remembers one bit: whether the far child still waits. If the
// stack has lost the entry that is due, the packet starts again at the root, passes the same forks,
// goes to the far child of the last that waits, and on from there.
//
// At a fork that waits, the way back is in the near child; at another it is in the only child that
// the packet entered, or in the far one. Hits have become nearer since and rays have ended, so a
// child may be left out now, but none comes in: the rays have one origin, which alone decides the
// order of the children, and their intervals are made of the same planes as before.
//   - Where the far child is left out, it need not wait any more.
//   - Where the near child of a fork that waits is left out, no ray has anything left in it. The
//     packet goes to the far child, which is new, and the way back ends. The bits of deeper forks
//     are stale then; each is written again before it counts.
//   - Where the near child alone is entered and the way may be in the far one, that near child has
//     been traversed, and to do some of it again costs time and no hit.
// Read from the root, a fork that waits as 0 and another as 1, the bits are a number that grows
// with every fork that is left, so the traversal ends (verif/formal/properties/trail.v).
#pragma once

#include "units/packet.h"

namespace dynrt {

/// What the decision at a node must know of the way back.
struct WayBack {
  bool in_far = false;     ///< of two children that are entered, it is in the far one
  bool near_done = false;  ///< the near one is not entered: the way ends here
  HLS_FIELDS(in_far, near_done)
};

template <class C>
struct RestartTrail {
  /// A bit for each fork of the longest path, the root's highest.
  using Forks = uint<C::kStackDepth>;
  using Count = uint<hls::index_width(kStackEntries<C> + 1)>;

  Forks waiting;             ///< forks whose near child is being traversed
  Forks passed;              ///< the highest bits: forks above the packet's node
  bool on_way_back = false;  ///< the last fork that waits has not been found again
  Count kept;                ///< entries that the stack still has
  HLS_FIELDS(waiting, passed, on_way_back, kept)

  bool is_too_deep() const { return passed.template bit<0>(); }
  bool is_done() const { return due() == Forks{}; }
  /// Whether the stack has lost the entry that is due.
  bool is_lost() const { return kept == Count{}; }

  WayBack way_back() const {
    const bool waits = (waiting & here()) != Forks{};
    const bool is_last = (waiting & ~passed_next()) == Forks{};
    return {on_way_back && !waits, on_way_back && waits && is_last};
  }
  /// Into the near child, while the far one goes to the stack.
  void push() {
    waiting = waiting | here();
    passed = passed_next();
    if (kept != Count::from(kStackEntries<C>)) kept = hls::next(kept);
  }
  /// Into one child of a node, which is a fork or not.
  void descend(bool is_fork, bool is_far) {
    if (is_fork) {
      if (is_far && (waiting & here()) != Forks{}) on_way_back = false;
      waiting = waiting & ~here();
      passed = passed_next();
    }
  }
  /// Out of a leaf or a node that no ray goes on from: into the far child that is due, or to the
  /// root.
  void pop() {
    const Forks before = due();
    const auto less = Forks::from(before.raw() - 1);
    const Forks up_to_last = before ^ less;
    on_way_back = is_lost();
    waiting = is_lost() ? before : before & less;
    passed = is_lost() ? Forks{} : ~up_to_last.template shr<1>();
    if (!is_lost()) kept = Count::from(kept.raw() - 1);
  }

 private:
  static Forks highest() { return Forks::from(1ull << (Forks::kWidth - 1)); }
  Forks passed_next() const { return passed.template shr<1>() | highest(); }
  /// The fork that the packet is at or comes to next; none where the path is too deep.
  Forks here() const { return passed_next() & ~passed; }
  Forks due() const { return waiting & passed; }
};

}  // namespace dynrt
