// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The base of the passes that replace nodes: copies a netlist node by node through a Builder, which
// folds, shares and narrows, and lets a pass replace a node.
#pragma once

#include <vector>

#include "netlist/builder.h"
#include "netlist/netlist.h"

namespace hlsc {

class Rewrite {
 public:
  explicit Rewrite(const Netlist& from);
  virtual ~Rewrite() = default;
  Rewrite(const Rewrite&) = delete;
  Rewrite& operator=(const Rewrite&) = delete;

  Netlist run();

 protected:
  /// Makes the replacement of `node`, with these operands in the new netlist; by default a copy.
  virtual NodeId make(const Node& node, const std::vector<NodeId>& operands);
  const Node& node(NodeId id) const { return to_.nodes[id]; }
  bool is_zero(NodeId id) const { return builder_.known(id).isZero(); }
  /// AND, OR or equality with zero, as the builder makes them.
  NodeId both(NodeId a, NodeId b) { return builder_.logic(Op::kAnd, a, b); }
  NodeId zero_test(NodeId a) { return builder_.equal(a, builder_.constant(builder_.width(a), 0)); }

  const Netlist& from_;
  Netlist to_;
  Builder builder_;
};

}  // namespace hlsc
