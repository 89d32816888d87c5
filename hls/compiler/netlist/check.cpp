// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "netlist/names.h"
#include "netlist/netlist.h"

namespace hlsc {
namespace {

class Checker {
 public:
  explicit Checker(const Netlist& net) : net_(net) {}

  void run() {
    for (NodeId id = 0; id < net_.nodes.size(); ++id) node(id);
    std::set<unsigned> reads;
    std::set<unsigned> writes;
    for (const RowRead& read : net_.row_reads) {
      require(reads.insert(port(read.port)).second, "a RAM port has two reads");
      value(read.enable, 1);
      require(read.address < net_.nodes.size(), "a read has no address");
    }
    for (const RowWrite& write : net_.row_writes) {
      require(writes.insert(port(write.port)).second, "a RAM port has two writes");
      value(write.enable, 1);
      value(write.data, net_.ports[write.port].width);
      require(write.address < net_.nodes.size(), "a write has no address");
    }
    for (const TokenWrite& write : net_.token_writes) {
      require(writes.insert(port(write.port)).second, "an Out has two writes");
      value(write.enable, 1);
      value(write.data, net_.ports[write.port].width);
    }
    for (const Register& state : net_.registers) {
      require(state.reset.width() == state.width, "a reset value has another width");
      if (state.next != kNoNode) value(state.next, state.width);
    }
  }

 private:
  void require(bool holds, const char* what) const {
    if (!holds) throw std::logic_error(fmt::format("netlist of {}: {} ({})", net_.unit, what, at_));
  }
  unsigned port(unsigned index) const {
    require(index < net_.ports.size(), "a port that does not exist");
    return index;
  }
  void value(NodeId id, unsigned width) const {
    require(id < net_.nodes.size(), "a value that does not exist");
    require(net_.nodes[id].width == width, "a value of the wrong width");
  }

  void node(NodeId id) {
    const Node& n = net_.nodes[id];
    at_ = fmt::format("node %{} {}", id, op_name(n.op));
    require(n.width > 0, "a node without bits");
    for (NodeId operand : n.operands) require(operand < id, "an operand after its user");
    const auto width = [&](unsigned i) { return net_.nodes[n.operands[i]].width; };
    const auto arity = [&](std::size_t count) {
      require(n.operands.size() == count, "a wrong number of operands");
    };
    switch (n.op) {
      case Op::kConst:
        require(n.value.width() == n.width, "a constant of another width");
        return arity(0);
      case Op::kToken:
      case Op::kConfig:
        require(n.low + n.width <= net_.ports[port(n.port)].width, "bits beyond the port's");
        return arity(0);
      case Op::kRow:
        require(n.port < net_.row_reads.size(), "a row that is not read");
        require(n.low + n.width <= net_.ports[net_.row_reads[n.port].port].width,
                "bits beyond the row's");
        return arity(0);
      case Op::kRegister:
        require(n.port < net_.registers.size(), "a register that does not exist");
        require(n.width == net_.registers[n.port].width, "a register of another width");
        return arity(0);
      case Op::kAdd:
      case Op::kSub:
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
        arity(2);
        return require(width(0) == n.width && width(1) == n.width, "operands of another width");
      case Op::kAddSub:
        arity(3);
        return require(width(0) == n.width && width(1) == n.width && width(2) == 1,
                       "operands of another width");
      case Op::kMul:
        return arity(2);
      case Op::kUDiv:
      case Op::kShl:
      case Op::kLShr:
      case Op::kAShr:
        arity(2);
        return require(width(0) == n.width, "an operand of another width");
      case Op::kEq:
      case Op::kULt:
      case Op::kSLt:
        arity(2);
        return require(n.width == 1 && width(0) == width(1), "operands of another width");
      case Op::kMux:
        arity(3);
        return require(width(0) == 1 && width(1) == n.width && width(2) == n.width,
                       "operands of another width");
      case Op::kNot:
        arity(1);
        return require(width(0) == n.width, "an operand of another width");
      case Op::kSlice:
        arity(1);
        return require(n.low + n.width <= width(0), "bits beyond the operand's");
      case Op::kSExt:
        arity(1);
        return require(width(0) <= n.width, "an extension that narrows");
      case Op::kClz:
        return arity(1);
      case Op::kConcat: {
        unsigned sum = 0;
        for (unsigned i = 0; i < n.operands.size(); ++i) sum += width(i);
        return require(sum == n.width, "parts of another width");
      }
    }
  }

  const Netlist& net_;
  std::string at_;
};

}  // namespace

void check(const Netlist& netlist) { Checker(netlist).run(); }

}  // namespace hlsc
