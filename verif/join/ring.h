// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A small join with everything that a join can connect: two writers of a channel, a repeated job, a
// fork whose branches meet again, a unit that feeds itself, a RAM with two readers, banks outside,
// values set and fixed, a sink. Up to 16 jobs are on the way, each with an id of its own.
#pragma once

#include "hls/ports.h"

namespace dynrt::ring {

using hls::uint;
using Id = uint<4>;
using Value = uint<16>;

struct Job {
  uint<3> repeat;
  Id id;
  Value value;
  HLS_FIELDS(repeat, id, value)
};
struct NumberedJob {
  uint<3> index;
  bool last = false;
  Job job;
  HLS_FIELDS(index, last, job)
};
struct Item {
  Id id;
  uint<3> index;
  bool last = false;
  Value value;
  HLS_FIELDS(id, index, last, value)
};
using ItemRow = uint<7>;
inline constexpr unsigned kItems = 128;
constexpr ItemRow item_row(const Item& item) { return hls::concat(item.id, item.index); }

/// Passes a job on.
struct Enter {
  hls::In<Job> job;
  hls::Out<Job> out;
  HLS_PORTS(job, out)
  void step() { out.write(job.read()); }
};

/// Notes a job's value where later units find it.
struct Store {
  hls::In<Job> job;
  hls::Out<Job> out;
  hls::RamWrite<Value, 16> note;
  HLS_PORTS(job, out, note)
  void step() {
    const Job j = job.read();
    note.write(j.id, ~j.value);
    out.write(j);
  }
};

/// Makes an item of a numbered job, with a value from a bank outside.
struct Number {
  hls::In<NumberedJob> job;
  hls::RamRead<uint<32>, kItems, 3> bank;
  hls::RamRead<Value, 16> note;
  hls::Out<Item> item;
  HLS_PORTS(job, bank, note, item)
  void step() {
    const NumberedJob j = job.read();
    Item i{j.job.id, j.index, j.last, {}};
    const uint<32> salt = bank.read(item_row(i));
    i.value = (note.read(j.job.id) + salt.trunc<16>()).trunc<16>();
    item.write(i);
  }
};

/// One side of the fork; it marks odd values.
struct Side {
  hls::In<Item> item;
  hls::Config<uint<8>> add;
  hls::Out<Item> out;
  hls::Out<Item> odd;
  HLS_PORTS(item, add, out, odd)
  void step() {
    Item i = item.read();
    if (i.value.bit<0>()) odd.write(i);
    i.value = (i.value + add.get()).trunc<16>();
    out.write(i);
  }
};

/// Takes an item from both sides, and as it was before.
struct Pair {
  hls::In<Item> side[2];
  hls::In<Item> before;
  hls::RamRead<Value, 16> note;
  hls::Out<Item> out;
  HLS_PORTS(side, before, note, out)
  void step() {
    Item i = side[0].read();
    const Item other = side[1].read();
    const Value sum = (before.read().value + note.read(other.id)).trunc<16>();
    i.value = ((i.value ^ other.value.shl<3>()) + sum).trunc<16>();
    out.write(i);
  }
};

/// Sends an item round until its value is a multiple of four, then out.
struct Round {
  hls::In<Item> item;
  hls::Out<Item> again;
  hls::Out<Item> done;
  hls::RamWrite<uint<32>, kItems> result;
  HLS_PORTS(item, again, done, result)
  void step() {
    Item i = item.read();
    if (i.value.trunc<2>() == uint<2>(0)) {
      result.write(item_row(i), i.value);
      done.write(i);
    } else {
      i.value = hls::next(i.value);
      again.write(i);
    }
  }
};

}  // namespace dynrt::ring
