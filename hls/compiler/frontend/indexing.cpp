// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/indexing.h"

#include <llvm/ADT/MapVector.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <map>
#include <optional>

#include "error.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

/// The outermost variable step on the way from an access to its object: a GEP with a variable index
/// or a selection between two pointers.
struct VariableStep {
  llvm::Instruction* instruction = nullptr;
  std::uint64_t offset = 0;  ///< constant bytes between the step's pointer and the access
};

class Expansion {
 public:
  Expansion(Transaction& transaction, const SourceLines& lines)
      : function_(*transaction.function),
        layout_(transaction.module->getDataLayout()),
        lines_(lines) {}

  bool run() {
    bool changed = false;
    std::vector<llvm::Instruction*> accesses;
    for (llvm::Instruction& instruction : llvm::instructions(function_)) {
      if (llvm::isa<llvm::LoadInst, llvm::StoreInst, llvm::MemIntrinsic>(instruction)) {
        accesses.push_back(&instruction);
      }
    }
    for (llvm::Instruction* access : accesses) {
      bool done = false;
      if (auto* load = llvm::dyn_cast<llvm::LoadInst>(access)) {
        done = expand_load(*load);
      } else if (auto* store = llvm::dyn_cast<llvm::StoreInst>(access)) {
        done = expand_store(*store);
      } else {
        done = split_memory_intrinsic(*llvm::cast<llvm::MemIntrinsic>(access));
      }
      if (done) access->eraseFromParent();
      changed = changed || done;
    }
    return changed;
  }

 private:
  std::optional<VariableStep> variable_step(llvm::Value* pointer) const {
    VariableStep step;
    for (;;) {
      if (auto* select = llvm::dyn_cast<llvm::SelectInst>(pointer)) {
        step.instruction = select;
        return step;
      }
      auto* gep = llvm::dyn_cast<llvm::GEPOperator>(pointer);
      if (!gep) return std::nullopt;
      llvm::APInt offset(64, 0);
      if (!gep->accumulateConstantOffset(layout_, offset)) {
        step.instruction = llvm::cast<llvm::Instruction>(gep);
        return step;
      }
      step.offset += offset.getZExtValue();
      pointer = gep->getPointerOperand();
    }
  }

  /// One index value and the pointer it leads to.
  using Targets = std::map<std::uint64_t, llvm::Value*>;
  struct Indexed {
    llvm::Value* index = nullptr;
    Targets targets;
  };

  static llvm::Value* behind(llvm::IRBuilder<>& builder, llvm::Value* pointer,
                             std::uint64_t bytes) {
    return bytes == 0 ? pointer : builder.CreateConstGEP1_64(builder.getInt8Ty(), pointer, bytes);
  }

  /// Bytes of the local variable or constant that a pointer leads into; 0 if it is neither.
  std::uint64_t object_size(const llvm::Value* pointer) const {
    const llvm::Value* object = llvm::getUnderlyingObject(pointer, 0);
    if (const auto* local = llvm::dyn_cast<llvm::AllocaInst>(object)) {
      const auto size = local->getAllocationSize(layout_);
      return size ? size->getFixedValue() : 0;
    }
    if (const auto* global = llvm::dyn_cast<llvm::GlobalVariable>(object)) {
      return layout_.getTypeAllocSize(global->getValueType()).getFixedValue();
    }
    return 0;
  }

  /// The pointers that a step can lead to, each with the value of its first variable index.
  Indexed targets(llvm::IRBuilder<>& builder, const VariableStep& step) const {
    Indexed result;
    if (auto* select = llvm::dyn_cast<llvm::SelectInst>(step.instruction)) {
      result.index = select->getCondition();
      result.targets[1] = behind(builder, select->getTrueValue(), step.offset);
      result.targets[0] = behind(builder, select->getFalseValue(), step.offset);
      return result;
    }
    auto* gep = llvm::cast<llvm::GetElementPtrInst>(step.instruction);
    const std::uint64_t size = object_size(gep->getPointerOperand());
    if (size == 0) throw Error(lines_.of(*gep), messages::kPointer);
    auto type = llvm::gep_type_begin(*gep);
    for (unsigned operand = 1; operand < gep->getNumOperands(); ++operand, ++type) {
      if (llvm::isa<llvm::ConstantInt>(gep->getOperand(operand))) continue;
      result.index = gep->getOperand(operand);
      const std::uint64_t stride = type.getSequentialElementStride(layout_).getFixedValue();
      const std::uint64_t count =
          std::min(element_count(*gep, operand, size, stride), largest_index(*result.index) + 1);
      for (std::uint64_t i = 0; i < count; ++i) {
        auto* fixed = llvm::cast<llvm::GetElementPtrInst>(gep->clone());
        fixed->setOperand(operand, llvm::ConstantInt::get(result.index->getType(), i));
        builder.Insert(fixed);
        result.targets[i] = behind(builder, fixed, step.offset);
      }
      return result;
    }
    throw Error(lines_.of(*gep), messages::kPointer);
  }

  /// An index into an array has the array's bound; one of a bare pointer the object's.
  static std::uint64_t element_count(const llvm::GetElementPtrInst& gep, unsigned operand,
                                     std::uint64_t size, std::uint64_t stride) {
    const std::uint64_t whole = stride == 0 ? 1 : (size + stride - 1) / stride;
    if (operand == 1) return whole;
    const llvm::SmallVector<llvm::Value*, 4> before(gep.idx_begin(), gep.idx_begin() + operand - 1);
    const auto* array = llvm::dyn_cast<llvm::ArrayType>(
        llvm::GetElementPtrInst::getIndexedType(gep.getSourceElementType(), before));
    return array ? std::min(array->getNumElements(), whole) : whole;
  }

  std::uint64_t largest_index(const llvm::Value& index) const {
    const auto known = llvm::computeKnownBits(&index, layout_);
    return std::min<std::uint64_t>(known.getMaxValue().getLimitedValue(), ~std::uint64_t{0} - 1);
  }

  /// The value at `index` among `values`: a tree over the index's bits, the lowest at the leaves.
  llvm::Value* choose(llvm::IRBuilder<>& builder, llvm::Value* index,
                      const std::map<std::uint64_t, llvm::Value*>& values, unsigned bit) const {
    if (values.size() == 1) return values.begin()->second;
    std::map<std::uint64_t, llvm::Value*> low;
    std::map<std::uint64_t, llvm::Value*> high;
    for (const auto& [i, value] : values) ((i >> bit) & 1 ? high : low).emplace(i, value);
    if (low.empty()) return choose(builder, index, high, bit - 1);
    if (high.empty()) return choose(builder, index, low, bit - 1);
    llvm::Value* no = choose(builder, index, low, bit - 1);
    llvm::Value* yes = choose(builder, index, high, bit - 1);
    if (yes == no) return yes;
    llvm::Value* chosen = builder.CreateTrunc(builder.CreateLShr(index, bit), builder.getInt1Ty());
    return builder.CreateSelect(chosen, yes, no);
  }

  static unsigned top_bit(const Targets& targets) {
    return targets.rbegin()->first == 0 ? 0 : llvm::Log2_64(targets.rbegin()->first);
  }

  bool expand_load(llvm::LoadInst& load) {
    const auto step = variable_step(load.getPointerOperand());
    if (!step) return false;
    llvm::IRBuilder<> builder(&load);
    const Indexed at = targets(builder, *step);
    std::map<std::uint64_t, llvm::Value*> values;
    for (const auto& [i, pointer] : at.targets) {
      if (is_null(pointer)) continue;
      values[i] = builder.CreateAlignedLoad(load.getType(), pointer, llvm::Align(1));
    }
    llvm::Value* value = values.empty() ? llvm::PoisonValue::get(load.getType())
                                        : choose(builder, at.index, values, top_bit(at.targets));
    load.replaceAllUsesWith(value);
    return true;
  }

  bool expand_store(llvm::StoreInst& store) {
    const auto step = variable_step(store.getPointerOperand());
    if (!step) return false;
    llvm::IRBuilder<> builder(&store);
    const Indexed at = targets(builder, *step);
    llvm::Value* value = store.getValueOperand();
    // The bits that tell the elements apart: an index beyond them would be undefined.
    const unsigned bits = top_bit(at.targets) + 1;
    llvm::Value* index = at.index;
    if (bits < index->getType()->getIntegerBitWidth()) {
      index = builder.CreateTrunc(index, builder.getIntNTy(bits));
    }
    for (const auto& [i, pointer] : at.targets) {
      if (is_null(pointer)) continue;
      llvm::Value* here = builder.CreateICmpEQ(index, llvm::ConstantInt::get(index->getType(), i));
      llvm::Value* old = builder.CreateAlignedLoad(value->getType(), pointer, llvm::Align(1));
      builder.CreateAlignedStore(builder.CreateSelect(here, value, old), pointer, llvm::Align(1));
    }
    return true;
  }

  static bool is_null(const llvm::Value* pointer) {
    return llvm::isa<llvm::ConstantPointerNull>(pointer->stripPointerCasts());
  }

  /// A copy or fill at a variable place becomes loads and stores of aligned words.
  bool split_memory_intrinsic(llvm::MemIntrinsic& memory) {
    auto* transfer = llvm::dyn_cast<llvm::MemTransferInst>(&memory);
    const bool variable = variable_step(memory.getRawDest()).has_value() ||
                          (transfer && variable_step(transfer->getRawSource()).has_value());
    const auto* length = llvm::dyn_cast<llvm::ConstantInt>(memory.getLength());
    if (!variable || !length) return false;
    std::uint64_t word = memory.getDestAlign().valueOrOne().value();
    if (transfer) word = std::min(word, transfer->getSourceAlign().valueOrOne().value());
    word = std::min<std::uint64_t>(word, 8);
    llvm::IRBuilder<> builder(&memory);
    std::vector<std::pair<std::uint64_t, llvm::Value*>> words;
    for (std::uint64_t at = 0; at < length->getZExtValue();) {
      while (at + word > length->getZExtValue()) word /= 2;
      auto* type = builder.getIntNTy(static_cast<unsigned>(word * 8));
      words.emplace_back(at, word_of(builder, memory, transfer, at, type));
      at += word;
    }
    for (const auto& [at, value] : words) {
      builder.CreateAlignedStore(value, behind(builder, memory.getRawDest(), at), llvm::Align(1));
    }
    return true;
  }

  static llvm::Value* word_of(llvm::IRBuilder<>& builder, llvm::MemIntrinsic& memory,
                              llvm::MemTransferInst* transfer, std::uint64_t at,
                              llvm::IntegerType* type) {
    if (transfer) {
      return builder.CreateAlignedLoad(type, behind(builder, transfer->getRawSource(), at),
                                       llvm::Align(1));
    }
    llvm::Value* byte = builder.CreateZExt(llvm::cast<llvm::MemSetInst>(memory).getValue(), type);
    const auto ones = llvm::APInt::getSplat(type->getBitWidth(), llvm::APInt(8, 1));
    return builder.CreateMul(byte, llvm::ConstantInt::get(type, ones));
  }

  llvm::Function& function_;
  const llvm::DataLayout& layout_;
  const SourceLines& lines_;
};

}  // namespace

bool expand_indexing(Transaction& transaction, const SourceLines& lines) {
  return Expansion(transaction, lines).run();
}

}  // namespace hlsc
