// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: the ends of RAMs, a register file, and a configuration value.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::sint;
using hls::uint;

struct Access {
  uint<4> row;
  uint<3> counter;
  bool fetch;
  bool store;
  HLS_FIELDS(row, counter, fetch, store)
};
struct Row {
  sint<20> height;
  bool valid;
  HLS_FIELDS(height, valid)
};
struct Settings {
  uint<20> offset;
  bool negate;
  HLS_FIELDS(offset, negate)
};
struct Answer {
  sint<20> height;
  uint<6> count;
  HLS_FIELDS(height, count)
};

struct Rams {
  hls::In<Access> access;
  hls::Config<Settings> settings;
  hls::RamRead<Row, 16, 3> rows;
  hls::RamWrite<Row, 16> copy;
  hls::RegisterFile<uint<6>, 8> counters;
  hls::Out<Answer> answer;
  HLS_PORTS(access, settings, rows, copy, answer)

  void step() {
    const Access a = access.read();
    const Settings s = settings.get();
    Answer out;
    if (a.fetch) {
      Row row = rows.read(a.row);
      if (s.negate && row.valid) row.height = (sint<20>(0) - row.height).trunc<20>();
      out.height = (row.height + s.offset.as_signed()).trunc<20>();
      if (a.store) copy.write(hls::next(a.row), {out.height, !row.valid});
    } else {
      out.height = rows.read(a.row ^ uint<4>(5)).height;
    }
    const uint<6> count = counters.read(a.counter);
    if (!a.store || count < uint<6>(60)) counters.write(a.counter, hls::next(count));
    out.count = count;
    answer.write(out);
  }
};

}  // namespace samples
