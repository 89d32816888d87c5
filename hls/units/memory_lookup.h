// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The asking half of the memory port: a miss of a cache becomes a read, and what it is for is kept
// until the answer comes (MemoryFill). Where there is a second level of cache, it is looked up
// first. A request whose line is on its way to another one's comes again until it has arrived, so
// that no line is read twice; the others go on meanwhile. A line that does not arrive, as another
// took its place, is read after kMostTries.
#pragma once

#include "units/memory_port.h"
#include "units/repeated.h"

namespace dynrt {

template <class C>
struct MemoryLookup {
  using Request = MemoryRequest<C>;
  using Line = MemoryLine<C>;
  template <class Port>
  using OfSecond = hls::OptionalPort<kHasSecondLevel<C>, Port>;
  using Rows = hls::RamRead<SecondRow<C>, kSecondSets<C>>;

  hls::In<std::conditional_t<kHasSecondLevel<C>, Repeated<Request>, Request>> request;
  hls::Out<PortRead<C>> read;
  hls::RamWrite<ReadInFlight<C>, kPortIds<C>> in_flight;
  std::conditional_t<kHasSecondLevel<C>, Rows[kSecondWays], hls::Absent> rows;
  OfSecond<hls::RamRead<LastMiss<C>, kSecondSets<C>>> last_miss;
  OfSecond<hls::RamWrite<LastMiss<C>, kSecondSets<C>>> missed;
  OfSecond<hls::Out<Line>> hit;
  OfSecond<hls::Out<Request>> again;
  OfSecond<hls::Out<PortLine<C>>> invalidate;
  HLS_PORTS(request, read, in_flight, rows, last_miss, missed, hit, again, invalidate)

  void step() {
    if constexpr (kHasSecondLevel<C>) {
      look_up(request.read());
    } else {
      const Request r = request.read();
      ask(r, {});
    }
  }

 private:
  static constexpr unsigned kMostTries = 255;
  using Tries = uint<hls::index_width(kMostTries + 1)>;

  void ask(const Request& r, uint<2> way) {
    const PortId<C> id = port_id(r);
    in_flight.write(hls::to_bits(id), ReadInFlight<C>{r.address, way});
    const PortAddress byte = byte_of<C>(r.kind, r.address);
    const auto from = [&](MemoryKind kind, unsigned line_bytes) {
      const PortAddress within = PortAddress::from(read_bytes<C>(line_bytes) - 1);
      return PortRead<C>{id, byte & ~within, uint<4>::from(last_beat<C>(kind))};
    };
    read.write(of_kind(r.kind, from(MemoryKind::kNode, kNodeLineBytes<C>),
                       from(MemoryKind::kList, kListLineBytes<C>),
                       from(MemoryKind::kColumn, kColumnBytes)));
  }

  void look_up(const Repeated<Request>& repeated) {
    const Request& r = repeated.job;
    const SecondLineNumber<C> line = second_line_of<C>(r.kind, r.address);
    const SecondSet<C> set =
        r.invalidate ? SecondSet<C>::from(repeated.index.raw()) : SecondSet<C>::from(line.raw());
    bool found = false;
    ReadWords<C> data;
    for (unsigned w = 0; w < kSecondWays; ++w) {
      const SecondRow<C> row = rows[w].read(set);
      if (row.valid && !row.torn && row.line == line) {
        found = true;
        data = row.data;
      }
    }
    const LastMiss<C> last = last_miss.read(set);
    const bool comes =
        last.valid && !last.torn && last.line == line && r.tries != Tries::from(kMostTries);
    const auto way = uint<2>::from(hls::next(last.way).raw() & (kSecondWays - 1));
    if (r.invalidate) {
      missed.write(set, {});
      PortLine<C> none;
      none.invalidate = true;
      none.set = set;
      invalidate.write(none);
    } else if (found) {
      hit.write(Line{port_id(r), r.address, data});
    } else if (comes) {
      Request once_more = r;
      once_more.tries = hls::next(r.tries);
      again.write(once_more);
    } else {
      missed.write(set, LastMiss<C>{false, true, line, way});
      ask(r, way);
    }
  }
};

}  // namespace dynrt
