// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/netlist.h"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "netlist/op.h"

namespace hlsc {

Bits::Bits(unsigned width, std::uint64_t low) : width_(width), words_((width + 63) / 64) {
  set_word(0, low);
}

void Bits::set(unsigned i, bool value) {
  const std::uint64_t mask = std::uint64_t{1} << (i % 64);
  words_[i / 64] = value ? words_[i / 64] | mask : words_[i / 64] & ~mask;
}

void Bits::set_word(unsigned i, std::uint64_t value) {
  if (i >= words_.size()) return;
  const unsigned above = 64 * (i + 1);
  words_[i] = above > width_ ? value & (~std::uint64_t{0} >> (above - width_)) : value;
}

bool Bits::is_zero() const {
  for (const std::uint64_t w : words_) {
    if (w != 0) return false;
  }
  return true;
}

bool Bits::is_ones() const {
  for (unsigned i = 0; i < width_; ++i) {
    if (!bit(i)) return false;
  }
  return true;
}

NodeId Netlist::add(Node node) {
  nodes.push_back(std::move(node));
  return static_cast<NodeId>(nodes.size() - 1);
}

namespace {

class Checker {
 public:
  explicit Checker(const Netlist& netlist) : n_(netlist) {}

  void run() {
    for (NodeId id = 0; id < n_.nodes.size(); ++id) check_node(id);
    for (const Register& r : n_.registers) {
      need_text(r.reset.width() == r.width, "register {}: reset is {} bits, register {}", r.name,
                r.reset.width(), r.width);
      if (r.next != kNoNode) need_width("register " + r.name + ": next", r.next, r.width);
    }
    std::set<std::pair<int, unsigned>> used;
    for (const TokenWrite& w : n_.token_writes) {
      const Port& p = port(w.port, {PortKind::kOut});
      need_text(used.emplace(0, w.port).second, "{}: written twice", p.name);
      need_width(p.name + ": enable", w.enable, 1);
      need_width(p.name + ": data", w.data, p.width);
    }
    for (const RowRead& r : n_.row_reads) {
      const Port& p = port(r.port, {PortKind::kRam, PortKind::kRegisterFile, PortKind::kRamRead});
      need_text(used.emplace(1, r.port).second, "{}: read twice", p.name);
      need_width(p.name + ": read enable", r.enable, 1);
      need_width(p.name + ": read address", r.address, address_width(p.rows));
    }
    for (const RowWrite& w : n_.row_writes) {
      const Port& p = port(w.port, {PortKind::kRam, PortKind::kRegisterFile, PortKind::kRamWrite});
      need_text(used.emplace(2, w.port).second, "{}: row written twice", p.name);
      need_width(p.name + ": write enable", w.enable, 1);
      need_width(p.name + ": write address", w.address, address_width(p.rows));
      need_width(p.name + ": write data", w.data, p.width);
    }
  }

 private:
  template <class... A>
  static void need_text(bool holds, fmt::format_string<A...> format, A&&... args) {
    if (!holds) throw std::logic_error("netlist: " + fmt::format(format, std::forward<A>(args)...));
  }

  void need_width(const std::string& what, NodeId id, unsigned width) const {
    need_text(id < n_.nodes.size(), "{} is node {}, which does not exist", what, id);
    need_text(n_.nodes[id].width == width, "{} is node {} of {} bits instead of {}", what, id,
              n_.nodes[id].width, width);
  }

  const Port& port(unsigned index, std::initializer_list<PortKind> kinds) const {
    need_text(index < n_.ports.size(), "port {} does not exist", index);
    const Port& p = n_.ports[index];
    bool fits = false;
    for (const PortKind kind : kinds) fits = fits || p.kind == kind;
    need_text(fits, "port {} is of the wrong kind", p.name);
    return p;
  }

  void check_source(NodeId id, unsigned width) const {
    const Node& n = n_.nodes[id];
    need_text(n.low + n.width <= width, "node {} takes bits {} to {} of {}", id, n.low,
              n.low + n.width - 1, width);
  }

  void check_node(NodeId id) const {
    const Node& n = n_.nodes[id];
    const char* name = op_name(n.op);
    need_text(n.width > 0, "node {} ({}) has no bits", id, name);
    for (const NodeId operand : n.operands) {
      need_text(operand < id, "node {} ({}) comes before its operand {}", id, name, operand);
    }
    const int operands = operand_count(n.op);
    need_text(operands < 0 ? !n.operands.empty() : n.operands.size() == unsigned(operands),
              "node {} ({}) has {} operands", id, name, n.operands.size());
    const auto width = [&](std::size_t i) { return n_.nodes[n.operands[i]].width; };
    bool fits = true;
    switch (n.op) {
      case Op::kConst:
        fits = n.value.width() == n.width;
        break;
      case Op::kToken:
        check_source(id, port(n.port, {PortKind::kIn}).width);
        break;
      case Op::kConfig:
        check_source(id, port(n.port, {PortKind::kConfig}).width);
        break;
      case Op::kRegister:
        need_text(n.port < n_.registers.size(), "node {}: register {} does not exist", id, n.port);
        fits = n_.registers[n.port].width == n.width;
        break;
      case Op::kRow:
        need_text(n.port < n_.row_reads.size(), "node {}: row read {} does not exist", id, n.port);
        check_source(id, n_.ports[n_.row_reads[n.port].port].width);
        fits = n_.row_reads[n.port].address < id && n_.row_reads[n.port].enable < id;
        break;
      case Op::kAdd:
      case Op::kSub:
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
        fits = width(0) == n.width && width(1) == n.width;
        break;
      case Op::kAddSub:
        fits = width(0) == n.width && width(1) == n.width && width(2) == 1;
        break;
      case Op::kMul:
        fits = width(0) <= n.width && width(1) <= n.width;
        break;
      case Op::kNot:
      case Op::kUDiv:
      case Op::kShl:
      case Op::kLShr:
      case Op::kAShr:
        fits = width(0) == n.width;
        break;
      case Op::kEq:
      case Op::kULt:
      case Op::kSLt:
        fits = n.width == 1 && width(0) == width(1);
        break;
      case Op::kMux:
        fits = width(0) == 1 && width(1) == n.width && width(2) == n.width;
        break;
      case Op::kSlice:
        fits = n.low + n.width <= width(0);
        break;
      case Op::kSExt:
        fits = width(0) <= n.width;
        break;
      case Op::kClz:
        fits = n.width >= 32 || (1ull << n.width) > width(0);
        break;
      case Op::kConcat: {
        unsigned total = 0;
        for (std::size_t i = 0; i < n.operands.size(); ++i) total += width(i);
        fits = total == n.width;
        break;
      }
    }
    need_text(fits, "node {} ({}) of {} bits does not fit its operands", id, name, n.width);
  }

  const Netlist& n_;
};

}  // namespace

void check(const Netlist& netlist) { Checker(netlist).run(); }

std::string to_hex(const Bits& bits) {
  std::string text;
  for (unsigned low = 0; low < bits.width(); low += 4) {
    unsigned digit = 0;
    for (unsigned i = low; i < low + 4 && i < bits.width(); ++i) {
      digit |= static_cast<unsigned>(bits.bit(i)) << (i - low);
    }
    text.insert(text.begin(), "0123456789abcdef"[digit]);
  }
  return text;
}

std::string to_text(const Netlist& netlist) {
  std::string text;
  const auto out = [&text]<class... A>(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(text), format, std::forward<A>(args)...);
  };
  for (NodeId id = 0; id < netlist.nodes.size(); ++id) {
    const Node& n = netlist.nodes[id];
    out("%{}:{} = {}", id, n.width, op_name(n.op));
    if (n.op == Op::kConst) out(" 0x{}", to_hex(n.value));
    if (n.op == Op::kToken || n.op == Op::kConfig) {
      out(" {}[{}]", netlist.ports[n.port].name, n.low);
    }
    if (n.op == Op::kRegister) out(" {}", netlist.registers[n.port].name);
    if (n.op == Op::kRow) {
      out(" {}[{}]", netlist.ports[netlist.row_reads[n.port].port].name, n.low);
    }
    for (std::size_t i = 0; i < n.operands.size(); ++i) {
      out("{} %{}", i == 0 ? "" : ",", n.operands[i]);
    }
    if (n.op == Op::kSlice) out(" at {}", n.low);
    if (!n.name.empty()) out("  ; {}", n.name);
    out("\n");
  }
  for (const Register& r : netlist.registers) {
    if (r.next != kNoNode) out("register {} <= %{}\n", r.name, r.next);
  }
  for (const TokenWrite& w : netlist.token_writes) {
    out("write {} if %{}: %{}\n", netlist.ports[w.port].name, w.enable, w.data);
  }
  for (const RowRead& r : netlist.row_reads) {
    out("read {} if %{}: at %{}\n", netlist.ports[r.port].name, r.enable, r.address);
  }
  for (const RowWrite& w : netlist.row_writes) {
    out("write {} if %{}: at %{} row %{}\n", netlist.ports[w.port].name, w.enable, w.address,
        w.data);
  }
  return text;
}

}  // namespace hlsc
