// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit with every kind of port, to try the bench on: it keeps a total per packet. tally.v is its
// hand-written Verilog, with faults on demand.
#pragma once

#include "hls/float.h"
#include "hls/ports.h"

namespace hls::cosim::example {

using hls::uint;
using Real = hls::Float<7, 16>;

enum class Action : unsigned char { kAdd, kReplace, kSkip, kSilent };

}  // namespace hls::cosim::example

template <>
inline constexpr unsigned hls::enum_width<hls::cosim::example::Action> = 2;

namespace hls::cosim::example {

struct Job {  // 99 bits
  uint<4> packet;
  Action action = Action::kAdd;
  uint<5> address;
  Real real;
  uint<64> stamp;
  HLS_FIELDS(packet, action, address, real, stamp)
};
struct Row {  // 40 bits
  uint<16> weight;
  uint<24> salt;
  HLS_FIELDS(weight, salt)
};
struct Result {  // 108 bits
  uint<4> packet;
  uint<16> total;
  Real real;
  uint<64> stamp;
  HLS_FIELDS(packet, total, real, stamp)
};

struct Tally {
  hls::In<Job> job;
  hls::In<uint<7>> extra;
  hls::Config<uint<9>> offset;
  hls::RamRead<Row, 32, 2> table;
  hls::Out<Result> result;
  hls::Out<uint<5>> copy[2];
  hls::RamWrite<uint<16>, 16> last;
  hls::Ram1R1W<uint<16>, 16> totals;
  HLS_PORTS(job, extra, offset, table, result, copy, last)

  void step() {
    const Job j = job.read();
    const uint<7> e = extra.read();
    const Row row = table.read(j.address);
    const uint<16> before = totals.read(j.packet);
    const auto sum = ((before + row.weight) + e) + offset.get();
    const uint<16> total = j.action == Action::kAdd ? sum.trunc<16>() : row.weight;
    totals.write(j.packet, total);
    if (j.action == Action::kSilent) return;
    if (j.action != Action::kSkip) {
      result.write({j.packet, total, -j.real, j.stamp ^ uint<64>(row.salt)});
    }
    copy[j.address.bit<0>() ? 1 : 0].write(j.address);
    if (j.action == Action::kReplace) last.write(j.packet, total);
  }
};

}  // namespace hls::cosim::example
