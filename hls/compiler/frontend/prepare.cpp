// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/prepare.h"

#include <fmt/format.h>
#include <llvm/ADT/STLExtras.h>
#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/TargetParser/Triple.h>

#include "error.h"
#include "frontend/compile_unit.h"
#include "frontend/port_access.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

/// The layout without its list of native integer widths, so that no pass widens to them.
std::string without_native_widths(llvm::StringRef layout) {
  std::string kept;
  llvm::SmallVector<llvm::StringRef> parts;
  layout.split(parts, '-');
  for (llvm::StringRef part : parts) {
    if (part.starts_with("n") && !part.starts_with("ni")) continue;
    if (!kept.empty()) kept += '-';
    kept += part.str();
  }
  return kept;
}

void strip_call_attributes(llvm::CallBase& call) {
  call.removeRetAttr(llvm::Attribute::NoUndef);
  for (unsigned i = 0; i < call.arg_size(); ++i) call.removeParamAttr(i, llvm::Attribute::NoUndef);
  call.removeFnAttr(llvm::Attribute::NoInline);
}

void declare_port_access(llvm::Function& function) {
  function.setDoesNotThrow();
  function.setWillReturn();
  function.setMemoryEffects(llvm::MemoryEffects::inaccessibleMemOnly());
  function.addParamAttr(0, llvm::Attribute::NoCapture);
  function.addParamAttr(0, llvm::Attribute::ReadNone);
}

/// An integer whose width is not that of its place in memory (i96 in 16 bytes) is stored and loaded
/// as the whole place: SROA does not promote places of which only a part is ever written. Up to 64
/// bits clang does so itself, and an odd integer (i48) is a struct of that size, passed as one.
void fill_storage(llvm::Instruction& instruction, const llvm::DataLayout& layout) {
  auto* local = llvm::dyn_cast<llvm::AllocaInst>(&instruction);
  llvm::Type* type = local ? local->getAllocatedType() : llvm::getLoadStoreType(&instruction);
  if (!type->isIntegerTy() || type->getIntegerBitWidth() <= 64) return;
  const auto bits = static_cast<unsigned>(layout.getTypeAllocSizeInBits(type).getFixedValue());
  if (bits == type->getIntegerBitWidth()) return;
  llvm::IRBuilder<> builder(&instruction);
  llvm::Type* whole = builder.getIntNTy(bits);
  if (local) {
    local->setAllocatedType(whole);
    return;
  }
  if (auto* store = llvm::dyn_cast<llvm::StoreInst>(&instruction)) {
    store->setOperand(0, builder.CreateZExt(store->getValueOperand(), whole));
    return;
  }
  auto* load = llvm::cast<llvm::LoadInst>(&instruction);
  llvm::Value* place =
      builder.CreateAlignedLoad(whole, load->getPointerOperand(), load->getAlign());
  load->replaceAllUsesWith(builder.CreateTrunc(place, type));
  load->eraseFromParent();
}

/// The initial value of a register, out of the constant unit.
llvm::Constant* initial_value(const Transaction& transaction, const RegisterMember& member) {
  auto* initial = transaction.module->getGlobalVariable(kInitialUnit);
  auto* type = llvm::IntegerType::get(*transaction.context, member.storage_bits);
  return llvm::ConstantFoldLoadFromConst(initial->getInitializer(), type,
                                         llvm::APInt(64, member.offset),
                                         transaction.module->getDataLayout());
}

}  // namespace

void detach_from_target(llvm::Module& module) {
  module.setDataLayout(without_native_widths(module.getDataLayoutStr()));
  module.setTargetTriple("");
  for (llvm::Function& function : module) {
    for (const char* attribute : {"target-cpu", "target-features", "tune-cpu",
                                  "min-legal-vector-width", "stack-protector-buffer-size"}) {
      function.removeFnAttr(attribute);
    }
    function.removeRetAttr(llvm::Attribute::NoUndef);
    for (unsigned i = 0; i < function.arg_size(); ++i) {
      function.removeParamAttr(i, llvm::Attribute::NoUndef);
    }
    if (port_access(function)) declare_port_access(function);
    if (function.isDeclaration()) continue;
    function.removeFnAttr(llvm::Attribute::NoInline);
    function.removeFnAttr(llvm::Attribute::OptimizeNone);
    function.removeFnAttr(llvm::Attribute::OptimizeForSize);
    function.addFnAttr(llvm::Attribute::AlwaysInline);
    function.setComdat(nullptr);
    function.setLinkage(llvm::GlobalValue::InternalLinkage);
    for (llvm::Instruction& instruction :
         llvm::make_early_inc_range(llvm::instructions(function))) {
      if (llvm::isa<llvm::LifetimeIntrinsic>(instruction)) {
        instruction.eraseFromParent();
      } else if (llvm::isa<llvm::AllocaInst, llvm::LoadInst, llvm::StoreInst>(instruction)) {
        fill_storage(instruction, module.getDataLayout());
      } else if (auto* call = llvm::dyn_cast<llvm::CallBase>(&instruction)) {
        strip_call_attributes(*call);
        const llvm::Function* callee = call->getCalledFunction();
        if (callee && port_access(*callee)) call->addFnAttr(llvm::Attribute::NoMerge);
      }
    }
  }
}

void build_transaction(Transaction& transaction) {
  llvm::Module& module = *transaction.module;
  llvm::Function* step = module.getFunction(kStepFunction);
  step->setLinkage(llvm::GlobalValue::ExternalLinkage);
  step->removeFnAttr(llvm::Attribute::AlwaysInline);
  transaction.function = step;

  llvm::BasicBlock& entry = step->getEntryBlock();
  llvm::IRBuilder<> builder(&entry, entry.begin());
  auto* unit_type = module.getGlobalVariable(kInitialUnit)->getValueType();
  transaction.unit = builder.CreateAlloca(unit_type, nullptr, "unit");
  step->getArg(0)->replaceAllUsesWith(transaction.unit);
  const auto place = [&](const RegisterMember& member) {
    return builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), transaction.unit, member.offset);
  };
  for (unsigned i = 0; i < transaction.layout.registers.size(); ++i) {
    const RegisterMember& member = transaction.layout.registers[i];
    llvm::Value* value =
        builder.CreateCall(transaction.source({EndpointKind::kRegister, i}, member.width));
    auto* storage = builder.getIntNTy(member.storage_bits);
    value =
        member.is_signed ? builder.CreateSExt(value, storage) : builder.CreateZExt(value, storage);
    builder.CreateStore(value, place(member));
  }
  builder.SetInsertPoint(entry.getTerminator());
  for (unsigned i = 0; i < transaction.layout.registers.size(); ++i) {
    const RegisterMember& member = transaction.layout.registers[i];
    llvm::Value* value = builder.CreateLoad(builder.getIntNTy(member.storage_bits), place(member));
    value = builder.CreateTrunc(value, builder.getIntNTy(member.width));
    builder.CreateCall(transaction.sink({EndpointKind::kNext, i}, member.width), {value});
  }
}

std::vector<llvm::APInt> read_reset_values(const Transaction& transaction) {
  std::vector<llvm::APInt> values;
  for (const RegisterMember& member : transaction.layout.registers) {
    const auto* constant =
        llvm::dyn_cast_or_null<llvm::ConstantInt>(initial_value(transaction, member));
    values.push_back(constant ? constant->getValue().trunc(member.width)
                              : llvm::APInt(member.width, 0));
  }
  return values;
}

}  // namespace hlsc
