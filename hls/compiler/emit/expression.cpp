// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "emit/expression.h"

#include <fmt/format.h>

#include <stdexcept>

#include "netlist/evaluate.h"
#include "netlist/op.h"

namespace hlsc {
namespace {

constexpr std::size_t kMostMuxParts = 4;

std::string select(const Signal& s, unsigned low, unsigned high) {
  if (s.scalar || (low == s.declared_low && high == s.declared_high)) return s.name;
  if (low == high) return fmt::format("{}[{}]", s.name, low);
  return fmt::format("{}[{}:{}]", s.name, high, low);
}

}  // namespace

std::string bit_range(unsigned width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

std::string literal(const Bits& value) {
  if (active_bits(value) <= 10) return fmt::format("{}'d{}", value.width(), value.low64());
  return fmt::format("{}'h{}", value.width(), to_hex(value));
}

Expressions::Expressions(const Circuit& circuit) : c_(circuit) {}

void Expressions::declare(CellId cell, int stage, Signal s) {
  s.used.assign(s.declared_high - s.declared_low + 1, false);
  index_[{cell, stage}] = signals_.size();
  signals_.push_back(std::move(s));
}

Signal& Expressions::signal(CellId cell, int stage) {
  if (c_.still[cell] && stage >= 0) stage = kStill;
  const auto found = index_.find({cell, stage});
  if (found == index_.end()) {
    throw std::logic_error(
        fmt::format("emit: {} does not exist in stage {}", c_.describe(cell), stage));
  }
  return signals_[found->second];
}

std::string Expressions::range(CellId cell, int stage, unsigned low, unsigned high) {
  Signal& s = signal(cell, stage);
  for (unsigned i = low; i <= high; ++i) s.used.at(i + s.offset - s.declared_low) = true;
  return select(s, low + s.offset, high + s.offset);
}

std::string Expressions::bits(const std::vector<BitRef>& operand, int stage) {
  const BitRef first = operand.front();
  if (!first.is_constant()) {
    const auto whole = inlined_.find(first.cell);
    if (whole != inlined_.end()) return "(" + whole->second + ")";
  }
  std::vector<std::string> parts;  // lowest first
  for (std::size_t i = 0; i < operand.size();) {
    const BitRef b = operand[i];
    std::size_t end = i + 1;
    if (b.is_constant()) {
      while (end < operand.size() && operand[end].is_constant()) ++end;
      Bits value(static_cast<unsigned>(end - i), 0);
      for (std::size_t k = i; k < end; ++k) {
        value.set(static_cast<unsigned>(k - i), operand[k].bit == 1);
      }
      parts.push_back(literal(value));
    } else if (end < operand.size() && operand[end] == b) {
      while (end < operand.size() && operand[end] == b) ++end;
      parts.push_back(fmt::format("{{{}{{{}}}}}", end - i, range(b.cell, stage, b.bit, b.bit)));
    } else {
      while (end < operand.size() && operand[end].cell == b.cell &&
             operand[end].bit == b.bit + (end - i)) {
        ++end;
      }
      const auto high = static_cast<unsigned>(b.bit + (end - i) - 1);
      parts.push_back(range(b.cell, stage, b.bit, high));
    }
    i = end;
  }
  if (parts.size() == 1) return parts.front();
  std::string text;
  for (auto it = parts.rbegin(); it != parts.rend(); ++it)
    text += (text.empty() ? "{" : ", ") + *it;
  return text + "}";
}

/// Only the significant bits of the operands, so that synthesis finds the hard multiplier.
std::string Expressions::multiply(const Cell& cell, int stage) {
  struct Factor {
    std::vector<BitRef> bits;
    bool is_signed;
  };
  std::vector<Factor> factors;
  for (std::vector<BitRef> operand : cell.operands) {
    const bool whole = operand.size() == cell.width;
    bool is_signed = false;
    if (operand.back() == BitRef{BitRef::kConstant, 0} || !whole) {
      while (operand.size() > 1 && operand.back() == BitRef{BitRef::kConstant, 0}) {
        operand.pop_back();
      }
    } else {
      while (operand.size() > 1 && operand[operand.size() - 2] == operand.back()) {
        operand.pop_back();
        is_signed = true;
      }
    }
    factors.push_back({operand, is_signed});
  }
  if (!factors[0].is_signed && !factors[1].is_signed) {
    return bits(factors[0].bits, stage) + " * " + bits(factors[1].bits, stage);
  }
  std::string text;
  for (Factor& f : factors) {
    if (!f.is_signed && f.bits.size() < cell.width) f.bits.push_back({BitRef::kConstant, 0});
    text += (text.empty() ? "$signed(" : " * $signed(") + bits(f.bits, stage) + ")";
  }
  return text;
}

/// Where one side is constant as a mask, or else synthesis makes it a register's reset, of which
/// there are few.
std::string Expressions::mux(const Cell& cell, int stage) {
  enum class Kind : std::uint8_t { kBoth, kNoZero, kNoOne, kYesZero, kYesOne };
  const auto& yes = cell.operands[1];
  const auto& no = cell.operands[2];
  const auto kind = [&](std::size_t i) {
    if (no[i].is_constant()) return no[i].bit == 0 ? Kind::kNoZero : Kind::kNoOne;
    if (yes[i].is_constant()) return yes[i].bit == 0 ? Kind::kYesZero : Kind::kYesOne;
    return Kind::kBoth;
  };
  struct Part {
    Kind kind;
    std::size_t low;
    std::size_t high;
  };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < yes.size(); ++i) {
    const bool both_constant = yes[i].is_constant() && no[i].is_constant();
    const Kind k = both_constant ? Kind::kBoth : kind(i);
    if (parts.empty() || parts.back().kind != k) parts.push_back({k, i, i});
    parts.back().high = i;
  }
  const std::string s = bits(cell.operands[0], stage);
  if (parts.size() > kMostMuxParts) parts = {{Kind::kBoth, 0, yes.size() - 1}};
  std::string text;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    const auto side = [&](const std::vector<BitRef>& operand) {
      return bits({operand.begin() + static_cast<std::ptrdiff_t>(part->low),
                   operand.begin() + static_cast<std::ptrdiff_t>(part->high) + 1},
                  stage);
    };
    const std::size_t width = part->high - part->low + 1;
    const std::string mask = width == 1 ? s : fmt::format("{{{}{{{}}}}}", width, s);
    std::string value;
    switch (part->kind) {
      case Kind::kNoZero:
        value = mask + " & " + side(yes);
        break;
      case Kind::kNoOne:
        value = "~" + mask + " | " + side(yes);
        break;
      case Kind::kYesZero:
        value = "~" + mask + " & " + side(no);
        break;
      case Kind::kYesOne:
        value = mask + " | " + side(no);
        break;
      case Kind::kBoth:
        value = s + " ? " + side(yes) + " : " + side(no);
        break;
    }
    if (parts.size() == 1) return value;
    text += (text.empty() ? "{" : ", ") + value;
  }
  return text + "}";
}

std::string Expressions::operation(CellId id, int stage) {
  const Cell& cell = c_.cells[id];
  const auto operand = [&](std::size_t i) { return bits(cell.operands[i], stage); };
  const auto infix = [&](const char* op) { return operand(0) + op + operand(1); };
  switch (c_.op(id)) {
    case Op::kAdd:
      return infix(" + ");
    case Op::kSub:
      return infix(" - ");
    case Op::kMul:
      return multiply(cell, stage);
    case Op::kAnd:
      return infix(" & ");
    case Op::kOr:
      return infix(" | ");
    case Op::kXor:
      return infix(" ^ ");
    case Op::kNot:
      return "~" + operand(0);
    case Op::kEq:
      return infix(" == ");
    case Op::kULt:
      return infix(" < ");
    case Op::kSLt:
      return "$signed(" + operand(0) + ") < $signed(" + operand(1) + ")";
    case Op::kMux:
      return mux(cell, stage);
    default:
      throw std::logic_error(std::string("emit: ") + op_name(c_.op(id)) + " was not expanded");
  }
}

std::vector<std::string> Expressions::unused() const {
  std::vector<std::string> all;
  for (const Signal& s : signals_) {
    for (std::size_t i = 0; i < s.used.size();) {
      std::size_t end = i + 1;
      while (end < s.used.size() && s.used[end] == s.used[i]) ++end;
      if (!s.used[i]) {
        all.push_back(select(s, s.declared_low + static_cast<unsigned>(i),
                             s.declared_low + static_cast<unsigned>(end) - 1));
      }
      i = end;
    }
  }
  return all;
}

}  // namespace hlsc
