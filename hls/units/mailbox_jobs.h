// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Jobs that every mailbox sends: of an item that it lets through, and of new rays.
#pragma once

#include "units/frame.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

/// The packet goes on in its list.
template <class C>
ListJob<C> next_entry(const MailboxEntry<C>& e) {
  ListJob<C> go_on;
  go_on.packet = e.packet;
  go_on.level = e.level;
  return go_on;
}

/// The item of an entry is met by some rays.
template <class C>
TransformJob<C> job_of_item(const MailboxEntry<C>& e, RayMask<C> rays) {
  TransformJob<C> job;
  job.packet = e.packet;
  job.kind = is_top<C>(e.level) ? TransformKind::kObject : TransformKind::kTriangle;
  job.active = rays;
  job.matrix = e.entry.matrix;
  job.extras.primitive = e.entry.primitive();
  if (kThreeColumns<C> && !is_top<C>(e.level) &&
      !is_primitive<C>(Primitive::kSphere, job.extras.primitive)) {
    job.repeat = kStoredColumns - 1;
  }
  return job;
}

/// New rays enter the tree.
template <class C>
TraversalEvent<C> enter_tree(const MailboxEntry<C>& e, const FrameRegisters<C>& frame) {
  TraversalEvent<C> enter;
  enter.packet = e.packet;
  enter.kind = TraversalKind::kEnter;
  enter.next = NodeAddress<C>::from(frame.start_node.raw());
  enter.active = e.active;
  enter.rays = e.kind;
  enter.distinct_origins = e.kind.get() == RayKind::kReflection;
  return enter;
}

}  // namespace dynrt
