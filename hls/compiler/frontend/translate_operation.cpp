// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/translate_operation.h"

#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

namespace hlsc {
namespace {

NodeId compare(llvm::CmpInst::Predicate predicate, NodeId a, NodeId b, Builder& builder) {
  switch (predicate) {
    case llvm::CmpInst::ICMP_EQ:
      return builder.equal(a, b);
    case llvm::CmpInst::ICMP_NE:
      return builder.invert(builder.equal(a, b));
    case llvm::CmpInst::ICMP_ULT:
      return builder.less(Op::kULt, a, b);
    case llvm::CmpInst::ICMP_UGT:
      return builder.less(Op::kULt, b, a);
    case llvm::CmpInst::ICMP_ULE:
      return builder.invert(builder.less(Op::kULt, b, a));
    case llvm::CmpInst::ICMP_UGE:
      return builder.invert(builder.less(Op::kULt, a, b));
    case llvm::CmpInst::ICMP_SLT:
      return builder.less(Op::kSLt, a, b);
    case llvm::CmpInst::ICMP_SGT:
      return builder.less(Op::kSLt, b, a);
    case llvm::CmpInst::ICMP_SLE:
      return builder.invert(builder.less(Op::kSLt, b, a));
    default:
      return builder.invert(builder.less(Op::kSLt, a, b));
  }
}

/// The two results of an overflow-checking operation: sum, difference or product, and the overflow.
std::optional<NodeId> overflow_result(const llvm::WithOverflowInst& call, unsigned index,
                                      Builder& builder, const Operand& operand) {
  const NodeId a = operand(call.getLHS());
  const NodeId b = operand(call.getRHS());
  const unsigned w = builder.width(a);
  const bool is_mul = call.getBinaryOp() == llvm::Instruction::Mul;
  const unsigned wide = is_mul ? 2 * w : w + 1;
  const auto extend = [&](NodeId node) {
    return call.isSigned() ? builder.sext(node, wide) : builder.zext(node, wide);
  };
  NodeId result = kNoNode;
  switch (call.getBinaryOp()) {
    case llvm::Instruction::Add:
      result = builder.add(extend(a), extend(b));
      break;
    case llvm::Instruction::Sub:
      result = builder.sub(extend(a), extend(b));
      break;
    default:
      result = builder.mul(extend(a), extend(b));
      break;
  }
  const NodeId low = builder.trunc(result, w);
  if (index == 0) return low;
  return builder.invert(builder.equal(result, extend(low)));
}

}  // namespace

std::optional<NodeId> translate_operation(const llvm::Instruction& instruction, Builder& builder,
                                          const Operand& operand) {
  if (!instruction.getType()->isIntegerTy()) {
    // A pair of result and overflow; its parts are made where they are taken out of it.
    if (llvm::isa<llvm::WithOverflowInst>(instruction)) return kNoNode;
    return std::nullopt;
  }
  const unsigned width = instruction.getType()->getIntegerBitWidth();
  const auto arg = [&](unsigned i) { return operand(instruction.getOperand(i)); };
  switch (instruction.getOpcode()) {
    case llvm::Instruction::Add:
      return builder.add(arg(0), arg(1));
    case llvm::Instruction::Sub:
      return builder.sub(arg(0), arg(1));
    case llvm::Instruction::Mul:
      return builder.mul(arg(0), arg(1));
    case llvm::Instruction::And:
      return builder.logic(Op::kAnd, arg(0), arg(1));
    case llvm::Instruction::Or:
      return builder.logic(Op::kOr, arg(0), arg(1));
    case llvm::Instruction::Xor:
      return builder.logic(Op::kXor, arg(0), arg(1));
    case llvm::Instruction::Shl:
      return builder.shift(Op::kShl, arg(0), arg(1));
    case llvm::Instruction::LShr:
      return builder.shift(Op::kLShr, arg(0), arg(1));
    case llvm::Instruction::AShr:
      return builder.shift(Op::kAShr, arg(0), arg(1));
    case llvm::Instruction::ZExt:
      return builder.zext(arg(0), width);
    case llvm::Instruction::SExt:
      return builder.sext(arg(0), width);
    case llvm::Instruction::Trunc:
      return builder.trunc(arg(0), width);
    case llvm::Instruction::Freeze:
      return arg(0);
    case llvm::Instruction::Select:
      // An undefined value may be any, so the other one too.
      if (llvm::isa<llvm::UndefValue>(instruction.getOperand(1))) return arg(2);
      if (llvm::isa<llvm::UndefValue>(instruction.getOperand(2))) return arg(1);
      return builder.mux(arg(0), arg(1), arg(2));
    case llvm::Instruction::ICmp: {
      const auto& icmp = llvm::cast<llvm::ICmpInst>(instruction);
      if (!icmp.getOperand(0)->getType()->isIntegerTy()) return std::nullopt;
      return compare(icmp.getPredicate(), arg(0), arg(1), builder);
    }
    case llvm::Instruction::ExtractValue: {
      const auto& extract = llvm::cast<llvm::ExtractValueInst>(instruction);
      const auto* call = llvm::dyn_cast<llvm::WithOverflowInst>(extract.getAggregateOperand());
      if (!call) return std::nullopt;
      return overflow_result(*call, extract.getIndices()[0], builder, operand);
    }
    case llvm::Instruction::Call:
      return translate_call(instruction, builder, operand);
    default:
      return std::nullopt;
  }
}

}  // namespace hlsc
