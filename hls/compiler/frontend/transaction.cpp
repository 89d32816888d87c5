// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/transaction.h"

#include <fmt/format.h>
#include <llvm/IR/DerivedTypes.h>
#include <llvm/Support/ModRef.h>

namespace hlsc {
namespace {

/// Endpoint functions are told apart by their names, which appear in dumps of the IR only.
std::string endpoint_name(const char* side, const Endpoint& e, unsigned width) {
  return fmt::format("hls.{}.{}.{}.{}.{}", side, static_cast<int>(e.kind), e.index, e.low, width);
}

}  // namespace

llvm::Function* Transaction::source(Endpoint endpoint, unsigned width) {
  const std::string name = endpoint_name("source", endpoint, width);
  if (llvm::Function* known = module->getFunction(name)) return known;
  auto* type = llvm::FunctionType::get(llvm::IntegerType::get(*context, width), false);
  auto* made = llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage, name, *module);
  made->setMemoryEffects(llvm::MemoryEffects::none());
  made->setDoesNotThrow();
  made->setWillReturn();
  made->addFnAttr(llvm::Attribute::Speculatable);
  endpoints[made] = endpoint;
  return made;
}

llvm::Function* Transaction::sink(Endpoint endpoint, unsigned width) {
  const std::string name = endpoint_name("sink", endpoint, width);
  if (llvm::Function* known = module->getFunction(name)) return known;
  auto* type = llvm::FunctionType::get(llvm::Type::getVoidTy(*context),
                                       {llvm::IntegerType::get(*context, width)}, false);
  auto* made = llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage, name, *module);
  made->setMemoryEffects(llvm::MemoryEffects::inaccessibleMemOnly());
  made->setDoesNotThrow();
  made->setWillReturn();
  endpoints[made] = endpoint;
  return made;
}

}  // namespace hlsc
