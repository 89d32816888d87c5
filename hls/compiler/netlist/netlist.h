// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The netlist: one transaction of a unit as word-level dataflow, without control flow and without
// LLVM's IR. The front end builds it, the passes rewrite it, the scheduler gives every node a
// stage, the emitter prints it. Nodes are in topological order: an operand's id is less than its
// user's.
//
// Every value is a plain bit vector of `width` bits; signedness is the operation's. There is no
// undefined value: the front end has frozen them all to zero.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hls/port_kind.h"

namespace hlsc {

using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = ~NodeId{0};

/// Bits of a constant, lowest first in little-endian 64-bit words.
class Bits {
 public:
  Bits() = default;
  Bits(unsigned width, std::uint64_t low);
  unsigned width() const { return width_; }
  bool bit(unsigned i) const { return ((words_[i / 64] >> (i % 64)) & 1) != 0; }
  void set(unsigned i, bool value);
  bool is_zero() const;
  bool is_ones() const;
  std::uint64_t low64() const { return word(0); }
  /// Bits [64 i +: 64]; zero above the width.
  std::uint64_t word(unsigned i) const { return i < words_.size() ? words_[i] : 0; }
  /// Bits that do not fit are dropped.
  void set_word(unsigned i, std::uint64_t value);
  unsigned words() const { return static_cast<unsigned>(words_.size()); }
  bool operator==(const Bits&) const = default;

 private:
  unsigned width_ = 0;
  std::vector<std::uint64_t> words_;
};

enum class Op : std::uint8_t {
  kConst,     ///< `value`
  kToken,     ///< bits [low +: width] of the token read from In port `port`
  kConfig,    ///< bits [low +: width] of Config port `port`
  kRegister,  ///< register number `port`: its value before this transaction
  kRow,       ///< bits [low +: width] of the row fetched by row_reads[`port`]
  kAdd,       ///< a + b, all widths equal (wraps)
  kSub,       ///< a - b
  kAddSub,  ///< operands a, b, s (1 bit): s ? a - b : a + b; made by a pass, never by the front end
  kMul,     ///< a * b mod 2^width; operands may be narrower than the result (zero-extended)
  kUDiv,    ///< a / b; operand widths may differ, the result is as wide as a
  kAnd,
  kOr,
  kXor,
  kNot,
  kShl,  ///< a << b, zero when b >= width
  kLShr,
  kAShr,
  kEq,      ///< 1 bit
  kULt,     ///< 1 bit, unsigned a < b
  kSLt,     ///< 1 bit, signed a < b
  kMux,     ///< operands s (1 bit), a, b: s ? a : b
  kSlice,   ///< bits [low +: width] of the operand
  kConcat,  ///< operands from the highest to the lowest
  kSExt,    ///< sign extension to width
  kClz,     ///< leading zeros of the operand (its width if it is zero)
};

/// The place of an operation in the unit's source.
struct SourceLine {
  std::string file;
  unsigned line = 0;
};

struct Node {
  Op op = Op::kConst;
  unsigned width = 0;
  std::vector<NodeId> operands;
  Bits value;         ///< kConst
  unsigned low = 0;   ///< kToken, kConfig, kRow, kSlice
  unsigned port = 0;  ///< index of the port, the register or the row read
  std::string name;   ///< the C++ variable that held it, or empty
  SourceLine where;
};

using hls::PortKind;

/// A member of the unit: channel end, RAM, RAM end or configuration value.
struct Port {
  PortKind kind = PortKind::kIn;
  std::string name;      ///< the member's name; elements of arrays are name_0, name_1, ...
  unsigned width = 0;    ///< of a token, row or value
  unsigned rows = 1;     ///< of a RAM
  unsigned latency = 0;  ///< clocks from a RAM's address to its data; 0 for a register file
  SourceLine where;
};

/// A member of plain type: state read and written in one stage.
struct Register {
  std::string name;
  unsigned width = 0;
  Bits reset;
  NodeId next = kNoNode;  ///< its value after this transaction; kNoNode if it never changes
  SourceLine where;
};

/// At most one of each per port: the front end has merged branches into one with an enable.
struct TokenWrite {
  unsigned port;
  NodeId enable;  ///< 1 bit
  NodeId data;    ///< the port's width
};
struct RowRead {
  unsigned port;
  NodeId enable;
  NodeId address;
};
struct RowWrite {
  unsigned port;
  NodeId enable;
  NodeId address;
  NodeId data;
};

struct Netlist {
  std::string module;  ///< Verilog module name
  std::string unit;    ///< the C++ type it came from
  std::string source;  ///< the header that defines it
  std::vector<Node> nodes;
  std::vector<Port> ports;  ///< in member order
  std::vector<Register> registers;
  std::vector<TokenWrite> token_writes;
  std::vector<RowRead> row_reads;
  std::vector<RowWrite> row_writes;

  NodeId add(Node node);
};

/// Throws std::logic_error that names a node for which an invariant of this file does not hold.
void check(const Netlist& netlist);

/// One line per node, for tests and --dump.
std::string to_text(const Netlist& netlist);

}  // namespace hlsc
