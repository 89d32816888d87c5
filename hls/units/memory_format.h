// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The layout of the board's memory: the one description for the core that reads and the host that
// packs.
//
// Six banks of 2^20 words each. Banks 0 to 2 hold the scene, in words that are as wide as the
// configuration's float R asks for, 32 bits for all of at most 24. In their lower half node n is
// {bank 1 [n], bank 0 [n]} and list entry n is bank 2 [n]; in the upper half matrix column a is row
// r of column a in bank r [2^19 + a], where a = 4 * matrix + column (columns 0 to 2 are the linear
// part, column 3 the translation). Data with fewer bits than their words lie in the lowest bits.
// Bank 3 holds the framebuffer, banks 4 and 5 the hit records, in words of 32 bits.
#pragma once

#include <algorithm>
#include <array>

#include "hls/fields.h"
#include "hls/float.h"

namespace dynrt {

using hls::sint;
using hls::uint;

inline constexpr unsigned kBanks = 6;             ///< of a memory without a port
inline constexpr unsigned kSceneBanks = 3;        ///< from bank 0 on
inline constexpr unsigned kFrameBank = 3;         ///< of the pixels
inline constexpr unsigned kHitBank = 4;           ///< of the hit records, and the one after it
inline constexpr unsigned kBankWords = 1u << 20;  ///< of each bank
inline constexpr unsigned kSramLatency = 3;       ///< clocks from a bank's address to its data
inline constexpr unsigned kAddressBits = 19;      ///< of the number of a node, list entry or column
inline constexpr unsigned kMaxNodes = 1u
                                      << kAddressBits;  ///< of which number 0 is the null address
inline constexpr unsigned kMaxListEntries = 1u << kAddressBits;  ///< of all trees
inline constexpr unsigned kListStep = 2;  ///< of the lists' beginnings, where nodes point to them
inline constexpr unsigned kMatrixBits = 17;                  ///< of the number of a matrix
inline constexpr unsigned kMaxMatrices = 1u << kMatrixBits;  ///< of all kinds
inline constexpr unsigned kColumnBase = 1u << kAddressBits;  ///< first word of the matrix columns

/// A memory behind one port (units/memory_port.h), whose words have 32 bits, holds the scene in its
/// lower half: items in the order of their numbers, each in words from the lowest address on. A
/// column leaves the last of its four words empty. Above lie the pixels, those of 16 bits two to a
/// word, and the hit records, of which each word of bank 4 is followed by that of bank 5.
inline constexpr unsigned kPortAddressBits = 24;  ///< of the address of a byte of the scene
inline constexpr unsigned kNodeBytes = 8;         ///< of a node behind the port
inline constexpr unsigned kEntryBytes = 4;        ///< of a list entry there
inline constexpr unsigned kColumnBytes = 16;      ///< of a matrix column or a box there
/// Entries in a line of the list cache, where one of the node cache has several nodes: as many as
/// have its bytes.
constexpr unsigned entries_of_line(unsigned nodes) {
  return nodes == 1 ? 1 : nodes * kNodeBytes / kEntryBytes;
}
inline constexpr unsigned kEntriesAt = kMaxNodes * kNodeBytes;  ///< byte of list entry 0
inline constexpr unsigned kColumnsAt = 2 * kEntriesAt;          ///< byte of matrix column 0
static_assert(kColumnsAt + (kColumnBytes << kAddressBits) == 1u << kPortAddressBits);
inline constexpr unsigned kMemoryAddressBits = kPortAddressBits + 1;  ///< of any byte's address
inline constexpr unsigned kPixelsAt = 1u << kPortAddressBits;         ///< byte of pixel 0
inline constexpr unsigned kHitsAt = kPixelsAt + kPixelsAt / 2;        ///< byte of hit record 0
static_assert(kHitsAt + 2 * 4 * kBankWords == 1u << kMemoryAddressBits);

/// Pixels from the beginning of a row to that of the next, in a memory behind the port: with whole
/// packets in each row, what a packet writes of a row lies side by side and is aligned.
inline constexpr unsigned kPitchStep = 4;  ///< pixels; each row begins at a multiple of it
constexpr unsigned row_pitch(unsigned width) {
  return (width + (kPitchStep - 1)) / kPitchStep * kPitchStep;
}

/// The bank that holds a word of that memory in a core with banks, and the word's number in it.
struct BankWord {
  unsigned bank = kBanks;  ///< none: the word is empty
  unsigned word = 0;
};
constexpr BankWord bank_word(unsigned byte) {
  const unsigned port_word = byte / 4;
  if (byte < kEntriesAt) return {port_word % 2, port_word / 2};
  if (byte < kColumnsAt) return {2, (byte - kEntriesAt) / kEntryBytes};
  if (byte >= kHitsAt) return {kHitBank + port_word % 2, (byte - kHitsAt) / 8};
  if (byte >= kPixelsAt) return {kFrameBank, (byte - kPixelsAt) / 4};
  const unsigned row = port_word % 4;
  if (row == 3) return {};
  return {row, kColumnBase + (byte - kColumnsAt) / kColumnBytes};
}

/// A node, list or column address; a node's null address is an empty child, never fetched.
using Address = uint<kAddressBits>;
using MatrixIndex = uint<kMatrixBits>;
using Word = uint<32>;

/// Spare bits beside each coefficient of a matrix: a byte, or as many as it takes for those of a
/// column to hold a float.
template <class R>
inline constexpr unsigned kSpareBits = std::max(8u, (R::kLeafWidth + 2) / 3);
/// A word of banks 0 to 2.
template <class R>
using SceneWord = uint<std::max(Word::kWidth, R::kLeafWidth + kSpareBits<R>)>;

/// The axis that a k-D tree node splits; a leaf's `left` is the address of its list.
enum class NodeKind : unsigned char { kSplitX, kSplitY, kSplitZ, kLeaf };

/// The part along the axis that an inner node splits.
template <class T>
constexpr T of_split_axis(NodeKind kind, const T& x, const T& y, const T& z) {
  return kind == NodeKind::kSplitX ? x : kind == NodeKind::kSplitY ? y : z;
}

/// A node of the k-D tree: in the memory 40 bits and a float.
template <class R, unsigned AddressBits = kAddressBits>
struct Node {
  NodeKind kind = NodeKind::kLeaf;
  R split;
  uint<AddressBits> left;
  uint<AddressBits> right;
  HLS_FIELDS(kind, split, left, right)
};

/// The unit object that a transformed ray is tested against (thesis 5.2).
enum class Primitive : unsigned char {
  kTriangle,   ///< (0,0,0), (1,0,0), (0,1,0)
  kSphere,     ///< of radius 1 about the origin
  kRectangle,  ///< from (0,0,0) to (1,1,0)
};

/// An entry of a leaf's list, 32 bits: the matrix of an object instance or of a primitive. The
/// lowest of the reserved bits give the primitive; a core with one kind reads none of them.
struct ListEntry {
  MatrixIndex matrix;
  uint<14> reserved;
  bool last = false;
  HLS_FIELDS(matrix, reserved, last)

  constexpr Primitive primitive() const {
    return static_cast<Primitive>(static_cast<unsigned>(reserved.trunc<2>().raw()));
  }
  constexpr void set_primitive(Primitive p) { reserved = uint<14>::from(static_cast<unsigned>(p)); }
};

/// A word of a matrix column: a coefficient and its spare bits.
template <class R>
struct MatrixWord {
  R value;
  uint<kSpareBits<R>> spare;
  HLS_FIELDS(value, spare)
};

/// One column of a 3x4 affine matrix. The spare bits of column 0, row 0 lowest, hold the root node
/// of an object instance, or the colour of a triangle (red lowest).
template <class R>
struct MatrixColumn {
  std::array<MatrixWord<R>, 3> row;
  HLS_FIELDS(row)

  constexpr uint<3 * kSpareBits<R>> spare() const {
    return hls::concat(row[2].spare, hls::concat(row[1].spare, row[0].spare));
  }
};

/// A side of a box, for cores that test boxes in the world: with as many bits of the mantissa as
/// leave two of them room in a word of a matrix column, 8 beside 7 of the exponent.
template <class R>
inline constexpr unsigned kBoundMantissaBits =
    hls::bit_width_of<MatrixWord<R>>() / 2 - 1 - R::kExponentBits;
template <class R>
using Bound = hls::Float<R::kExponentBits, kBoundMantissaBits<R>, hls::Rounding::kTruncate>;

/// The same number with more bits of the mantissa; truncated, with fewer.
template <class R, class From>
constexpr R longer(From number) {
  if constexpr (R::kMantissaBits == From::kMantissaBits) {
    return R::from_bits(number.bits());
  } else {
    return R::from_bits(
        hls::concat(number.bits(), uint<R::kMantissaBits - From::kMantissaBits>(0)));
  }
}
template <class R, class From>
constexpr R shorter(From number) {
  constexpr unsigned kDropped = From::kMantissaBits - R::kMantissaBits;
  return R::from_bits(number.bits().template bits<From::kLeafWidth - 1, kDropped>());
}

/// The extent of an object instance in the world along one axis: where its sides lie from the eye,
/// rounded outwards. Those of the three axes are the words of a column, in place of a coefficient
/// and its spare bits. The box of the instance with matrix n is column n +
/// FrameRegisters::box_column.
template <class R>
struct Slab {
  Bound<R> low;
  Bound<R> high;
  HLS_FIELDS(low, high)
};
template <class R>
using WorldBoxSlabs = std::array<Slab<R>, 3>;
template <class R>
constexpr WorldBoxSlabs<R> slabs_of(const MatrixColumn<R>& column) {
  WorldBoxSlabs<R> slabs;
  for (unsigned axis = 0; axis < 3; ++axis) {
    constexpr unsigned kWidth = Bound<R>::kLeafWidth;
    const auto word = hls::concat(column.row[axis].spare, column.row[axis].value.bits());
    slabs[axis] = {Bound<R>::from_bits(word.template trunc<kWidth>()),
                   Bound<R>::from_bits(word.template bits<2 * kWidth - 1, kWidth>())};
  }
  return slabs;
}

/// A triangle in three columns (thesis 5.1.1): the linear part has a column of three ones, which is
/// not stored. The other two are stored in their order, then the translation. The spare bits that
/// the first two need for the number of the column of ones push the colour's blue on:
///
///        spare bits  7 to 0    15 to 8  23 to 16
///   stored column 0  red       green    number of the column of ones
///   stored column 1  mirror    blue     number of the column of ones
///   stored column 2  factor of the cosine, a float
///
/// Stored triangle n begins at column 3 n, any other matrix n at column 4 n: each kind has its own
/// numbers. Every other primitive of a list's entry (a sphere) begins like a triangle and has four
/// columns, and so does a mirror's reflection, which follows its triangle.
inline constexpr unsigned kStoredColumns = 3;  ///< of a triangle in three columns

/// A finished ray's hit as the core writes it, word by word into bank 4 and at the same place into
/// bank 5: pixel p's words begin at kHitWords * p. Numbers are the bits of the core's float, of at
/// most 32 bits; a miss has `hit` zero and its initial values in the other fields.
struct HitPlace {
  Word t;
  Word v;
  MatrixIndex object;
  uint<14> reserved;
  bool hit = false;
  HLS_FIELDS(t, v, object, reserved, hit)
};
struct HitSurface {
  Word u;
  Word cosine;
  MatrixIndex triangle;
  uint<15> reserved;
  HLS_FIELDS(u, cosine, triangle, reserved)
};
inline constexpr unsigned kHitWords = hls::bit_width_of<HitPlace>() / 32;  ///< of a hit, by bank
static_assert(hls::bit_width_of<HitSurface>() == hls::bit_width_of<HitPlace>());
inline constexpr unsigned kMaxPixels = kBankWords / kHitWords;  ///< whose hits fill a bank
inline constexpr unsigned kMaxSide = 1024;  ///< pixels a side, by ray generation

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::NodeKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::Primitive> = 2;
