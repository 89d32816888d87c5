// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Nodes carry the names of the C++ variables; a struct's member is variable_member.
// CHECK: token job[0]{{ +}}; j_count{{$}}
// CHECK: = add {{.*}}; doubled{{$}}
// CHECK: ; mixed{{$}}
#include "hls/ports.h"
namespace netlists {
struct Job {
  hls::uint<9> count;
  hls::uint<9> mask;
  HLS_FIELDS(count, mask)
};
struct Unit {
  hls::In<Job> job;
  hls::Out<hls::uint<10>> out;
  void step() {
    const Job j = job.read();
    const auto doubled = j.count + j.mask;
    const hls::uint<10> mixed = doubled ^ hls::uint<10>(j.mask);
    out.write(mixed);
  }
};
}  // namespace netlists
