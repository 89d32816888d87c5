// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Watches the units of a native core at work (units/frame_watch.h). It looks at the tokens that
// wait for a unit before each of its transactions and changes nothing.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "units/core.h"
#include "units/frame_watch.h"
#include "units/unit_activity.h"

namespace dynrt {

template <class C>
class CoreWatch {
 public:
  CoreWatch(hls::Join& join, Core<C>& core, FrameWatch& watch) : watch_(watch) {
    watch.columns = packet_columns(kRays<C>);
    watch.rows = packet_rows(kRays<C>);
    watch.packets.clear();
    watch.units.clear();
    watch.groups.clear();
    for (const hls::UnitRecord& unit : join.record().units) {
      watch.units.push_back(unit.name);
      watch.groups.push_back(unit.group);
    }
    watch.channels.clear();
    for (const hls::ChannelRecord& channel : join.record().channels) {
      watch.channels.push_back({channel.name, channel.from, channel.to});
    }
    activity_.emplace(join, watch);
    looks_.resize(watch.units.size());
    for (unsigned i = 0; i < kPipelines<C>; ++i) look_at(core.pipeline[i], i);
    join.watch([this](std::size_t unit, std::uint64_t clock) { see(unit, clock); });
  }

 private:
  using Look = std::function<void(std::uint64_t clock)>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  void see(std::size_t unit, std::uint64_t clock) {
    if (watch_.stop != nullptr && watch_.stop->load(std::memory_order_relaxed) > 0) {
      throw FrameStopped();
    }
    activity_->works(unit, clock);
    if (looks_[unit]) looks_[unit](clock);
  }

  /// The unit's name in a core of one pipeline.
  void look(unsigned pipeline, const std::string& name, Look act) {
    const std::string full = kHasPipelines<C> ? pipeline_prefix(pipeline) + name : name;
    for (std::size_t i = 0; i < watch_.units.size(); ++i) {
      if (watch_.units[i] == full) looks_[i] = std::move(act);
    }
  }

  template <class Id>
  PacketWork& traced(unsigned pipeline, Id packet) {
    return traced_[pipeline][packet.to_u64()];
  }

  void note(PacketWork& packet, PacketEvent event, bool top, std::uint64_t number,
            std::uint64_t clock) {
    if (!watch_.ways) return;
    packet.way.push_back({static_cast<std::uint32_t>(number),
                          static_cast<std::uint32_t>(clock - packet.begin), event, top});
  }

  void look_at(Pipeline<C>& p, unsigned i) {
    look(i, "node_lookup", [this, &p, i](std::uint64_t clock) {
      const auto& request = p.node_lookup.request.queue()->front();
      PacketWork& packet = traced(i, request.context.packet);
      ++packet.nodes;
      note(packet, PacketEvent::kNode, is_top<C>(request.context.level), request.address.to_u64(),
           clock);
    });
    look(i, "list", [this, &p, i](std::uint64_t clock) {
      const ListJob<C>& job = p.list.job.queue()->front();
      if (!job.first) return;
      PacketWork& packet = traced(i, job.packet);
      ++packet.lists;
      note(packet, PacketEvent::kList, is_top<C>(job.level), job.address.to_u64(), clock);
    });
    look(i, "mailbox", [this, &p, i](std::uint64_t clock) {
      const MailboxEntry<C>& entry = p.mailbox.entry.queue()->front();
      if (entry.clear) return;
      PacketWork& packet = traced(i, entry.packet);
      ++packet.entries;
      note(packet, PacketEvent::kEntry, is_top<C>(entry.level), entry.entry.matrix.to_u64(), clock);
    });
    look(i, "matrix_fetch", [this, &p, i](std::uint64_t clock) {
      const auto& job = p.matrix_fetch.job.queue()->front();
      if (job.index.to_u64() == 0) see_job(p, i, job.job, clock);
    });
    see_misses(i, "node_fill", p.node_fill);
    see_misses(i, "list_fill", p.list_fill);
    see_misses(i, "matrix_fill", p.matrix_fill);
    look(i, "shading", [this, &p, i](std::uint64_t clock) {
      const auto& job = p.shading.job.queue()->front();
      if (!job.last) return;
      PacketWork& packet = traced(i, job.job.packet);
      packet.end = clock;
      watch_.packets.push_back(std::move(packet));
    });
  }

  template <class Fill>
  void see_misses(unsigned i, const char* name, Fill& unit) {
    look(i, name, [this, &unit, i](std::uint64_t) {
      const auto& line = unit.fill.queue()->front();
      if (!line.invalidate) {
        ++traced(i, line.key.template trunc<PacketId<C>::kWidth>()).misses;
      }
    });
  }

  void see_job(Pipeline<C>& p, unsigned i, const TransformJob<C>& job, std::uint64_t clock) {
    PacketWork& packet = traced(i, job.packet);
    const std::uint64_t matrix = job.matrix.to_u64();
    if (job.kind == TransformKind::kCamera) {
      const PixelPosition at = p.shading.position.read(job.packet);
      packet = {.x = static_cast<std::uint32_t>(at.x.to_u64()),
                .y = static_cast<std::uint32_t>(at.y.to_u64()),
                .begin = clock};
      note(packet, PacketEvent::kRays, true, matrix, clock);
    } else if (job.kind == TransformKind::kObject) {
      ++packet.objects;
      note(packet, PacketEvent::kObject, true, matrix, clock);
    } else if (job.kind == TransformKind::kTriangle) {
      ++packet.triangles;
      note(packet, PacketEvent::kTriangle, false, matrix, clock);
    } else if (fetches_box<C>(job.kind, job.extras)) {
      note(packet, PacketEvent::kBox, true, matrix, clock);
    } else {
      note(packet, PacketEvent::kRays, true, matrix, clock);
    }
  }

  FrameWatch& watch_;
  std::optional<UnitActivity> activity_;
  std::vector<Look> looks_;  ///< by unit
  std::array<std::array<PacketWork, kPackets>, kPipelines<C>> traced_{};
};

}  // namespace dynrt
