// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Makes the nodes of a netlist, simplified as they are made: constants are folded, equal nodes
// shared, constant shifts and masks become wiring, and an operation is only as wide as its result
// can be with the known bits of its operands. For this the builder keeps for every node the bits
// that are known and the number of the highest bits that are copies of the sign.
#pragma once

#include <llvm/ADT/APInt.h>
#include <llvm/ADT/ArrayRef.h>
#include <llvm/ADT/SmallVector.h>
#include <llvm/Support/KnownBits.h>

#include <map>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace hlsc {

class Builder {
 public:
  explicit Builder(Netlist& netlist) : net_(netlist) {}

  /// The source line of the next nodes.
  void set_line(const SourceLine& where) { where_ = where; }
  /// Gives a node a name unless it has one.
  void name(NodeId id, const std::string& name);

  NodeId constant(const llvm::APInt& value);
  NodeId constant(unsigned width, std::uint64_t value) {
    return constant(llvm::APInt(width, value));
  }
  /// kToken, kConfig, kRow, kRegister.
  NodeId source(Op op, unsigned port, unsigned low, unsigned width);
  /// A register's bits above `active` are known zero.
  void assume_register(unsigned index, unsigned active) { register_active_[index] = active; }

  NodeId add(NodeId a, NodeId b) { return arithmetic(Op::kAdd, a, b); }
  NodeId sub(NodeId a, NodeId b) { return arithmetic(Op::kSub, a, b); }
  /// The low `width` bits of the product; the operands are as wide as the result.
  NodeId mul(NodeId a, NodeId b);
  NodeId udiv(NodeId a, NodeId b);
  NodeId logic(Op op, NodeId a, NodeId b);  ///< kAnd, kOr, kXor
  NodeId invert(NodeId a);
  NodeId shift(Op op, NodeId a, NodeId amount);  ///< kShl, kLShr, kAShr; zero or sign when too far
  NodeId equal(NodeId a, NodeId b);
  NodeId less(Op op, NodeId a, NodeId b);  ///< kULt, kSLt
  NodeId mux(NodeId s, NodeId a, NodeId b);
  NodeId slice(NodeId a, unsigned low, unsigned width);
  NodeId concat(llvm::ArrayRef<NodeId> highest_first);
  NodeId sext(NodeId a, unsigned width);
  NodeId zext(NodeId a, unsigned width);
  NodeId trunc(NodeId a, unsigned width) { return slice(a, 0, width); }
  NodeId clz(NodeId a, unsigned width);

  unsigned width(NodeId id) const { return net_.nodes[id].width; }
  const llvm::KnownBits& known(NodeId id) const { return facts_[id].known; }
  /// Bits that hold the value as an unsigned number, and as a signed one.
  unsigned active_bits(NodeId id) const { return known(id).countMaxActiveBits(); }
  unsigned signed_bits(NodeId id) const { return width(id) - facts_[id].sign_copies + 1; }

 private:
  struct Facts {
    llvm::KnownBits known;
    unsigned sign_copies = 1;  ///< highest bits that equal the highest one, itself included
  };
  using Operands = llvm::SmallVector<NodeId, 4>;
  using Key = std::tuple<Op, unsigned, std::vector<NodeId>, unsigned, unsigned>;

  const Node& node(NodeId id) const { return net_.nodes[id]; }
  bool is_constant(NodeId id) const { return node(id).op == Op::kConst; }
  NodeId make(Op op, unsigned width, llvm::ArrayRef<NodeId> operands, Facts facts, unsigned low = 0,
              unsigned port = 0);
  Facts facts_from(llvm::KnownBits known, unsigned sign_copies = 1) const;
  NodeId arithmetic(Op op, NodeId a, NodeId b);
  NodeId wired_logic(Op op, NodeId a, NodeId b);
  NodeId two_way_shift(Op op, NodeId a, NodeId amount);
  NodeId constant_shift(Op op, NodeId a, unsigned amount);
  NodeId join(NodeId high, NodeId low);

  Netlist& net_;
  SourceLine where_;
  std::vector<Facts> facts_;
  std::map<Key, NodeId> known_nodes_;
  std::map<std::string, NodeId> constants_;
  std::map<unsigned, unsigned> register_active_;
};

/// The numbers of the netlist and of LLVM.
Bits to_bits(const llvm::APInt& value);
llvm::APInt to_apint(const Bits& bits);

}  // namespace hlsc
