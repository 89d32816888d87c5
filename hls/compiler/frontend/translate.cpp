// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/translate.h"

#include <fmt/format.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "error.h"
#include "frontend/refusal_messages.h"
#include "frontend/translate_operation.h"
#include "frontend/value_names.h"
#include "netlist/builder.h"

namespace hlsc {
namespace {

/// The sinks of one port, until all are seen.
struct PortUse {
  NodeId read_enable = kNoNode;
  NodeId read_address = kNoNode;
  NodeId write_enable = kNoNode;
  NodeId write_address = kNoNode;
  std::map<unsigned, NodeId> bits;  ///< by lowest bit
};

class Translation {
 public:
  Translation(const Transaction& transaction, const std::vector<llvm::APInt>& resets,
              const SourceLines& lines)
      : t_(transaction), lines_(lines), builder_(net_) {
    for (const PortMember& member : t_.layout.ports) net_.ports.push_back(member.port);
    for (std::size_t i = 0; i < t_.layout.registers.size(); ++i) {
      const RegisterMember& member = t_.layout.registers[i];
      net_.registers.push_back(
          {member.name, member.width, to_bits(resets[i]), kNoNode, member.where});
    }
    uses_.resize(net_.ports.size());
  }

  Netlist run() {
    number_row_reads();
    for (const llvm::Instruction& instruction : t_.function->front()) {
      builder_.set_line(lines_.of(instruction));
      visit(instruction);
    }
    builder_.set_line({});
    for (unsigned port = 0; port < uses_.size(); ++port) finish(port, uses_[port]);
    return std::move(net_);
  }

 private:
  /// kRow nodes name their row read, so reads are numbered before any node is made.
  void number_row_reads() {
    for (const llvm::Instruction& instruction : t_.function->front()) {
      const Endpoint* endpoint = t_.endpoint_of(instruction);
      if (endpoint && endpoint->kind == EndpointKind::kReadEnable) {
        read_number_.emplace(endpoint->index, static_cast<unsigned>(read_number_.size()));
      }
    }
    net_.row_reads.resize(read_number_.size());
  }

  NodeId value(const llvm::Value* v) {
    const auto found = values_.find(v);
    if (found != values_.end()) return found->second;
    const unsigned width = v->getType()->getIntegerBitWidth();
    if (const auto* constant = llvm::dyn_cast<llvm::ConstantInt>(v)) {
      return builder_.constant(constant->getValue());
    }
    if (llvm::isa<llvm::UndefValue>(v)) return builder_.constant(width, 0);
    throw std::logic_error("a value without a definition in the flat block");
  }

  void visit(const llvm::Instruction& instruction) {
    if (instruction.isTerminator()) return;
    if (const Endpoint* endpoint = t_.endpoint_of(instruction)) {
      return visit_endpoint(*endpoint, llvm::cast<llvm::CallInst>(instruction));
    }
    if (instruction.getType()->isVoidTy() && !instruction.mayWriteToMemory()) return;
    const auto node = translate_operation(instruction, builder_,
                                          [this](const llvm::Value* v) { return value(v); });
    if (!node) refuse(instruction);
    define(instruction, *node);
  }

  void define(const llvm::Instruction& instruction, NodeId node) {
    values_[&instruction] = node;
    const std::string name = value_name(instruction);
    if (!name.empty()) builder_.name(node, name);
  }

  [[noreturn]] void refuse(const llvm::Instruction& instruction) const {
    if (llvm::isa<llvm::LoadInst, llvm::StoreInst, llvm::AllocaInst, llvm::GetElementPtrInst,
                  llvm::MemIntrinsic, llvm::PtrToIntInst, llvm::IntToPtrInst>(instruction) ||
        instruction.getType()->isPointerTy()) {
      throw Error(lines_.of(instruction), messages::kPointer);
    }
    std::string name = instruction.getOpcodeName();
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction)) {
      if (const llvm::Function* callee = call->getCalledFunction()) name = callee->getName().str();
    }
    throw Error(lines_.of(instruction), fmt::format(messages::kOperation, name));
  }

  void visit_endpoint(const Endpoint& e, const llvm::CallInst& call) {
    const bool is_source = call.arg_size() == 0;
    if (is_source) {
      static const std::map<EndpointKind, Op> kOps = {{EndpointKind::kToken, Op::kToken},
                                                      {EndpointKind::kConfig, Op::kConfig},
                                                      {EndpointKind::kRow, Op::kRow},
                                                      {EndpointKind::kRegister, Op::kRegister}};
      const unsigned index = e.kind == EndpointKind::kRow ? read_number_.at(e.index) : e.index;
      return define(call, builder_.source(kOps.at(e.kind), index, e.low,
                                          call.getType()->getIntegerBitWidth()));
    }
    const NodeId node = value(call.getArgOperand(0));
    switch (e.kind) {
      case EndpointKind::kReadEnable:
        uses_[e.index].read_enable = node;
        return;
      case EndpointKind::kReadAddress:
        uses_[e.index].read_address = node;
        return;
      case EndpointKind::kWriteEnable:
        uses_[e.index].write_enable = node;
        return;
      case EndpointKind::kWriteAddress:
        uses_[e.index].write_address = node;
        return;
      case EndpointKind::kWriteBits:
        uses_[e.index].bits[e.low] = node;
        return;
      case EndpointKind::kNext:
        next(net_.registers[e.index], e.index, node);
        return;
      default:
        return;
    }
  }

  void next(Register& state, unsigned index, NodeId node) {
    if (node != builder_.source(Op::kRegister, index, 0, state.width)) state.next = node;
  }

  /// The token or row: its leaves, and zeros where it has none.
  NodeId data(const PortUse& use, unsigned width) {
    std::vector<NodeId> parts;
    unsigned filled = 0;
    for (const auto& [low, node] : use.bits) {
      if (low > filled) parts.insert(parts.begin(), builder_.constant(low - filled, 0));
      parts.insert(parts.begin(), node);
      filled = low + builder_.width(node);
    }
    if (filled < width) parts.insert(parts.begin(), builder_.constant(width - filled, 0));
    return builder_.concat(parts);
  }

  void finish(unsigned port, const PortUse& use) {
    if (use.read_enable != kNoNode) {
      net_.row_reads[read_number_.at(port)] = {port, use.read_enable, use.read_address};
    }
    // A RAM that is only read has an enable too: the check for a read after a write asks for it.
    const bool is_out = net_.ports[port].kind == PortKind::kOut;
    if (use.write_enable == kNoNode || (!is_out && use.write_address == kNoNode)) return;
    const NodeId written = data(use, net_.ports[port].width);
    if (is_out) {
      net_.token_writes.push_back({port, use.write_enable, written});
    } else {
      net_.row_writes.push_back({port, use.write_enable, use.write_address, written});
    }
  }

  const Transaction& t_;
  const SourceLines& lines_;
  Netlist net_;
  Builder builder_;
  llvm::DenseMap<const llvm::Value*, NodeId> values_;
  std::map<unsigned, unsigned> read_number_;
  std::vector<PortUse> uses_;
};

}  // namespace

Netlist translate(const Transaction& transaction, const std::vector<llvm::APInt>& resets,
                  const SourceLines& lines) {
  return Translation(transaction, resets, lines).run();
}

}  // namespace hlsc
