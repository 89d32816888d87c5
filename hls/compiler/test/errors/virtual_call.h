// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/virtual_call.h:20: error: this call goes through a pointer or a virtual function; call the function by its name or make it a template parameter
#include "hls/ports.h"
namespace errors {
struct Shape {
  virtual unsigned area() const = 0;
};
struct Square : Shape {
  unsigned area() const override { return 4; }
};
struct Circle : Shape {
  unsigned area() const override { return 3; }
};
inline unsigned area_of(bool round, const Square& square, const Circle& circle) {
  const Shape* shape = &square;
  for (unsigned i = 0; i < 2; ++i) {
    if (round) shape = &circle;
  }
  return shape->area();
}
struct Unit {
  hls::In<bool> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const Square square;
    const Circle circle;
    out.write(hls::uint<8>::from(area_of(in.read(), square, circle)));
  }
};
}  // namespace errors
