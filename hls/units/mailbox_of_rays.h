// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Mailbox of rays: a mailbox (units/mailbox.h) that knows the rays of a packet apart. It lets an
// item through to the rays that have not met it, and remembers for each slot which have. Both
// levels share the comparators and the memory. New rays enter the tree, or go to the list that the
// start node is.
#pragma once

#include <algorithm>

#include "units/mailbox_jobs.h"

namespace dynrt {

template <class C>
struct MailboxOfRays {
  static constexpr unsigned kObjects = kTwoLevels<C> ? C::kObjectSlots : 0;
  static constexpr unsigned kTriangles = C::kTriangleSlots;
  static constexpr unsigned kSlots = std::max(kObjects, kTriangles);
  static constexpr bool kRemembers = kSlots > 0;
  static constexpr bool kAnswersLists = kRemembers || kMainFirst<C>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr double kUncertaintyNs = kLongWiresNs<C>;
  using Count = uint<hls::index_width(kSlots + 1)>;

  /// What a packet has met in a level.
  struct Items {
    std::array<MatrixNumber<C>, kSlots> matrix;
    std::array<RayMask<C>, kSlots> met;  ///< by which rays
    HLS_FIELDS(matrix, met)
  };
  /// The slots that a packet uses.
  struct Used {
    hls::OptionalField<kTwoLevels<C>, Count> objects{};
    Count triangles;
    HLS_FIELDS(objects, triangles)
  };

  hls::In<MailboxEntry<C>> entry;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<TransformJob<C>> fresh;
  hls::OptionalPort<kAnswersLists, hls::Out<ListJob<C>>> seen;
  hls::Out<TraversalEvent<C>> start;
  hls::RamWrite<bool, kLevelRows<C>> last;
  hls::OptionalPort<kRemembers, hls::Ram1R1W<Items, kLevelRows<C>>> items;
  hls::OptionalPort<kRemembers, hls::Ram1R1W<Used, kPackets>> used;
  hls::OptionalPort<kHasMirrors<C>, hls::Ram1R1W<bool, kPackets>> distinct_origins;
  hls::OptionalPort<kTestsBoxOfLight<C>, hls::Ram1R1W<Viewpoint<C>, kPackets>> viewpoint;
  HLS_PORTS(entry, frame, fresh, seen, start, last)

  void step() {
    const MailboxEntry<C> e = entry.read();
    RayMask<C> rays = e.active;
    if constexpr (kRemembers) rays = rays & ~met_before(e);

    if (e.clear) {
      if constexpr (kHasMirrors<C>) {
        distinct_origins.write(e.packet, e.kind.get() == RayKind::kReflection);
      }
      if constexpr (kTestsBoxOfLight<C>) viewpoint.write(e.packet, e.viewpoint.get());
      begin(e);
    } else {
      last.write(level_row<C>(e.level, e.packet), e.entry.last);
      if (kRemembers && rays == RayMask<C>{}) {
        if constexpr (kRemembers) seen.write(next_entry<C>(e));
      } else {
        fresh.write(job(e, rays));
      }
    }
  }

 private:
  /// The rays that have met the entry's item. Those that come with it have from now on.
  RayMask<C> met_before(const MailboxEntry<C>& e) {
    const bool top = is_top<C>(e.level);
    Items known = items.read(level_row<C>(e.level, e.packet));
    const Used counts = used.read(e.packet);
    const Count count = top ? counts.objects.get() : counts.triangles;
    const Count limit = top ? Count::from(kObjects) : Count::from(kTriangles);

    RayMask<C> before;
    bool found = false;
    for (unsigned i = 0; i < kSlots; ++i) {
      const bool here = count > Count::from(i) && known.matrix[i] == e.entry.matrix;
      const bool next = count == Count::from(i) && count != limit;
      found = found || here;
      if (here) before = before | known.met[i];
      if (next) known.matrix[i] = e.entry.matrix;
      if (here || next) known.met[i] = next ? e.active : known.met[i] | e.active;
    }
    if (!e.clear) items.write(level_row<C>(e.level, e.packet), known);

    const Count after = !found && count != limit ? hls::next(count) : count;
    used.write(e.packet, e.clear                ? Used{}
                         : kTwoLevels<C> && top ? Used{after, 0}  // an object has its triangles
                                                : Used{counts.objects, after});
    return before;
  }
  TransformJob<C> job(const MailboxEntry<C>& e, RayMask<C> rays) {
    TransformJob<C> job = job_of_item<C>(e, rays);
    if constexpr (kHasMirrors<C>) job.extras.distinct_origins = distinct_origins.read(e.packet);
    if (kTestsWorldBox<C> && is_top<C>(e.level)) {
      job.kind = TransformKind::kBox;
      job.repeat = 0;
      if constexpr (kTestsBoxOfLight<C>) {
        job.extras.derived = DerivedRay<C>{kBoxPass, {}};
        job.extras.viewpoint = viewpoint.read(e.packet);
      }
    }
    return job;
  }
  void begin(const MailboxEntry<C>& e) {
    const TraversalEvent<C> enter = enter_tree<C>(e, frame.get());
    if constexpr (kMainFirst<C>) {
      if (is_list<C>(enter.next)) {
        ListJob<C> start_list;
        start_list.packet = e.packet;
        start_list.first = true;
        start_list.address = list_address<C>(enter.next);
        start_list.active = e.active;
        start_list.is_start = true;
        start_list.rays = e.kind.get();
        seen.write(start_list);
        return;
      }
    }
    start.write(enter);
  }
};

}  // namespace dynrt
