// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<65>> in;
  hls::Out<hls::uint<65>> out;
  void step() { out.write(in.read()); }
};
}  // namespace errors
