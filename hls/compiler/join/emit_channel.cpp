// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "join/emit_channel.h"

#include <fmt/format.h>

#include <stdexcept>

namespace hlsc {
namespace {

using hls::ChannelKind;
using hls::ChannelRecord;
using hls::JoinRecord;
using hls::PortKind;
using hls::PortRecord;
using hls::UnitRecord;

class Channel {
 public:
  Channel(const JoinRecord& join, TopText& top) : join_(join), top_(top) {}

  void connect(const ChannelRecord& c) {
    std::string source = c.name + "_all";  // the stream after arbiter and repeater
    if (c.kind != ChannelKind::kInput) {
      top_.stream(source, c.width);
      top_.write("\n  // channel {}\n", c.name);
      merge(c, source);
      if (c.kind == ChannelKind::kRepeat) source = repeat(c, source);
    }
    switch (c.kind) {
      case ChannelKind::kInput: {
        top_.port("  input  wire {}_valid_i", c.name);
        top_.port("  output wire {}_ready_o", c.name);
        top_.port("  input  wire {}{}_data_i", range(c.width), c.name);
        const std::string to = wire(c.to.front());
        top_.stream(to, c.width);
        top_.write(
            "\n  // channel {0}\n  assign {1}_valid = {0}_valid_i && !join_reset_q;\n"
            "  assign {0}_ready_o = {1}_ready && !join_reset_q;\n"
            "  assign {1}_data = {0}_data_i;\n",
            c.name, to);
        return;
      }
      case ChannelKind::kOutput:
        top_.port("  output wire {}_valid_o", c.name);
        top_.port("  input  wire {}_ready_i", c.name);
        top_.port("  output wire {}{}_data_o", range(c.width), c.name);
        top_.write(
            "  assign {0}_valid_o = {1}_valid;\n  assign {1}_ready = {0}_ready_i;\n"
            "  assign {0}_data_o = {1}_data;\n",
            c.name, source);
        return;
      case ChannelKind::kSink:
        top_.write("  assign {0}_ready = 1'b1;\n  wire {0}_unused = &{{1'b0, {0}_data}};\n",
                   source);
        return;
      default:
        deliver(c, source);
    }
  }

 private:
  void merge(const ChannelRecord& c, const std::string& source) {
    for (const std::string& port : c.from) top_.stream(wire(port), c.width);
    if (c.from.size() == 1) {
      const std::string from = wire(c.from.front());
      pass(from, source, from);
      return;
    }
    const std::string merged = c.name + "_merged";
    top_.stream(merged, c.width);
    top_.write(
        "  hls_arbiter #(.INPUTS({0}), .WIDTH({1})) {2}_arbiter (\n"
        "    .clk_i(clk_i), .rst_ni(!join_reset_q),\n"
        "    .valid_i({3}),\n    .ready_o({4}),\n    .data_i({5}),\n"
        "    .valid_o({6}_valid), .ready_i({6}_ready), .data_o({6}_data));\n",
        c.from.size(), c.width, c.name, concatenation(wires(c.from, "_valid")),
        concatenation(wires(c.from, "_ready")), concatenation(wires(c.from, "_data")), merged);
    buffer(merged, source, c.width);
  }

  void buffer(const std::string& from, const std::string& to, unsigned width) {
    top_.write(
        "  hls_buffer #(.WIDTH({0})) {2}_buffer (\n"
        "    .clk_i(clk_i), .rst_ni(!join_reset_q),\n"
        "    .valid_i({1}_valid), .ready_o({1}_ready), .data_i({1}_data),\n"
        "    .valid_o({2}_valid), .ready_i({2}_ready), .data_o({2}_data));\n",
        width, from, to);
  }

  /// A repeated job has its number and a last flag below it.
  std::string repeat(const ChannelRecord& c, const std::string& source) {
    const std::string repeated = c.name + "_repeated";
    top_.stream(repeated, c.width + c.repeat_width + 1);
    top_.write(
        "  hls_repeat #(.WIDTH({0}), .COUNT_WIDTH({1})) {2}_repeat (\n"
        "    .clk_i(clk_i), .rst_ni(!join_reset_q),\n"
        "    .valid_i({3}_valid), .ready_o({3}_ready), .data_i({3}_data),\n"
        "    .valid_o({4}_valid), .ready_i({4}_ready), .data_o({4}_data));\n",
        c.width, c.repeat_width, c.name, source, repeated);
    return repeated;
  }

  void deliver(const ChannelRecord& c, const std::string& source) {
    const unsigned width = c.kind == ChannelKind::kRepeat ? c.width + c.repeat_width + 1 : c.width;
    for (const std::string& port : c.to) top_.stream(wire(port), width);
    if (c.to.size() > 1) {
      fork(c, source, width);
    } else if (c.kind != ChannelKind::kRepeat && waits_for_others(c.to.front())) {
      // So that no path leads from all the writers of a unit's channels to all of them.
      buffer(source, wire(c.to.front()), width);
    } else {
      pass(source, wire(c.to.front()), source);
    }
  }

  /// Every branch of a fork has a queue of its own, so that one reader may run ahead of another.
  void fork(const ChannelRecord& c, const std::string& source, unsigned width) {
    std::vector<std::string> branches;
    for (const std::string& port : c.to) branches.push_back(wire(port) + "_branch");
    for (const std::string& branch : branches) {
      top_.declare("  wire {0}_valid, {0}_ready;\n", branch);
    }
    top_.declare("  wire {}{}_branch_data;\n", range(width), c.name);
    std::vector<std::string> valid, ready;
    for (const std::string& branch : branches) {
      valid.push_back(branch + "_valid");
      ready.push_back(branch + "_ready");
    }
    top_.write(
        "  hls_fork #(.OUTPUTS({0}), .WIDTH({1})) {2}_fork (\n"
        "    .valid_i({3}_valid), .ready_o({3}_ready), .data_i({3}_data),\n"
        "    .valid_o({4}),\n    .ready_i({5}),\n    .data_o({2}_branch_data));\n",
        c.to.size(), width, c.name, source, concatenation(valid), concatenation(ready));
    for (std::size_t i = 0; i < c.to.size(); ++i) {
      const std::string to = wire(c.to[i]);
      if (waits_for_others(c.to[i])) {
        if (c.depth == 0) {
          throw std::invalid_argument(
              fmt::format("channel '{}' forks to '{}', which also waits for other tokens; give the "
                          "number of tokens that the channel can hold",
                          c.name, c.to[i]));
        }
        top_.write(
            "  hls_fifo #(.WIDTH({0}), .DEPTH({1}), .MARGIN(0)) {2}_queue (\n"
            "    .clk_i(clk_i), .rst_ni(!join_reset_q),\n"
            "    .valid_i({3}_valid), .ready_o({3}_ready), .data_i({4}_branch_data),\n"
            "    .valid_o({2}_valid), .ready_i({2}_ready), .data_o({2}_data));\n",
            width, c.depth, to, branches[i], c.name);
      } else {
        pass(branches[i], to, c.name + "_branch");
      }
    }
  }

  /// The tokens of one stream go to another, with the data of a third that may be the first.
  void pass(const std::string& from, const std::string& to, const std::string& data) {
    top_.write(
        "  assign {0}_valid = {1}_valid;\n  assign {1}_ready = {0}_ready;\n"
        "  assign {0}_data = {2}_data;\n",
        to, from, data);
  }

  /// Whether a reading port belongs to a unit that needs other tokens to take this one.
  bool waits_for_others(const std::string& port) const {
    const UnitRecord& unit = unit_of(port);
    unsigned inputs = 0;
    for (const PortRecord& p : unit.ports) inputs += p.type.kind == PortKind::kIn;
    return inputs > 1;
  }
  const UnitRecord& unit_of(const std::string& port) const {
    for (const UnitRecord& unit : join_.units) {
      if (port.compare(0, unit.name.size() + 1, unit.name + ".") == 0) return unit;
    }
    throw std::logic_error("no unit has port " + port);
  }

  const JoinRecord& join_;
  TopText& top_;
};

}  // namespace

void emit_channel(const JoinRecord& join, const ChannelRecord& channel, TopText& top) {
  Channel(join, top).connect(channel);
}

}  // namespace hlsc
