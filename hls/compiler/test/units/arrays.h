// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: local arrays, tables and references with places known at run time only.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::sint;
using hls::uint;

struct Pick {
  std::array<uint<7>, 6> values;
  uint<3> from;
  uint<3> to;
  uint<2> row;
  uint<2> column;
  bool second;
  HLS_FIELDS(values, from, to, row, column, second)
};

struct Point {
  uint<9> x;
  sint<13> y;
  bool set;
  HLS_FIELDS(x, y, set)
};

struct Picked {
  std::array<uint<7>, 6> values;
  uint<7> value;
  uint<12> entry;
  Point point;
  std::array<Point, 3> points;
  uint<16> cell;
  uint<9> sum;
  uint<7> best;
  HLS_FIELDS(values, value, entry, point, points, cell, sum, best)
};

struct Arrays {
  hls::In<Pick> pick;
  hls::Out<Picked> picked;
  HLS_PORTS(pick, picked)

  static constexpr unsigned short kTable[5] = {0x123, 0xfff, 0x800, 7, 0x5a5};

  void step() {
    const Pick p = pick.read();
    Picked out;
    const unsigned from = static_cast<unsigned>(p.from.to_u64()) % 6;
    const unsigned to = static_cast<unsigned>(p.to.to_u64()) % 6;
    std::array<uint<7>, 6> values = p.values;
    values[to] = values[from];
    out.values = values;
    out.value = values[5 - from];
    out.entry = uint<12>::from(kTable[p.from.to_u64() % 5]);

    std::array<Point, 3> points{};
    for (unsigned i = 0; i < 3; ++i) {
      points[i].x = uint<9>::from(i * 3);
      points[i].y = -1;
    }
    Point& changed = points[to % 3];
    changed.x = (changed.x + p.values[0]).trunc<9>();
    changed.set = true;
    points[from % 3].y = p.values[1].to_signed();
    out.point = points[(from + to) % 3];
    out.points = points;

    uint<16> cells[4][4];
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = 0; j < 4; ++j) cells[i][j] = uint<16>::from(16 * i + j);
    }
    cells[p.row.to_u64()][p.column.to_u64()] = uint<16>::ones();
    out.cell = cells[p.column.to_u64()][p.row.to_u64()];

    uint<9> sums[2] = {uint<9>(1), uint<9>(2)};
    uint<9>& sum = p.second ? sums[1] : sums[0];
    sum = (sum + p.values[2]).trunc<9>();
    out.sum = (sums[0] + sums[1]).trunc<9>();

    const uint<7>* best = &values[0];
    for (const uint<7>& value : values) {
      if (value > *best) best = &value;
    }
    out.best = *best;
    picked.write(out);
  }
};

}  // namespace samples
