// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the matrix store: the columns in which a triangle lies in the memory. All four are
// stored, or three (thesis 5.1.1), of which the first brings the column of ones along.
#pragma once

#include "units/memory_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

/// The ports of a packet's matrix.
template <class C>
struct MatrixColumns {
  using Real = typename C::Real;
  hls::RamWrite<Vector<Real>, 1u << PacketId<C>::kWidth> column[4];
  HLS_PORTS(column)
};

/// Spare bits of column 0: none where a core reads none.
template <class C>
void keep_spare_bits(const ColumnReply<C>& r, MatrixExtra<C>& extra) {
  if constexpr (!C::kOneColour || kTwoLevels<C>) {
    if (r.context.column == uint<2>(0)) {
      extra = r.line.spare().template trunc<MatrixExtra<C>::kWidth>();
    }
  }
}

template <class C>
struct FourColumns : MatrixColumns<C> {
  using Real = typename C::Real;
  using PortsOfParts = hls::Parts<MatrixColumns<C>>;
  HLS_NO_PORTS

  /// Whether the matrix of a job lies in three columns.
  static bool is_short(const ColumnContext<C>& /*context*/) { return false; }
  /// Writes the column where it belongs.
  void store(const ColumnReply<C>& r, const Vector<Real>& values, bool /*is_short*/) {
    for (unsigned c = 0; c < 4; ++c) {
      if (r.context.column == uint<2>::from(c)) this->column[c].write(r.context.packet, values);
    }
  }
  static void keep_extra(const ColumnReply<C>& r, bool /*is_short*/, MatrixExtra<C>& extra) {
    keep_spare_bits<C>(r, extra);
  }
  /// One column more has arrived.
  static uint<2> count(uint<2> columns, bool /*complete*/) { return hls::next(columns); }
  static MatrixNumber<C> matrix_of(const ColumnReply<C>& r) {
    return r.address.template bits<C::kMatrixBits + 1, 2>();
  }
};

template <class C>
struct ThreeColumns : MatrixColumns<C> {
  using Real = typename C::Real;
  using PortsOfParts = hls::Parts<MatrixColumns<C>>;
  HLS_NO_PORTS

  static bool is_short(const ColumnContext<C>& context) {
    return context.kind == TransformKind::kTriangle &&
           !is_primitive<C>(Primitive::kSphere, context.extras.primitive);
  }
  void store(const ColumnReply<C>& r, const Vector<Real>& values, bool is_short) {
    const uint<2> ones = r.line.spare().template bits<17, 16>();
    const uint<2> place = is_short ? place_of(r.context.column, ones) : r.context.column;
    const bool brings_ones = is_short && r.context.column == uint<2>(0);
    for (unsigned c = 0; c < 4; ++c) {
      const bool is_ones = brings_ones && ones == uint<2>::from(c);
      if (is_ones || place == uint<2>::from(c)) {
        this->column[c].write(r.context.packet, is_ones ? kOnes : values);
      }
    }
  }
  /// The spare bits of the first column, or of the first two of three.
  static void keep_extra(const ColumnReply<C>& r, bool is_short, MatrixExtra<C>& extra) {
    if constexpr (C::kOneColour) {
      keep_spare_bits<C>(r, extra);
    } else {
      // The row is behind one choice: its loop is short.
      const bool first = r.context.column == uint<2>(0);
      const bool second = r.context.column == uint<2>(1);
      const bool brings_high = is_short ? second : first;
      const uint<8> high =
          is_short ? r.line.spare().template bits<15, 8>() : r.line.spare().template bits<23, 16>();
      extra = hls::concat(brings_high ? high : extra.template bits<23, 16>(),
                          first ? r.line.spare().template trunc<16>() : extra.template trunc<16>());
    }
  }
  /// Without an adder, for the loop's sake.
  static uint<2> count(uint<2> columns, bool complete) {
    const bool low = columns.template bit<0>();
    const bool high = columns.template bit<1>();
    return complete ? uint<2>(0) : hls::concat(uint<1>(high != low), uint<1>(!low));
  }
  static MatrixNumber<C> matrix_of(const ColumnReply<C>& r) { return r.context.matrix.get(); }

 private:
  static constexpr Vector<Real> kOnes{Real::one(), Real::one(), Real::one()};

  /// Where a stored column belongs: around the column of ones, the translation behind.
  static uint<2> place_of(uint<2> stored, uint<2> ones) {
    return stored == uint<2>(0)   ? uint<2>(uint<1>(ones == uint<2>(0)))
           : stored == uint<2>(1) ? (ones == uint<2>(2) ? uint<2>(1) : uint<2>(2))
                                  : uint<2>(3);
  }
};

template <class C>
using StoredTriangle = std::conditional_t<kThreeColumns<C>, ThreeColumns<C>, FourColumns<C>>;

}  // namespace dynrt
