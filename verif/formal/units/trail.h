// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit that takes a packet's restart trail and gives it as it is after one event.
#pragma once

#include "tiny.h"
#include "units/restart_trail.h"

namespace formal {

/// Paths of up to six forks, and stacks of two entries.
struct TinyRestarts : Tiny {
  static constexpr unsigned kStackDepth = 6;
};

enum class TrailEvent : unsigned char { kPush, kNear, kFar, kPop };

}  // namespace formal

template <>
inline constexpr unsigned hls::enum_width<formal::TrailEvent> = 2;
template <>
inline constexpr unsigned dynrt::kStackEntries<formal::TinyRestarts> = 2;

namespace formal {

struct TrailBefore {
  dynrt::RestartTrail<TinyRestarts> trail;
  TrailEvent event = TrailEvent::kPush;
  bool is_fork = false;
  HLS_FIELDS(trail, event, is_fork)
};
struct TrailAfter {
  dynrt::RestartTrail<TinyRestarts> trail;
  bool was_done = false;
  dynrt::WayBack way_back;  ///< as it was
  HLS_FIELDS(trail, was_done, way_back)
};

struct Trail {
  hls::In<TrailBefore> before;
  hls::Out<TrailAfter> after;
  HLS_PORTS(before, after)

  void step() {
    const TrailBefore b = before.read();
    dynrt::RestartTrail<TinyRestarts> trail = b.trail;
    switch (b.event) {
      case TrailEvent::kPush:
        trail.push();
        break;
      case TrailEvent::kNear:
        trail.descend(b.is_fork, false);
        break;
      case TrailEvent::kFar:
        trail.descend(b.is_fork, true);
        break;
      case TrailEvent::kPop:
        trail.pop();
        break;
    }
    after.write({trail, b.trail.is_done(), b.trail.way_back()});
  }
};

}  // namespace formal
