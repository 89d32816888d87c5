// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Mailbox: lets every object and every triangle through once per packet and level (thesis 4.3.2,
// 6.1.2). Slots fill in order and are never replaced: a full mailbox lets everything new through.
// The objects of a packet are forgotten when a new ray starts, the triangles when an object is
// entered. A level without slots lets everything through: it has no memory, and an item that is
// listed twice is tested twice, with the same hits.
#pragma once

#include "units/mailbox_jobs.h"

namespace dynrt {

template <class C>
struct Mailbox {
  template <unsigned N>
  struct Slots {
    using Count = uint<hls::index_width(N + 1)>;
    Count used;
    std::array<MatrixNumber<C>, N> slot;
    HLS_FIELDS(used, slot)

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
  };
  static constexpr bool kHasObjects = kTwoLevels<C> && C::kObjectSlots > 0;
  static constexpr bool kHasTriangles = C::kTriangleSlots > 0;
  static constexpr bool kAnswersLists = kHasObjects || kHasTriangles;
  /// The packet's rays that are traced.
  struct Traced {
    RayMask<C> rays;
    hls::OptionalField<kHasMirrors<C>, bool> distinct_origins;
    HLS_FIELDS(rays, distinct_origins)
  };
  /// The rays that enter an object, or those that are traced while others wait.
  static constexpr bool kKeepsTraced = kTwoLevels<C> || kHasSecondary<C>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<MailboxEntry<C>> entry;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<TransformJob<C>> fresh;
  hls::OptionalPort<kAnswersLists, hls::Out<ListJob<C>>> seen;
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
    const bool known =
        top ? object_slots.holds(e.entry.matrix) : triangle_slots.holds(e.entry.matrix);
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
      start.write(enter_tree<C>(e, frame.get()));
    } else {
      last.write(level_row<C>(e.level, e.packet), e.entry.last);
      if (known) {
        if constexpr (kAnswersLists) seen.write(next_entry<C>(e));
      } else {
        // All traced rays enter an object, not only those in this leaf: one that comes to it in a
        // later leaf would find it in the mailbox.
        TransformJob<C> job = job_of_item<C>(e, packet.rays);
        job.extras.distinct_origins = packet.distinct_origins;
        fresh.write(job);
        if (top) {
          object_slots.insert(e.entry.matrix);
          triangle_slots.used = 0;
        } else {
          triangle_slots.insert(e.entry.matrix);
        }
      }
    }
    if constexpr (kHasObjects) objects.write(e.packet, object_slots);
    if constexpr (kHasTriangles) triangles.write(e.packet, triangle_slots);
  }

 private:
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
