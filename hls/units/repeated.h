// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A job that a unit repeats, one transaction for each repetition.
#pragma once

#include "hls/ports.h"
#include "units/packet.h"

namespace dynrt {

/// A repeated job has its number of repetitions, less one, in its lowest field; at most four for
/// each ray of a packet.
template <class C>
using RepeatCount = uint<kRayBits<C> + 2>;

/// Job number `index` of a job that is repeated; the last one says so.
template <class Job>
struct Repeated {
  decltype(Job::repeat) index;
  bool last = false;
  Job job;
  HLS_FIELDS(index, last, job)
};

}  // namespace dynrt
