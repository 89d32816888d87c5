// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/value_names.h"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/DebugProgramInstruction.h>
#include <llvm/IR/InstIterator.h>

namespace hlsc {
namespace {

/// "_field" of the member at a bit range of a struct variable, for each level of nesting.
std::string member_path(const llvm::DIType* type, std::uint64_t bit) {
  while (const auto* derived = llvm::dyn_cast_or_null<llvm::DIDerivedType>(type)) {
    type = derived->getBaseType();
  }
  const auto* composite = llvm::dyn_cast_or_null<llvm::DICompositeType>(type);
  if (!composite) return {};
  if (composite->getTag() == llvm::dwarf::DW_TAG_array_type) {
    const llvm::DIType* element = composite->getBaseType();
    while (const auto* derived = llvm::dyn_cast<llvm::DIDerivedType>(element)) {
      element = derived->getBaseType();
    }
    const std::uint64_t size = element->getSizeInBits();
    if (size == 0) return {};
    return "_" + std::to_string(bit / size) + member_path(element, bit % size);
  }
  for (const llvm::DINode* node : composite->getElements()) {
    const auto* member = llvm::dyn_cast<llvm::DIDerivedType>(node);
    if (!member || member->isStaticMember() || member->getTag() != llvm::dwarf::DW_TAG_member) {
      continue;
    }
    const std::uint64_t low = member->getOffsetInBits();
    if (bit < low || bit >= low + member->getSizeInBits()) continue;
    const bool shown = !member->getName().starts_with("_M_") && !member->getName().ends_with("_");
    return (shown ? "_" + member->getName().str() : std::string()) +
           member_path(member->getBaseType(), bit - low);
  }
  return {};
}

std::string variable_name(const llvm::DbgVariableRecord& record) {
  const llvm::DILocalVariable* variable = record.getVariable();
  std::string name = variable->getName().str();
  if (name.empty() || name == "this") return {};
  if (const auto fragment = record.getFragment()) {
    name += member_path(variable->getType(), fragment->OffsetInBits);
  }
  return name;
}

}  // namespace

void name_values(llvm::Function& function, const SourceLines& lines) {
  for (llvm::BasicBlock& block : function) {
    for (llvm::Instruction& instruction : block) {
      for (llvm::DbgVariableRecord& record : llvm::filterDbgVars(instruction.getDbgRecordRange())) {
        if (record.isKillLocation() || record.getNumVariableLocationOps() != 1) continue;
        if (lines.is_library(record.getVariable()->getFile())) continue;
        auto* value = llvm::dyn_cast<llvm::Instruction>(record.getVariableLocationOp(0));
        if (!value || !value->getType()->isIntegerTy()) continue;
        const std::string name = variable_name(record);
        if (!name.empty() && value_name(*value).empty()) value->setName(kNamePrefix + name + "$");
      }
    }
  }
  for (llvm::Instruction& instruction : llvm::instructions(function)) {
    instruction.dropDbgRecords();
  }
}

std::string value_name(const llvm::Value& value) {
  llvm::StringRef name = value.getName();
  if (!name.consume_front(kNamePrefix)) return {};
  return name.split('$').first.str();
}

}  // namespace hlsc
