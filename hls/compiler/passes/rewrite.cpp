// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "passes/rewrite.h"

#include <stdexcept>

#include "netlist/op.h"

namespace hlsc {

Rewrite::Rewrite(const Netlist& from) : from_(from), builder_(to_) {
  to_.module = from.module;
  to_.unit = from.unit;
  to_.source = from.source;
  to_.ports = from.ports;
  to_.registers = from.registers;
}

Netlist Rewrite::run() {
  std::vector<NodeId> made;
  for (const Node& node : from_.nodes) {
    std::vector<NodeId> operands;
    for (const NodeId operand : node.operands) operands.push_back(made[operand]);
    builder_.set_line(node.where);
    made.push_back(make(node, operands));
    if (!node.name.empty()) builder_.name(made.back(), node.name);
  }
  for (const TokenWrite& w : from_.token_writes) {
    to_.token_writes.push_back({w.port, made[w.enable], made[w.data]});
  }
  for (const RowRead& r : from_.row_reads) {
    to_.row_reads.push_back({r.port, made[r.enable], made[r.address]});
  }
  for (const RowWrite& w : from_.row_writes) {
    to_.row_writes.push_back({w.port, made[w.enable], made[w.address], made[w.data]});
  }
  for (Register& r : to_.registers) {
    if (r.next != kNoNode) r.next = made[r.next];
  }
  return std::move(to_);
}

NodeId Rewrite::make(const Node& n, const std::vector<NodeId>& v) {
  switch (n.op) {
    case Op::kConst:
      return builder_.constant(to_apint(n.value));
    case Op::kToken:
    case Op::kConfig:
    case Op::kRegister:
    case Op::kRow:
      return builder_.source(n.op, n.port, n.low, n.width);
    case Op::kAdd:
      return builder_.add(v[0], v[1]);
    case Op::kSub:
      return builder_.sub(v[0], v[1]);
    case Op::kMul:
      return builder_.mul(builder_.zext(v[0], n.width), builder_.zext(v[1], n.width));
    case Op::kUDiv:
      return builder_.udiv(v[0], v[1]);
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
      return builder_.logic(n.op, v[0], v[1]);
    case Op::kNot:
      return builder_.invert(v[0]);
    case Op::kShl:
    case Op::kLShr:
    case Op::kAShr:
      return builder_.shift(n.op, v[0], v[1]);
    case Op::kEq:
      return builder_.equal(v[0], v[1]);
    case Op::kULt:
    case Op::kSLt:
      return builder_.less(n.op, v[0], v[1]);
    case Op::kMux:
      return builder_.mux(v[0], v[1], v[2]);
    case Op::kSlice:
      return builder_.slice(v[0], n.low, n.width);
    case Op::kConcat:
      return builder_.concat(v);
    case Op::kSExt:
      return builder_.sext(v[0], n.width);
    case Op::kClz:
      return builder_.clz(v[0], n.width);
    case Op::kAddSub:
      break;
  }
  throw std::logic_error("rewrite: add-subtract nodes are made after all rewriting");
}

}  // namespace hlsc
