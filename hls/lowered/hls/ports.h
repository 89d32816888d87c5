// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The members that a unit is made of, as hlsc sees them: every access becomes calls of undefined
// functions, leaf by leaf, which hlsc turns into ports. The port's kind, width, rows and latency
// are the numbers of its base class, where hlsc finds them in the debug info; a function's
// annotation gives its effect on the port and the widths. hls/native/hls/ports.h has the same names
// for the native model and documents them.
#pragma once

#include <type_traits>

#include "hls/fields.h"
#include "hls/port_kind.h"

#define HLS_PORTS(...)
#define HLS_NO_PORTS

namespace hls {

namespace lowered {

/// Kind, token or row width in bits, rows (1 for channels), latency in clocks.
template <PortKind Kind, unsigned Width, unsigned Rows, unsigned Latency>
class Port {
  char place_ = 0;
};

/// Gives a function's effect on a port and the widths of the leaf and of the address; 0 for none.
/// The ABI passes an integer of 34 bits as one of 64, so types do not show the width.
#define HLS_PORT_ACCESS(ACCESS, LEAF_WIDTH, ADDRESS_WIDTH)                                      \
  [[clang::annotate("hls.port_access", static_cast<unsigned>(PortAccess::ACCESS), (LEAF_WIDTH), \
                    (ADDRESS_WIDTH))]]

/// `offset` is the leaf's lowest bit within the token or row.
template <unsigned W>
HLS_PORT_ACCESS(kGetLeaf, W, 0u)
unsigned _BitInt(W) leaf_get(const void* port, unsigned offset);
template <unsigned W>
HLS_PORT_ACCESS(kPutLeaf, W, 0u)
void leaf_put(const void* port, unsigned offset, unsigned _BitInt(W) value);
template <unsigned W, unsigned A>
HLS_PORT_ACCESS(kGetRowLeaf, W, A)
unsigned _BitInt(W) row_get(const void* port, unsigned _BitInt(A) address, unsigned offset);
/// Ends the leaf_puts of one written token, or of one written row.
HLS_PORT_ACCESS(kCommitToken, 0u, 0u)
void token_commit(const void* port);
template <unsigned A>
HLS_PORT_ACCESS(kCommitRow, 0u, A)
void row_commit(const void* port, unsigned _BitInt(A) address);

#undef HLS_PORT_ACCESS

template <class T>
T get_token(const void* port) {
  T token{};
  for_each_leaf(token, [port]<class L>(L& leaf, unsigned offset) {
    leaf = leaf_from_bits<L>(
        uint<bit_width_of<L>()>::of_raw(leaf_get<bit_width_of<L>()>(port, offset)));
  });
  return token;
}
template <class T>
void put_token(const void* port, const T& token) {
  for_each_leaf(token, [port]<class L>(L& leaf, unsigned offset) {
    constexpr unsigned kWidth = bit_width_of<std::remove_const_t<L>>();
    leaf_put<kWidth>(port, offset, leaf_to_bits(leaf).raw());
  });
}
template <class T, class A>
T get_row(const void* port, A address) {
  T row{};
  for_each_leaf(row, [port, address]<class L>(L& leaf, unsigned offset) {
    constexpr unsigned kWidth = bit_width_of<L>();
    leaf = leaf_from_bits<L>(
        uint<kWidth>::of_raw(row_get<kWidth, A::kWidth>(port, address.raw(), offset)));
  });
  return row;
}
template <class T, class A>
void put_row(const void* port, A address, const T& row) {
  put_token(port, row);
  row_commit<A::kWidth>(port, address.raw());
}

}  // namespace lowered

template <class T>
class In : lowered::Port<PortKind::kIn, bit_width_of<T>(), 1, 0> {
 public:
  using Data = T;
  T read() { return lowered::get_token<T>(this); }
};

template <class T>
class Out : lowered::Port<PortKind::kOut, bit_width_of<T>(), 1, 0> {
 public:
  using Data = T;
  void write(const T& token) {
    lowered::put_token(this, token);
    lowered::token_commit(this);
  }
};

template <class T, unsigned N>
class Ram1R1W : lowered::Port<PortKind::kRam, bit_width_of<T>(), N, 1> {
 public:
  using Address = uint<index_width(N)>;
  T read(Address address) const { return lowered::get_row<T>(this, address); }
  void write(Address address, const T& row) { lowered::put_row(this, address, row); }
};

template <class T, unsigned N>
class RegisterFile : lowered::Port<PortKind::kRegisterFile, bit_width_of<T>(), N, 0> {
 public:
  using Address = uint<index_width(N)>;
  T read(Address address) const { return lowered::get_row<T>(this, address); }
  void write(Address address, const T& row) { lowered::put_row(this, address, row); }
};

template <class T, unsigned N>
class RamWrite : lowered::Port<PortKind::kRamWrite, bit_width_of<T>(), N, 1> {
 public:
  using Address = uint<index_width(N)>;
  void write(Address address, const T& row) { lowered::put_row(this, address, row); }
};

template <class T, unsigned N, unsigned Latency = 1>
class RamRead : lowered::Port<PortKind::kRamRead, bit_width_of<T>(), N, Latency> {
 public:
  using Address = uint<index_width(N)>;
  T read(Address address) const { return lowered::get_row<T>(this, address); }
};

template <class T>
class Config : lowered::Port<PortKind::kConfig, bit_width_of<T>(), 1, 0> {
 public:
  using Data = T;
  T get() const { return lowered::get_token<T>(this); }
};

/// Replaces a port that a configuration leaves out.
struct Absent {};
template <bool Present, class Port>
using OptionalPort = std::conditional_t<Present, Port, Absent>;
template <class... Part>
struct Parts {};

}  // namespace hls
