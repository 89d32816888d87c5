// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Mailbox: lets every object and every triangle through once per packet and level (thesis 4.3.2,
// 6.1.2). Slots fill in order and are never replaced: a full mailbox lets everything new through.
// The objects of a packet are forgotten when a new ray starts, the triangles when an object is
// entered. A level without slots lets everything through: it has no memory, and an item that is
// listed twice is tested twice, with the same hits. New rays enter the tree, or go to the list
// that the start node is.
#pragma once

#include "units/frame.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct Mailbox {
  template <unsigned N>
  struct Slots {
    using Count = uint<hls::index_width(N + 1)>;
    Count used;
    std::array<MatrixNumber<C>, N> slot;
    /// By slot, the rays that have met the item.
    [[no_unique_address]] hls::OptionalField<kSendsActive<C>, std::array<RayMask<C>, N>> met{};
    HLS_FIELDS(used, slot, met)

    bool holds(MatrixNumber<C> matrix) const {
      bool found = false;
      for (unsigned i = 0; i < N; ++i) {
        found = found || (used > Count::from(i) && slot[i] == matrix);
      }
      return found;
    }
    void insert(MatrixNumber<C> matrix) {
      for (unsigned i = 0; i < N; ++i) {
        if (used == Count::from(i)) slot[i] = matrix;
      }
      if (used != Count::from(N)) used = hls::next(used);
    }
    /// Of the rays, those that have not met the item; if it is theirs, they have from now on.
    RayMask<C> meet(MatrixNumber<C> matrix, RayMask<C> rays, bool theirs) {
      RayMask<C> before;
      bool found = false;
      for (unsigned i = 0; i < N; ++i) {
        const bool here = used > Count::from(i) && slot[i] == matrix;
        const bool free = used == Count::from(i);
        found = found || here;
        if (here) before = before | met.value[i];
        if (theirs && (here || free)) met.value[i] = free ? rays : met.value[i] | rays;
      }
      if (theirs && !found) insert(matrix);
      return rays & ~before;
    }
  };
  static constexpr bool kHasObjects = kTwoLevels<C> && C::kObjectSlots > 0;
  static constexpr bool kHasTriangles = C::kTriangleSlots > 0;
  /// The packet's rays that are traced.
  struct Traced {
    RayMask<C> rays;
    hls::OptionalField<kHasMirrors<C>, bool> distinct_origins;
    HLS_FIELDS(rays, distinct_origins)
  };
  /// The rays that enter an object, or those that are traced while others wait.
  static constexpr bool kKeepsTraced =
      kSendsActive<C> ? kHasMirrors<C> : kTwoLevels<C> || kHasSecondary<C>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<MailboxEntry<C>> entry;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<TransformJob<C>> fresh;
  hls::OptionalPort<kHasObjects || kHasTriangles || kMainFirst<C>, hls::Out<ListJob<C>>> seen;
  hls::Out<TraversalEvent<C>> start;
  hls::RamWrite<bool, kLevelRows<C>> last;
  hls::OptionalPort<kHasObjects, hls::Ram1R1W<Slots<C::kObjectSlots>, kPackets>> objects;
  hls::OptionalPort<kHasTriangles, hls::Ram1R1W<Slots<C::kTriangleSlots>, kPackets>> triangles;
  hls::OptionalPort<kKeepsTraced, hls::Ram1R1W<Traced, kPackets>> traced;
  HLS_PORTS(entry, frame, fresh, seen, start, last)

  void step() {
    const MailboxEntry<C> e = entry.read();
    Slots<C::kObjectSlots> object_slots = slots_of<C::kObjectSlots>(objects, e.packet);
    Slots<C::kTriangleSlots> triangle_slots = slots_of<C::kTriangleSlots>(triangles, e.packet);
    const bool top = is_top<C>(e.level);
    RayMask<C> newly;  // where the mailbox knows the rays apart, those that have not met the item
    if constexpr (kSendsActive<C>) {
      const bool item = !e.clear;
      const RayMask<C> object = object_slots.meet(e.entry.matrix, e.active, item && top);
      const RayMask<C> triangle = triangle_slots.meet(e.entry.matrix, e.active, item && !top);
      newly = top ? object : triangle;
    }
    const bool known = kSendsActive<C> ? newly == RayMask<C>{}
                       : top           ? object_slots.holds(e.entry.matrix)
                                       : triangle_slots.holds(e.entry.matrix);

    Traced packet;
    if constexpr (kKeepsTraced) packet = traced.read(e.packet);

    if (e.clear) {
      if constexpr (kTwoLevels<C>) {
        object_slots.used = 0;
      } else {
        triangle_slots.used = 0;
      }
      if constexpr (kKeepsTraced) {
        traced.write(e.packet, Traced{e.active, e.kind.get() == RayKind::kReflection});
      }
      begin(e);
    } else {
      last.write(level_row<C>(e.level, e.packet), e.entry.last);
      if (known) {
        if constexpr (kHasObjects || kHasTriangles) {
          ListJob<C> go_on;
          go_on.packet = e.packet;
          go_on.level = e.level;
          seen.write(go_on);
        }
      } else {
        TransformJob<C> job;
        job.packet = e.packet;
        job.kind = !top                ? TransformKind::kTriangle
                   : kTestsWorldBox<C> ? TransformKind::kBox
                                       : TransformKind::kObject;
        // All traced rays enter an object, not only those in this leaf: one that comes to it in a
        // later leaf would find it in the mailbox, unless that knows the rays apart.
        job.active = kSendsActive<C> ? newly : packet.rays;
        job.extras.distinct_origins = packet.distinct_origins;
        job.matrix = e.entry.matrix;
        job.extras.primitive = e.entry.primitive();
        if (kThreeColumns<C> && !top &&
            !is_primitive<C>(Primitive::kSphere, job.extras.primitive)) {
          job.repeat = kStoredColumns - 1;
        }
        if (kTestsWorldBox<C> && top) job.repeat = 0;
        fresh.write(job);
        if (top) {
          if constexpr (!kSendsActive<C>) object_slots.insert(e.entry.matrix);
          triangle_slots.used = 0;
        } else {
          if constexpr (!kSendsActive<C>) triangle_slots.insert(e.entry.matrix);
        }
      }
    }
    if constexpr (kHasObjects) objects.write(e.packet, object_slots);
    if constexpr (kHasTriangles) triangles.write(e.packet, triangle_slots);
  }

 private:
  void begin(const MailboxEntry<C>& e) {
    TraversalEvent<C> enter;
    enter.packet = e.packet;
    enter.kind = TraversalKind::kEnter;
    enter.next = NodeAddress<C>::from(frame.get().start_node.raw());
    enter.active = e.active;
    enter.rays = e.kind;
    enter.distinct_origins = e.kind.get() == RayKind::kReflection;
    if constexpr (kMainFirst<C>) {
      ListJob<C> start_list;
      start_list.packet = e.packet;
      start_list.first = true;
      start_list.address = list_address<C>(enter.next);
      start_list.active = e.active;
      start_list.is_start = true;
      start_list.rays = e.kind.get();
      if (is_list<C>(enter.next)) {
        seen.write(start_list);
      } else {
        start.write(enter);
      }
    } else {
      start.write(enter);
    }
  }
  template <unsigned N, class Ram>
  static Slots<N> slots_of(const Ram& ram, PacketId<C> packet) {
    if constexpr (std::is_same_v<Ram, hls::Absent>) {
      return {};
    } else {
      return ram.read(packet);
    }
  }
};

}  // namespace dynrt
