// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

#include "frontend/translate_operation.h"

namespace hlsc {
namespace {

/// Operations that are made of several nodes.
class Composer {
 public:
  explicit Composer(Builder& builder) : b_(builder) {}

  NodeId negate(NodeId a) { return b_.sub(b_.constant(b_.width(a), 0), a); }
  NodeId sign(NodeId a) { return b_.slice(a, b_.width(a) - 1, 1); }
  NodeId abs(NodeId a) { return b_.mux(sign(a), negate(a), a); }

  NodeId lesser(Op order, NodeId a, NodeId b) { return b_.mux(b_.less(order, a, b), a, b); }
  NodeId greater(Op order, NodeId a, NodeId b) { return b_.mux(b_.less(order, a, b), b, a); }

  NodeId reverse(NodeId a) {
    std::vector<NodeId> bits;
    for (unsigned i = 0; i < b_.width(a); ++i) bits.push_back(b_.slice(a, i, 1));
    return b_.concat(bits);
  }
  NodeId swap_bytes(NodeId a) {
    std::vector<NodeId> bytes;
    for (unsigned i = 0; i < b_.width(a); i += 8) bytes.push_back(b_.slice(a, i, 8));
    return b_.concat(bytes);
  }
  /// The sum of the bits, as a balanced tree.
  NodeId population(NodeId a, unsigned width) {
    const unsigned w = b_.width(a);
    if (w == 1) return b_.zext(a, width);
    return b_.add(population(b_.slice(a, 0, w / 2), width),
                  population(b_.slice(a, w / 2, w - w / 2), width));
  }
  /// {high, low} shifted left, its upper half; shifted right, its lower half. The amount wraps.
  NodeId funnel(bool left, NodeId high, NodeId low, NodeId amount) {
    const unsigned w = b_.width(high);
    const NodeId wide = b_.concat({high, low});
    NodeId by = amount;
    if ((w & (w - 1)) == 0) {
      by = b_.zext(b_.trunc(amount, w > 1 ? llvm::Log2_32(w) : 1), w);
    } else if (!b_.known(amount).getMaxValue().ult(w)) {
      by = remainder(amount, b_.constant(w, w));
    }
    const NodeId shifted = b_.shift(left ? Op::kShl : Op::kLShr, wide, by);
    return b_.slice(shifted, left ? w : 0, w);
  }

  NodeId remainder(NodeId a, NodeId b) {
    if (b_.known(b).isConstant() && b_.known(b).getConstant().isPowerOf2()) {
      return b_.logic(Op::kAnd, a, b_.constant(b_.known(b).getConstant() - 1));
    }
    return b_.sub(a, b_.mul(b_.udiv(a, b), b));
  }
  NodeId signed_divide(NodeId a, NodeId b) {
    const NodeId quotient = b_.udiv(abs(a), abs(b));
    return b_.mux(b_.logic(Op::kXor, sign(a), sign(b)), negate(quotient), quotient);
  }
  NodeId signed_remainder(NodeId a, NodeId b) {
    const NodeId rest = remainder(abs(a), abs(b));
    return b_.mux(sign(a), negate(rest), rest);
  }

  NodeId saturating(bool is_signed, bool is_add, NodeId a, NodeId b) {
    const unsigned w = b_.width(a);
    const auto extend = [&](NodeId node) {
      return is_signed ? b_.sext(node, w + 1) : b_.zext(node, w + 1);
    };
    const NodeId wide = is_add ? b_.add(extend(a), extend(b)) : b_.sub(extend(a), extend(b));
    const NodeId low = b_.trunc(wide, w);
    if (!is_signed) {
      const auto limit = is_add ? llvm::APInt::getAllOnes(w) : llvm::APInt::getZero(w);
      return b_.mux(b_.slice(wide, w, 1), b_.constant(limit), low);
    }
    const NodeId overflow = b_.logic(Op::kXor, b_.slice(wide, w, 1), sign(low));
    const NodeId limit =
        b_.mux(b_.slice(wide, w, 1), b_.constant(llvm::APInt::getSignedMinValue(w)),
               b_.constant(llvm::APInt::getSignedMaxValue(w)));
    return b_.mux(overflow, limit, low);
  }
  /// -1, 0 or 1.
  NodeId three_way(Op order, NodeId a, NodeId b, unsigned width) {
    return b_.sub(b_.zext(b_.less(order, b, a), width), b_.zext(b_.less(order, a, b), width));
  }

 private:
  Builder& b_;
};

}  // namespace

std::optional<NodeId> translate_call(const llvm::Instruction& instruction, Builder& builder,
                                     const Operand& operand) {
  const auto& call = llvm::cast<llvm::CallInst>(instruction);
  const llvm::Function* callee = call.getCalledFunction();
  if (!callee) return std::nullopt;
  Composer make(builder);
  const unsigned width = call.getType()->getIntegerBitWidth();
  const auto arg = [&](unsigned i) { return operand(call.getArgOperand(i)); };

  const llvm::StringRef name = callee->getName();
  if (name.starts_with("hls.udiv.")) return builder.udiv(arg(0), arg(1));
  if (name.starts_with("hls.urem.")) return make.remainder(arg(0), arg(1));
  if (name.starts_with("hls.sdiv.")) return make.signed_divide(arg(0), arg(1));
  if (name.starts_with("hls.srem.")) return make.signed_remainder(arg(0), arg(1));

  switch (callee->getIntrinsicID()) {
    case llvm::Intrinsic::umin:
      return make.lesser(Op::kULt, arg(0), arg(1));
    case llvm::Intrinsic::umax:
      return make.greater(Op::kULt, arg(0), arg(1));
    case llvm::Intrinsic::smin:
      return make.lesser(Op::kSLt, arg(0), arg(1));
    case llvm::Intrinsic::smax:
      return make.greater(Op::kSLt, arg(0), arg(1));
    case llvm::Intrinsic::abs:
      return make.abs(arg(0));
    case llvm::Intrinsic::uadd_sat:
      return make.saturating(false, true, arg(0), arg(1));
    case llvm::Intrinsic::usub_sat:
      return make.saturating(false, false, arg(0), arg(1));
    case llvm::Intrinsic::sadd_sat:
      return make.saturating(true, true, arg(0), arg(1));
    case llvm::Intrinsic::ssub_sat:
      return make.saturating(true, false, arg(0), arg(1));
    case llvm::Intrinsic::ctlz:
      return builder.clz(arg(0), width);
    case llvm::Intrinsic::cttz:
      return builder.clz(make.reverse(arg(0)), width);
    case llvm::Intrinsic::ctpop:
      return make.population(arg(0), width);
    case llvm::Intrinsic::bitreverse:
      return make.reverse(arg(0));
    case llvm::Intrinsic::bswap:
      return make.swap_bytes(arg(0));
    case llvm::Intrinsic::fshl:
      return make.funnel(true, arg(0), arg(1), arg(2));
    case llvm::Intrinsic::fshr:
      return make.funnel(false, arg(0), arg(1), arg(2));
    case llvm::Intrinsic::ucmp:
      return make.three_way(Op::kULt, arg(0), arg(1), width);
    case llvm::Intrinsic::scmp:
      return make.three_way(Op::kSLt, arg(0), arg(1), width);
    default:
      return std::nullopt;
  }
}

}  // namespace hlsc
