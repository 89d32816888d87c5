// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Small units for the tests of the join.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hls/join.h"

namespace hls::testing {

using Byte = uint<8>;

/// Adds its value to every token.
struct Add {
  In<Byte> in;
  Config<Byte> value;
  Out<Byte> out;
  HLS_PORTS(in, value, out)
  void step() { out.write((in.read() + value.get()).trunc<8>()); }
};
/// Needs a token from both sides.
struct Pair {
  In<Byte> in[2];
  Out<uint<16>> out;
  HLS_PORTS(in, out)
  void step() {
    const Byte low = in[0].read();
    out.write(concat(in[1].read(), low));
  }
};
struct Write {
  In<Byte> in;
  RamWrite<Byte, 256> row;
  HLS_PORTS(in, row)
  void step() {
    const Byte b = in.read();
    row.write(b, ~b);
  }
};
struct Look {
  In<Byte> in;
  RamRead<Byte, 256> row;
  Out<Byte> out;
  HLS_PORTS(in, row, out)
  void step() { out.write(row.read(in.read())); }
};
struct TornRow {
  bool torn = false;
  Byte value;
  HLS_FIELDS(torn, value)
};
struct WriteTorn {
  In<Byte> in;
  RamWrite<TornRow, 256> row;
  HLS_PORTS(in, row)
  void step() {
    const Byte b = in.read();
    row.write(b, TornRow{false, ~b});
  }
};
struct LookTorn {
  In<Byte> in;
  RamRead<TornRow, 256> row;
  Out<uint<9>> out;
  HLS_PORTS(in, row, out)
  void step() {
    const TornRow r = row.read(in.read());
    out.write(concat(r.value, uint<1>(r.torn)));
  }
};
/// Adds one to the row that a token names.
struct CountTorn {
  In<Byte> in;
  RamRead<TornRow, 256> before;
  RamWrite<TornRow, 256> after;
  Out<uint<9>> out;
  HLS_PORTS(in, before, after, out)
  void step() {
    const Byte b = in.read();
    const TornRow r = before.read(b);
    after.write(b, TornRow{false, (r.value + Byte(1)).trunc<8>()});
    out.write(concat(r.value, uint<1>(r.torn)));
  }
};
struct WriteWords {
  In<Byte> in;
  RamWrite<std::array<Byte, 3>, 256> row;
  HLS_PORTS(in, row)
  void step() {
    const Byte b = in.read();
    row.write(b, {b, ~b, b ^ Byte(1)});
  }
};
struct LookAtWord {
  In<uint<10>> in;
  RamRead<Byte, 768> word;
  Out<Byte> out;
  HLS_PORTS(in, word, out)
  void step() { out.write(word.read(in.read())); }
};
struct Job {
  uint<4> repeat;
  uint<6> name;
  HLS_FIELDS(repeat, name)
};
struct NumberedJob {
  uint<4> index;
  bool last = false;
  Job job;
  HLS_FIELDS(index, last, job)
};
struct Send {
  In<Job> in;
  Out<Job> out;
  HLS_PORTS(in, out)
  void step() { out.write(in.read()); }
};
struct Receive {
  In<NumberedJob> in;
  Out<NumberedJob> out;
  HLS_PORTS(in, out)
  void step() { out.write(in.read()); }
};

template <class T>
std::vector<std::uint64_t> values(Fifo<T>& queue) {
  std::vector<std::uint64_t> list;
  while (!queue.empty()) list.push_back(queue.pop().to_u64());
  return list;
}
using List = std::vector<std::uint64_t>;

}  // namespace hls::testing
