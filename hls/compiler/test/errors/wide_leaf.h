// error: clang rejects the unit:
// hls/fields.h:*: error: static assertion failed due to requirement 'bit_width_of() <= 64': a leaf has at most 64 bits
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<65>> in;
  hls::Out<hls::uint<65>> out;
  void step() { out.write(in.read()); }
};
}  // namespace errors
