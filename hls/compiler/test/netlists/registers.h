// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Registers have the width that their values need (an enum of three values: two bits), and one that
// never changes has no next value.
// CHECK-DAG: :3 = register state_count{{$}}
// CHECK-DAG: :1 = register state_flag{{$}}
// CHECK-DAG: :2 = register mode{{$}}
// CHECK-DAG: :5 = register fixed{{$}}
// CHECK-NOT: register fixed <=
#include "hls/ports.h"
namespace netlists {
enum class Mode : unsigned { kOff, kSlow, kFast };
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  struct State {
    unsigned count = 3;
    bool flag = true;
  };
  State state;
  Mode mode = Mode::kOff;
  hls::uint<5> fixed = 17;
  void step() {
    const hls::uint<8> x = in.read();
    state.count = (state.count + 1) % 8;
    state.flag = !state.flag;
    if (x == hls::uint<8>(3)) mode = Mode::kSlow;
    if (x == hls::uint<8>(4) && mode == Mode::kSlow) mode = Mode::kFast;
    const auto sum = x + hls::uint<8>::from(state.count) + hls::uint<8>(fixed);
    out.write(state.flag && mode == Mode::kFast ? sum.trunc<8>() : x);
  }
};
}  // namespace netlists
