// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/unit_layout.h"

#include <fmt/format.h>
#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfoMetadata.h>

#include <optional>

#include "error.h"
#include "frontend/compile_unit.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

using llvm::DICompositeType;
using llvm::DIDerivedType;
using llvm::DIType;
using llvm::dyn_cast;

const DIType* without_qualifiers(const DIType* type) {
  while (const auto* derived = dyn_cast<DIDerivedType>(type)) {
    const auto tag = derived->getTag();
    if (tag != llvm::dwarf::DW_TAG_typedef && tag != llvm::dwarf::DW_TAG_const_type &&
        tag != llvm::dwarf::DW_TAG_template_alias) {
      break;
    }
    type = derived->getBaseType();
  }
  return type;
}

/// The number given as template argument `index`, or nothing.
std::optional<std::uint64_t> template_number(const DICompositeType* type, unsigned index) {
  const auto params = type->getTemplateParams();
  if (index >= params.size()) return std::nullopt;
  const auto* value = dyn_cast<llvm::DITemplateValueParameter>(params[index]);
  if (!value) return std::nullopt;
  const auto* constant = llvm::mdconst::dyn_extract_or_null<llvm::ConstantInt>(value->getValue());
  if (!constant) return std::nullopt;
  return constant->getZExtValue();
}

/// The base class hls::lowered::Port<...> of a port's class.
const DICompositeType* port_base(const DICompositeType* type) {
  for (const llvm::DINode* element : type->getElements()) {
    const auto* base = dyn_cast<DIDerivedType>(element);
    if (!base || base->getTag() != llvm::dwarf::DW_TAG_inheritance) continue;
    const auto* base_type = dyn_cast<DICompositeType>(without_qualifiers(base->getBaseType()));
    if (!base_type) continue;
    const auto* scope = dyn_cast<llvm::DINamespace>(base_type->getScope());
    if (base_type->getName().starts_with("Port<") && scope && scope->getName() == "lowered") {
      return base_type;
    }
  }
  return nullptr;
}

class Reader {
 public:
  Reader(const SourceLines& lines, UnitLayout& layout, SourceLine unit)
      : lines_(lines), layout_(layout), where_(std::move(unit)) {}

  /// A unit's own members come before those of its parts, which are base classes.
  void members(const DICompositeType* type, std::uint64_t offset, const std::string& prefix) {
    for (const llvm::DINode* element : type->getElements()) {
      const auto* member = dyn_cast<DIDerivedType>(element);
      if (!member || member->isStaticMember()) continue;
      if (member->getTag() != llvm::dwarf::DW_TAG_member) continue;
      own_member(*member, offset + member->getOffsetInBits() / 8, prefix);
    }
    for (const llvm::DINode* element : type->getElements()) {
      const auto* base = dyn_cast<DIDerivedType>(element);
      if (!base || base->getTag() != llvm::dwarf::DW_TAG_inheritance) continue;
      if (const auto* part = dyn_cast<DICompositeType>(without_qualifiers(base->getBaseType()))) {
        members(part, offset + base->getOffsetInBits() / 8, prefix);
      }
    }
  }

 private:
  void own_member(const DIDerivedType& member, std::uint64_t place, const std::string& prefix) {
    const SourceLine where = lines_.at(member.getFile(), member.getLine());
    const SourceLine outer = where_;
    const bool written = member.getFile() && !lines_.is_library(member.getFile());
    if (written && !member.isArtificial()) where_ = where;
    if (member.getName().starts_with("_vptr$")) throw Error(where_, messages::kVirtual);
    const std::string name = member.getName().str();
    if (member.isBitField()) {
      throw Error(where_, fmt::format(messages::kBitField, name, member.getSizeInBits()));
    }
    value(member.getBaseType(), place, prefix.empty() ? name : prefix + "_" + name);
    where_ = outer;
  }
  static bool is_single_member(const DICompositeType* type) {
    unsigned count = 0;
    for (const llvm::DINode* element : type->getElements()) {
      const auto* member = dyn_cast<DIDerivedType>(element);
      if (!member || member->isStaticMember()) continue;
      if (member->getTag() == llvm::dwarf::DW_TAG_member) ++count;
      if (member->getTag() == llvm::dwarf::DW_TAG_inheritance) count += 2;
    }
    return count == 1;
  }

  void value(const DIType* qualified, std::uint64_t offset, const std::string& name) {
    const DIType* type = without_qualifiers(qualified);
    if (const auto* composite = dyn_cast<DICompositeType>(type)) {
      return composite_value(composite, offset, name);
    }
    const auto* basic = dyn_cast<llvm::DIBasicType>(type);
    if (!basic) return refuse(name, type ? type->getName().str() : "void");
    RegisterMember leaf{name, offset, 0, 0, false, where_};
    leaf.storage_bits = static_cast<unsigned>(basic->getSizeInBits());
    leaf.width = leaf.storage_bits;
    switch (basic->getEncoding()) {
      case llvm::dwarf::DW_ATE_boolean:
        leaf.width = 1;
        break;
      case llvm::dwarf::DW_ATE_signed:
      case llvm::dwarf::DW_ATE_signed_char:
        leaf.is_signed = true;
        break;
      case llvm::dwarf::DW_ATE_unsigned:
      case llvm::dwarf::DW_ATE_unsigned_char:
      case llvm::dwarf::DW_ATE_UTF:
        break;
      default:
        return refuse(name, basic->getName().str());
    }
    if (bit_int_width_ && basic->getName().contains("_BitInt")) leaf.width = *bit_int_width_;
    layout_.registers.push_back(leaf);
  }

  void composite_value(const DICompositeType* type, std::uint64_t offset, const std::string& name) {
    switch (type->getTag()) {
      case llvm::dwarf::DW_TAG_array_type:
        return array_elements(type, 0, offset, name);
      case llvm::dwarf::DW_TAG_enumeration_type:
        layout_.registers.push_back({name, offset, static_cast<unsigned>(type->getSizeInBits()),
                                     static_cast<unsigned>(type->getSizeInBits()), false, where_});
        return;
      case llvm::dwarf::DW_TAG_structure_type:
      case llvm::dwarf::DW_TAG_class_type:
        break;
      default:
        return refuse(name, type->getName().str());
    }
    if (const DICompositeType* base = port_base(type)) return port(base, offset, name);
    const auto outer = bit_int_width_;
    const bool integer =
        type->getName().starts_with("uint<") || type->getName().starts_with("sint<");
    if (integer) {
      if (const auto width = template_number(type, 0)) {
        bit_int_width_ = static_cast<unsigned>(*width);
      }
    }
    if (is_single_member(type)) {
      for (const llvm::DINode* element : type->getElements()) {
        const auto* member = dyn_cast<DIDerivedType>(element);
        if (member && member->getTag() == llvm::dwarf::DW_TAG_member && !member->isStaticMember()) {
          value(member->getBaseType(), offset + member->getOffsetInBits() / 8, name);
        }
      }
    } else {
      members(type, offset, name);
    }
    bit_int_width_ = outer;
  }

  void array_elements(const DICompositeType* type, unsigned dimension, std::uint64_t offset,
                      const std::string& name) {
    const auto ranges = type->getElements();
    if (dimension == ranges.size()) return value(type->getBaseType(), offset, name);
    std::uint64_t inner = without_qualifiers(type->getBaseType())->getSizeInBits() / 8;
    for (unsigned d = dimension + 1; d < ranges.size(); ++d) inner *= extent(ranges[d]);
    for (std::uint64_t i = 0; i < extent(ranges[dimension]); ++i) {
      array_elements(type, dimension + 1, offset + i * inner, fmt::format("{}_{}", name, i));
    }
  }

  static std::uint64_t extent(const llvm::DINode* node) {
    const auto* range = dyn_cast<llvm::DISubrange>(node);
    if (!range) return 0;
    const auto* count = dyn_cast_if_present<llvm::ConstantInt*>(range->getCount());
    return count ? count->getZExtValue() : 0;
  }

  void port(const DICompositeType* base, std::uint64_t offset, const std::string& name) {
    const auto number = [&](unsigned index) {
      return static_cast<unsigned>(template_number(base, index).value_or(0));
    };
    Port made;
    made.kind = static_cast<PortKind>(number(0));
    made.name = name;
    made.width = number(1);
    made.rows = number(2);
    made.latency = number(3);
    made.where = where_;
    layout_.ports.push_back({made, offset});
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& type) const {
    throw Error(where_, fmt::format(messages::kNotAPort, name, type.empty() ? "pointer" : type));
  }

  const SourceLines& lines_;
  UnitLayout& layout_;
  SourceLine where_;
  std::optional<unsigned> bit_int_width_;
};

}  // namespace

UnitLayout read_layout(const llvm::Module& module, const SourceLines& lines) {
  UnitLayout layout;
  const llvm::GlobalVariable* initial = module.getGlobalVariable(kInitialUnit);
  llvm::SmallVector<llvm::DIGlobalVariableExpression*, 1> debug;
  if (initial) initial->getDebugInfo(debug);
  if (debug.empty()) throw Error({}, "clang wrote no debug info for the unit");
  const auto* unit =
      dyn_cast<DICompositeType>(without_qualifiers(debug.front()->getVariable()->getType()));
  if (!unit) throw Error({}, "the unit is not a class");
  const SourceLine where = lines.at(unit->getFile(), unit->getLine());
  layout.source = where.file;
  Reader(lines, layout, where).members(unit, 0, "");
  return layout;
}

}  // namespace hlsc
