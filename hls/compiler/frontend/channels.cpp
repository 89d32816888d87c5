// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/channels.h"

#include <fmt/format.h>
#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/IRBuilder.h>

#include <map>
#include <set>
#include <tuple>

#include "error.h"
#include "frontend/port_access.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

class ChannelLowering {
 public:
  ChannelLowering(Transaction& transaction, const SourceLines& lines)
      : t_(transaction),
        lines_(lines),
        layout_(transaction.module->getDataLayout()),
        entry_(transaction.function->getEntryBlock()),
        exit_(exit_block(*transaction.function)->getTerminator()) {}

  void run() {
    std::vector<llvm::CallInst*> calls;
    for (llvm::BasicBlock* block : llvm::ReversePostOrderTraversal<llvm::Function*>(t_.function)) {
      for (llvm::Instruction& instruction : *block) {
        auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction);
        const llvm::Function* callee = call ? call->getCalledFunction() : nullptr;
        if (callee && port_access(*callee)) calls.push_back(call);
      }
    }
    for (llvm::CallInst* call : calls) {
      lower(*call);
      call->eraseFromParent();
    }
    require_tokens();
  }

 private:
  using VariableKey = std::tuple<EndpointKind, unsigned, unsigned, unsigned>;

  static llvm::BasicBlock* exit_block(llvm::Function& function) {
    for (llvm::BasicBlock& block : function) {
      if (llvm::isa<llvm::ReturnInst>(block.getTerminator())) return &block;
    }
    throw Error({}, "step() never returns");
  }

  unsigned port_of(const llvm::CallInst& call) {
    const llvm::Value* pointer = call.getArgOperand(0);
    llvm::APInt offset(layout_.getIndexTypeSizeInBits(pointer->getType()), 0);
    pointer = pointer->stripAndAccumulateConstantOffsets(layout_, offset, true);
    if (pointer == t_.unit) {
      for (unsigned i = 0; i < t_.layout.ports.size(); ++i) {
        if (t_.layout.ports[i].offset == offset.getZExtValue()) return i;
      }
    }
    throw Error(lines_.of(call), messages::kPortPointer);
  }

  static PortAccessInfo access(const llvm::CallInst& call) {
    return *port_access(*call.getCalledFunction());
  }
  static unsigned constant_argument(const llvm::CallInst& call, unsigned index) {
    return static_cast<unsigned>(
        llvm::cast<llvm::ConstantInt>(call.getArgOperand(index))->getZExtValue());
  }

  /// A variable that is handed to its sink in the exit block.
  llvm::AllocaInst* variable(Endpoint endpoint, unsigned width) {
    const VariableKey key{endpoint.kind, endpoint.index, endpoint.low, width};
    auto& known = variables_[key];
    if (known) return known;
    llvm::IRBuilder<> at_entry(&entry_, entry_.begin());
    auto* type = at_entry.getIntNTy(width);
    known = at_entry.CreateAlloca(type);
    const bool is_flag = endpoint.kind == EndpointKind::kReadEnable ||
                         endpoint.kind == EndpointKind::kWriteEnable ||
                         endpoint.kind == EndpointKind::kCheck;
    llvm::Constant* initial = llvm::PoisonValue::get(type);
    if (is_flag) initial = at_entry.getFalse();
    at_entry.CreateStore(initial, known);
    llvm::IRBuilder<> at_exit(exit_);
    at_exit.CreateCall(t_.sink(endpoint, width), {at_exit.CreateLoad(type, known)});
    return known;
  }
  llvm::AllocaInst* flag(EndpointKind kind, unsigned port) { return variable({kind, port}, 1); }

  /// Records that reaching `call` with `flag` set is an error.
  void refuse_if_set(llvm::AllocaInst* flag, const llvm::CallInst& call, const char* message,
                     const std::string& name) {
    const auto index = static_cast<unsigned>(t_.checks.size());
    t_.checks.push_back({lines_.of(call), fmt::format(fmt::runtime(message), name)});
    builder_->CreateStore(builder_->CreateLoad(builder_->getInt1Ty(), flag),
                          variable({EndpointKind::kCheck, index}, 1));
  }

  void lower(llvm::CallInst& call) {
    llvm::IRBuilder<> builder(&call);
    builder_ = &builder;
    const unsigned port = port_of(call);
    switch (access(call).access) {
      case hls::PortAccess::kGetLeaf:
        return get(call, port);
      case hls::PortAccess::kPutLeaf: {
        const Endpoint bits{EndpointKind::kWriteBits, port, constant_argument(call, 1)};
        set(bits, call.getArgOperand(2), access(call).leaf_width);
        return;
      }
      case hls::PortAccess::kGetRowLeaf:
        return row_get(call, port);
      case hls::PortAccess::kCommitToken:
        refuse_if_set(flag(EndpointKind::kWriteEnable, port), call, messages::kOutTwice,
                      name(port));
        builder.CreateStore(builder.getTrue(), flag(EndpointKind::kWriteEnable, port));
        return;
      case hls::PortAccess::kCommitRow:
        return row_commit(call, port);
    }
  }

  void set(Endpoint endpoint, llvm::Value* value, unsigned width) {
    value = builder_->CreateTrunc(value, builder_->getIntNTy(width));
    builder_->CreateStore(value, variable(endpoint, width));
  }
  /// Replaces a call by the source that it reads.
  void replace(llvm::CallInst& call, Endpoint source) {
    llvm::Value* value = builder_->CreateCall(t_.source(source, access(call).leaf_width));
    call.replaceAllUsesWith(builder_->CreateZExt(value, call.getType()));
  }

  const std::string& name(unsigned port) const { return t_.layout.ports[port].port.name; }

  void get(llvm::CallInst& call, unsigned port) {
    const bool token = t_.layout.ports[port].port.kind == PortKind::kIn;
    const Endpoint source{token ? EndpointKind::kToken : EndpointKind::kConfig, port,
                          constant_argument(call, 1)};
    if (token) {
      // One variable per leaf: a second read fetches the same leaf again.
      llvm::AllocaInst*& read = leaf_read_[{port, source.low}];
      if (!read) read = local_flag();
      refuse_if_set(read, call, messages::kInTwice, name(port));
      builder_->CreateStore(builder_->getTrue(), read);
      first_read_.emplace(port, std::make_pair(read, lines_.of(call)));
    }
    replace(call, source);
  }

  /// A flag that is not handed to any sink.
  llvm::AllocaInst* local_flag() {
    llvm::IRBuilder<> at_entry(&entry_, entry_.begin());
    auto* made = at_entry.CreateAlloca(at_entry.getInt1Ty());
    at_entry.CreateStore(at_entry.getFalse(), made);
    return made;
  }

  void row_get(llvm::CallInst& call, unsigned port) {
    llvm::Value* address = call.getArgOperand(1);
    const unsigned low = constant_argument(call, 2);
    auto* enable = flag(EndpointKind::kReadEnable, port);
    if (begins_read(call, port, address, low)) {
      refuse_if_set(enable, call, messages::kRowReadTwice, name(port));
      const PortKind kind = t_.layout.ports[port].port.kind;
      if (kind == PortKind::kRam || kind == PortKind::kRegisterFile) {
        refuse_if_set(flag(EndpointKind::kWriteEnable, port), call, messages::kReadAfterWrite,
                      name(port));
      }
      builder_->CreateStore(builder_->getTrue(), enable);
      set({EndpointKind::kReadAddress, port}, address, access(call).address_width);
    }
    replace(call, {EndpointKind::kRow, port, low});
  }

  /// The leaves of one read() follow each other in one block, with one address; a leaf that comes a
  /// second time, another address or another block is another read().
  bool begins_read(const llvm::CallInst& call, unsigned port, const llvm::Value* address,
                   unsigned low) {
    CurrentRead& current = current_read_[port];
    if (current.block == call.getParent() && current.address == address &&
        current.leaves.insert(low).second) {
      return false;
    }
    current = {call.getParent(), address, {low}};
    return true;
  }

  void row_commit(llvm::CallInst& call, unsigned port) {
    llvm::Value* address = call.getArgOperand(1);
    auto* enable = flag(EndpointKind::kWriteEnable, port);
    refuse_if_set(enable, call, messages::kRowWrittenTwice, name(port));
    builder_->CreateStore(builder_->getTrue(), enable);
    set({EndpointKind::kWriteAddress, port}, address, access(call).address_width);
  }

  /// Every In is read, and on every path.
  void require_tokens() {
    for (unsigned port = 0; port < t_.layout.ports.size(); ++port) {
      const Port& in = t_.layout.ports[port].port;
      if (in.kind != PortKind::kIn) continue;
      const auto found = first_read_.find(port);
      if (found == first_read_.end()) {
        throw Error(in.where, fmt::format(messages::kInNever, in.name));
      }
      llvm::IRBuilder<> at_exit(exit_);
      const auto index = static_cast<unsigned>(t_.checks.size());
      t_.checks.push_back({found->second.second, fmt::format(messages::kInConditional, in.name)});
      llvm::Value* read = at_exit.CreateLoad(at_exit.getInt1Ty(), found->second.first);
      at_exit.CreateCall(t_.sink({EndpointKind::kCheck, index}, 1), {at_exit.CreateNot(read)});
    }
  }

  struct CurrentRead {
    const llvm::BasicBlock* block = nullptr;
    const llvm::Value* address = nullptr;
    std::set<unsigned> leaves;
  };

  Transaction& t_;
  const SourceLines& lines_;
  const llvm::DataLayout& layout_;
  llvm::BasicBlock& entry_;
  llvm::Instruction* exit_;
  llvm::IRBuilder<>* builder_ = nullptr;
  std::map<VariableKey, llvm::AllocaInst*> variables_;
  std::map<std::pair<unsigned, unsigned>, llvm::AllocaInst*> leaf_read_;
  std::map<unsigned, std::pair<llvm::AllocaInst*, SourceLine>> first_read_;
  std::map<unsigned, CurrentRead> current_read_;
};

}  // namespace

void lower_channels(Transaction& transaction, const SourceLines& lines) {
  ChannelLowering(transaction, lines).run();
}

void require_checks(Transaction& transaction) {
  std::vector<llvm::Instruction*> passed;
  const Check* failed = nullptr;
  unsigned first = ~0u;
  for (llvm::BasicBlock& block : *transaction.function) {
    for (llvm::Instruction& instruction : block) {
      const Endpoint* endpoint = transaction.endpoint_of(instruction);
      if (!endpoint || endpoint->kind != EndpointKind::kCheck) continue;
      const auto* value = llvm::dyn_cast<llvm::Constant>(instruction.getOperand(0));
      if (value && (value->isNullValue() || llvm::isa<llvm::UndefValue>(value))) {
        passed.push_back(&instruction);
      } else if (endpoint->index < first) {
        first = endpoint->index;
        failed = &transaction.checks[first];
      }
    }
  }
  if (failed) throw Error(failed->where, failed->message);
  for (llvm::Instruction* instruction : passed) instruction->eraseFromParent();
}

}  // namespace hlsc
