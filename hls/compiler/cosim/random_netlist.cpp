// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "cosim/random_netlist.h"

#include <random>
#include <string>

#include "netlist/op.h"

namespace hlsc {
namespace {

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {
    n_.module = "random_" + std::to_string(seed);
    n_.unit = "random netlist";
    n_.source = "seed " + std::to_string(seed);
  }

  Netlist run() {
    const unsigned in = port(PortKind::kIn, "in", kIdWidth + 40 + below(60));
    const unsigned second = port(PortKind::kIn, "second", 1 + below(30));
    const unsigned config = port(PortKind::kConfig, "frame", 1 + below(40));
    const unsigned ram = port(PortKind::kRam, "ram", 1 + below(50), 1u << kIdWidth, 1);
    const unsigned file = port(PortKind::kRegisterFile, "file", 1 + below(16), 4);
    const unsigned rays = port(PortKind::kRamRead, "rays", 1 + below(40), 16, 1 + below(3));
    const unsigned hits = port(PortKind::kRamWrite, "hits", 1 + below(40), 8, 1);
    const unsigned full = port(PortKind::kOut, "full", 1 + below(70));
    const unsigned some = port(PortKind::kOut, "some", 1 + below(20));

    id_ = source(Op::kToken, in, 0, kIdWidth);
    for (int i = 0; i < 4; ++i) field(Op::kToken, in, kIdWidth);
    field(Op::kToken, second, 0);
    field(Op::kConfig, config, 0);
    for (const char* name : {"count", "state"}) {
      const unsigned width = 1 + below(12);
      n_.registers.push_back({name, width, Bits(width, random_()), kNoNode, {}});
      pool_.push_back(
          source(Op::kRegister, static_cast<unsigned>(n_.registers.size() - 1), 0, width));
    }
    const std::vector<NodeId> shallow = pool_;
    operations(12);
    read(ram, id_);
    read(rays, sized(pick(), 4));
    operations(12);
    // State is read and written in one stage, so little may lie between.
    const NodeId file_address = sized(shallow[below(shallow.size())], 2);
    const NodeId file_row = read(file, file_address);
    write(file, file_address,
          node(Op::kXor, n_.ports[file].width, {file_row, sized(pick(), n_.ports[file].width)}));
    operations(12 + below(20));
    write(ram, id_, sized(pick(), n_.ports[ram].width));
    write(hits, sized(pick(), 3), sized(pick(), n_.ports[hits].width));
    for (unsigned i = 0; i < n_.registers.size(); ++i) {
      const unsigned w = n_.registers[i].width;
      const NodeId self = source(Op::kRegister, i, 0, w);
      const NodeId with = sized(shallow[below(shallow.size())], w);
      n_.registers[i].next =
          node(Op::kMux, w, {sized(pick_of(shallow), 1), node(Op::kAdd, w, {self, with}), self});
    }
    n_.token_writes.push_back({full, one(), wide(n_.ports[full].width)});
    n_.token_writes.push_back({some, bit(), wide(n_.ports[some].width)});
    return std::move(n_);
  }

 private:
  unsigned below(std::size_t limit) { return static_cast<unsigned>(random_() % limit); }
  NodeId pick() { return pick_of(pool_); }
  NodeId pick_of(const std::vector<NodeId>& from) {
    return from[below(2) == 0 ? below(from.size())
                              : from.size() - 1 - below(from.size() / 2 + 1) / 2];
  }

  unsigned port(PortKind kind, const char* name, unsigned width, unsigned rows = 1,
                unsigned latency = 0) {
    n_.ports.push_back({kind, name, width, rows, latency, {}});
    return static_cast<unsigned>(n_.ports.size() - 1);
  }
  NodeId node(Op op, unsigned width, std::vector<NodeId> operands, unsigned low = 0) {
    Node made;
    made.op = op;
    made.width = width;
    made.operands = std::move(operands);
    made.low = low;
    if (below(3) == 0) made.name = "v" + std::to_string(n_.nodes.size() % 10);
    made.where = {"random.h", static_cast<unsigned>(n_.nodes.size())};
    return n_.add(std::move(made));
  }
  NodeId source(Op op, unsigned index, unsigned low, unsigned width) {
    Node made;
    made.op = op;
    made.width = width;
    made.port = index;
    made.low = low;
    return n_.add(std::move(made));
  }
  void field(Op op, unsigned index, unsigned from) {
    const unsigned low = from + below(n_.ports[index].width - from);
    pool_.push_back(source(op, index, low, 1 + below(n_.ports[index].width - low)));
  }
  NodeId constant(unsigned width) {
    Node made;
    made.width = width;
    const std::uint64_t values[] = {0, 1, ~std::uint64_t{0}, random_(), random_() % 8};
    made.value = Bits(width, values[below(5)]);
    return n_.add(std::move(made));
  }
  NodeId one() {
    Node made;
    made.width = 1;
    made.value = Bits(1, 1);
    return n_.add(std::move(made));
  }
  NodeId bit() { return sized(pick(), 1); }
  /// Any bits of a value, extended or cut to a width.
  NodeId sized(NodeId of, unsigned width) {
    const unsigned has = n_.nodes[of].width;
    if (has == width) return of;
    if (has > width) return node(Op::kSlice, width, {of}, below(has - width + 1));
    if (below(2) == 0) return node(Op::kSExt, width, {of});
    return node(Op::kConcat, width, {constant(width - has), of});
  }
  /// So wide that much of the netlist is looked at.
  NodeId wide(unsigned width) {
    NodeId all = sized(pool_[pool_.size() - 1], width);
    for (int i = 2; i < 12; ++i) {
      all = node(Op::kXor, width,
                 {all, sized(pool_[pool_.size() - static_cast<std::size_t>(i)], width)});
    }
    return all;
  }

  NodeId read(unsigned port, NodeId address) {
    const bool always = n_.ports[port].kind == PortKind::kRegisterFile || below(2) == 0;
    const NodeId enable = always ? one() : bit();
    n_.row_reads.push_back({port, enable, address});
    const unsigned width = n_.ports[port].width;
    const NodeId row = source(Op::kRow, static_cast<unsigned>(n_.row_reads.size() - 1), 0, width);
    if (always) {
      pool_.push_back(row);
      return row;
    }
    // Nobody may look at a row that was not read.
    Node zero;
    zero.width = width;
    zero.value = Bits(width, 0);
    const NodeId none = n_.add(std::move(zero));
    pool_.push_back(node(Op::kMux, width, {enable, row, none}));
    return pool_.back();
  }
  void write(unsigned port, NodeId address, NodeId data) {
    n_.row_writes.push_back({port, below(2) == 0 ? one() : bit(), address, data});
  }

  void operations(unsigned count) {
    for (unsigned i = 0; i < count; ++i) pool_.push_back(operation());
  }
  NodeId operation() {
    const NodeId a = pick();
    const unsigned w = n_.nodes[a].width > 40 ? 1 + below(40) : n_.nodes[a].width;
    const NodeId x = sized(a, w);
    const NodeId y = below(5) == 0 ? constant(w) : sized(pick(), w);
    switch (static_cast<Op>(static_cast<unsigned>(Op::kAdd) + below(20))) {
      case Op::kAdd:
        return node(Op::kAdd, w, {x, y});
      case Op::kSub:
        return node(Op::kSub, w, {x, y});
      case Op::kMul: {
        const unsigned wa = 1 + below(18);
        const unsigned wb = 1 + below(26);
        return node(Op::kMul, wa > wb ? wa + below(20) : wb + below(20),
                    {sized(pick(), wa), sized(pick(), wb)});
      }
      case Op::kUDiv: {
        // Division by zero is undefined.
        const unsigned divisor = 1 + below(10);
        const NodeId odd = node(Op::kOr, divisor, {sized(pick(), divisor), constant_one(divisor)});
        return node(Op::kUDiv, w, {x, odd});
      }
      case Op::kAnd:
        return node(Op::kAnd, w, {x, y});
      case Op::kOr:
        return node(Op::kOr, w, {x, y});
      case Op::kXor:
        return node(Op::kXor, w, {x, y});
      case Op::kNot:
        return node(Op::kNot, w, {x});
      case Op::kShl:
        return node(Op::kShl, w, {x, sized(pick(), 1 + below(7))});
      case Op::kLShr:
        return node(Op::kLShr, w, {x, sized(pick(), 1 + below(7))});
      case Op::kAShr:
        return node(Op::kAShr, w, {x, sized(pick(), 1 + below(7))});
      case Op::kEq:
        return node(Op::kEq, 1, {x, y});
      case Op::kULt:
        return node(Op::kULt, 1, {x, y});
      case Op::kSLt:
        return node(Op::kSLt, 1, {x, y});
      case Op::kSlice: {
        const unsigned low = below(w);
        return node(Op::kSlice, 1 + below(w - low), {x}, low);
      }
      case Op::kConcat:
        return node(Op::kConcat, 2 * w, {x, y});
      case Op::kSExt:
        return node(Op::kSExt, w + below(8), {x});
      case Op::kClz:
        return node(Op::kClz, 7, {x});
      case Op::kAddSub: {
        // As it comes out of an optimiser: an addition of a selected negation.
        const NodeId zero = node(Op::kXor, w, {x, x});
        const NodeId negated = node(Op::kSub, w, {zero, y});
        return node(Op::kAdd, w, {x, node(Op::kMux, w, {bit(), negated, y})});
      }
      default:
        return node(Op::kMux, w, {bit(), x, y});
    }
  }
  NodeId constant_one(unsigned width) {
    Node made;
    made.width = width;
    made.value = Bits(width, 1);
    return n_.add(std::move(made));
  }

  std::mt19937 random_;
  Netlist n_;
  NodeId id_ = kNoNode;
  std::vector<NodeId> pool_;
};

}  // namespace

Netlist random_netlist(std::uint32_t seed) { return Generator(seed).run(); }

Options random_options(std::uint32_t seed, const char* delay_folder) {
  const double clocks[] = {9, 9.5, 10, 14};
  const char* devices[] = {"ecp5.json", "ice40-hx.json"};
  Options options;
  options.delay = load_delay_model(std::string(delay_folder) + "/" + devices[seed / 4 % 2]);
  // Register files take a while, those of the iCE40 the longest.
  options.clock_ns = clocks[seed % 4] + (seed / 4 % 2 == 0 ? 0 : 6);
  return options;
}

}  // namespace hlsc
