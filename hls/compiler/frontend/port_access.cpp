// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/port_access.h"

#include <fmt/format.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/GlobalVariable.h>

#include <stdexcept>

namespace hlsc {
namespace {

constexpr char kAnnotation[] = "hls.port_access";
constexpr char kList[] = "llvm.global.annotations";

/// The text that a constant pointer points to.
llvm::StringRef text_of(const llvm::Constant& pointer) {
  const auto* global = llvm::dyn_cast<llvm::GlobalVariable>(pointer.stripPointerCasts());
  const auto* data =
      global ? llvm::dyn_cast<llvm::ConstantDataArray>(global->getInitializer()) : nullptr;
  return data && data->isCString() ? data->getAsCString() : llvm::StringRef();
}

std::uint64_t number(const llvm::Constant& arguments, unsigned index) {
  const llvm::Constant* value = arguments.getAggregateElement(index);
  return llvm::cast<llvm::ConstantInt>(value)->getZExtValue();
}

/// An entry is {function, text, file, line, arguments}.
void keep(const llvm::Constant& entry) {
  auto* function = llvm::dyn_cast<llvm::Function>(entry.getOperand(0)->stripPointerCasts());
  if (!function || text_of(*llvm::cast<llvm::Constant>(entry.getOperand(1))) != kAnnotation) return;
  const auto* global = llvm::cast<llvm::GlobalVariable>(entry.getOperand(4)->stripPointerCasts());
  const llvm::Constant& arguments = *global->getInitializer();
  function->addFnAttr(kAnnotation, fmt::format("{},{},{}", number(arguments, 0),
                                               number(arguments, 1), number(arguments, 2)));
}

}  // namespace

void keep_annotations(llvm::Module& module) {
  llvm::GlobalVariable* list = module.getGlobalVariable(kList);
  if (!list) return;
  for (const llvm::Use& entry : list->getInitializer()->operands()) {
    keep(*llvm::cast<llvm::Constant>(entry.get()));
  }
  list->eraseFromParent();
}

std::optional<PortAccessInfo> port_access(const llvm::Function& function) {
  const llvm::Attribute attribute = function.getFnAttribute(kAnnotation);
  if (!attribute.isValid()) return std::nullopt;
  llvm::StringRef text = attribute.getValueAsString();
  unsigned numbers[3] = {};
  for (unsigned& n : numbers) {
    if (text.consumeInteger(10, n)) throw std::logic_error("a port access's annotation is no list");
    text.consume_front(",");
  }
  return PortAccessInfo{static_cast<hls::PortAccess>(numbers[0]), numbers[1], numbers[2]};
}

}  // namespace hlsc
