// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "emit/verilog_writer.h"
#include "netlist/op.h"

namespace hlsc {
namespace {

/// The bits of a token that its FIFO must hold: each bit that is not constant, once.
struct Stored {
  std::vector<BitRef> bits;
  std::vector<BitRef> token;  ///< the whole token, of constants and of bits of `held`
};

Stored stored(const std::vector<BitRef>& data, CellId held) {
  Stored s;
  for (const BitRef b : data) {
    auto found = std::find(s.bits.begin(), s.bits.end(), b);
    if (!b.is_constant() && found == s.bits.end()) found = s.bits.insert(found, b);
    const auto number = static_cast<unsigned>(found - s.bits.begin());
    s.token.push_back(b.is_constant() ? b : BitRef{held, number});
  }
  if (s.bits.empty()) s.bits.push_back(data.front());  // a FIFO has a width
  return s;
}

}  // namespace

void VerilogWriter::write_register(unsigned index) {
  const CellId read = c_.register_read[index];
  if (read == BitRef::kConstant) return;
  const Register& r = n_.registers[index];
  const std::string name = stems_[read] + "_q";
  const CellId write = c_.register_write[index];
  if (write == BitRef::kConstant) {
    out("  always @(posedge clk_i) {} <= {};\n", name, literal(r.reset));
    return;
  }
  out("  always @(posedge clk_i) begin\n    if (!rst_ni) {} <= {};\n    else if ({}) {} <= {};\n"
      "  end\n",
      name, literal(r.reset), valid(stage(write)), name, bits(write, 0));
}

void VerilogWriter::write_port(unsigned index) {
  const Port& p = n_.ports[index];
  switch (p.kind) {
    case PortKind::kOut:
      write_fifo(index);
      break;
    case PortKind::kRam:
    case PortKind::kRegisterFile:
      write_ram(index);
      break;
    case PortKind::kRamRead:
    case PortKind::kRamWrite:
      write_ram_end(index);
      break;
    case PortKind::kIn:
      covered_[p.name + "_data_i"].resize(p.width);
      break;
    case PortKind::kConfig:
      covered_[p.name + "_i"].resize(p.width);
      break;
  }
}

void VerilogWriter::write_fifo(unsigned index) {
  const Port& p = n_.ports[index];
  CellId write = 0;
  if (find(CellKind::kTokenWrite, index, write) == nullptr) {
    out("  assign {0}_valid_o = 1'b0;\n  assign {0}_data_o = {1};\n", p.name,
        literal(Bits(p.width, 0)));
    unused_.push_back(p.name + "_ready_i");
    unused_.push_back(fmt::format("{}_DEPTH[0]", upper(p.name)));
    unused_.push_back(fmt::format("{}_BOUNDED[0]", upper(p.name)));
    return;
  }
  const Stored kept = stored(c_.cells[write].operands[1], write);
  const auto width = static_cast<unsigned>(kept.bits.size());
  const bool all = width == p.width;
  const std::string from = p.name + (all ? "_data_o" : "_stored");
  if (!all) {
    out("  wire {}{};\n", bit_range(width), from);
    expressions_.declare(write, stage(write), {from, 0, width - 1, 0, width == 1});
  }
  out("  hls_fifo #(.WIDTH({0}), .DEPTH({1}_DEPTH), .MARGIN({1}_BOUNDED ? 0 : {2}),\n"
      "    .BOUNDED({1}_BOUNDED)) {3}_fifo (\n"
      "    .clk_i(clk_i), .rst_ni(rst_ni),\n"
      "    .valid_i({4}), .ready_o({3}_room),\n    .data_i({5}),\n"
      "    .valid_o({3}_valid_o), .ready_i({3}_ready_i), .data_o({6}));\n",
      width, upper(p.name), schedule_.stages - 1, p.name, enabled(write),
      all ? bits(write, 1) : expressions_.bits(kept.bits, stage(write)), from);
  if (!all) {
    out("  assign {}_data_o = {};\n", p.name, expressions_.bits(kept.token, stage(write)));
  }
}

void VerilogWriter::write_ram(unsigned index) {
  const Port& p = n_.ports[index];
  CellId read = 0;
  if (find(CellKind::kRowRead, index, read) == nullptr) return;  // nobody looks at it
  const unsigned address = address_width(p.rows);
  std::string write_pins = fmt::format(".write_en_i(1'b0), .write_addr_i({}), .write_data_i({})",
                                       literal(Bits(address, 0)), literal(Bits(p.width, 0)));
  const std::string read_enable = enabled(read);
  const std::string read_address = bits(read, 1);
  CellId write = 0;
  const bool written = find(CellKind::kRowWrite, index, write) != nullptr;
  if (written) {
    const std::string enable = enabled(write);
    const std::string to = bits(write, 1);
    out("  wire {0}_write = {1};\n  wire {2}{0}_write_addr = {3};\n", p.name, enable,
        bit_range(address), to);
    write_pins = fmt::format(
        ".write_en_i({0}_write), .write_addr_i({0}_write_addr),\n    .write_data_i({1})", p.name,
        bits(write, 2));
  }
  covered_[p.name + "_row"].resize(p.width);
  if (p.kind == PortKind::kRegisterFile) {
    out("  hls_register_file #(.WIDTH({}), .ROWS({})) {}_file (\n"
        "    .clk_i(clk_i), .rst_ni(rst_ni),\n    {},\n    .read_addr_i({}), "
        ".read_data_o({}_row));\n",
        p.width, p.rows, p.name, write_pins, read_address, p.name);
    return;
  }
  out("  wire {0}_read = {1};\n  wire {2}{0}_read_addr = {3};\n", p.name, read_enable,
      bit_range(address), read_address);
  out("  hls_ram_1r1w #(.WIDTH({0}), .ROWS({1}){4}) {2}_ram (\n"
      "    .clk_i(clk_i), .rst_ni(rst_ni),\n    {3},\n"
      "    .read_en_i({2}_read), .read_addr_i({2}_read_addr), .read_data_o({2}_row));\n",
      p.width, p.rows, p.name, write_pins,
      hls::asks_for_block_ram(p.width, p.rows) ? ", .BLOCK(1)" : "");
  if (written) assert_exclusive(p, address, stage(write) - stage(read));
}

void VerilogWriter::assert_exclusive(const Port& p, unsigned address, int distance) {
  out("`ifdef HLS_ASSERT\n"
      "  reg [{1}:0] {0}_reads [1:{2}];  // enables and addresses of the clocks before\n"
      "  integer {0}_i;\n"
      "  always @(posedge clk_i) begin\n"
      "    {0}_reads[1] <= {{{0}_read, {0}_read_addr}};\n"
      "    for ({0}_i = 2; {0}_i <= {2}; {0}_i = {0}_i + 1) begin\n"
      "      {0}_reads[{0}_i] <= {0}_reads[{0}_i-1];\n"
      "    end\n"
      "    for ({0}_i = 0; {0}_i < {2}; {0}_i = {0}_i + 1) begin\n"
      "      if (rst_ni && {0}_write && {{1'b1, {0}_write_addr}} ==\n"
      "          ({0}_i == 0 ? {{{0}_read, {0}_read_addr}} : {0}_reads[{0}_i])) begin\n"
      "        $display(\"%m: row %0d of {0} is read again before it is written\",\n"
      "                 {0}_write_addr);\n"
      "        $stop;\n"
      "      end\n    end\n  end\n`endif\n",
      p.name, address, distance);
}

void VerilogWriter::write_ram_end(unsigned index) {
  const Port& p = n_.ports[index];
  const bool is_read = p.kind == PortKind::kRamRead;
  CellId access = 0;
  const bool used =
      find(is_read ? CellKind::kRowRead : CellKind::kRowWrite, index, access) != nullptr;
  out("  assign {}_en_o = {};\n", p.name, used ? enabled(access) : "1'b0");
  out("  assign {}_addr_o = {};\n", p.name,
      used ? bits(access, 1) : literal(Bits(address_width(p.rows), 0)));
  if (is_read) {
    covered_[p.name + "_data_i"].resize(p.width);
  } else {
    out("  assign {}_data_o = {};\n", p.name, used ? bits(access, 2) : literal(Bits(p.width, 0)));
  }
}

}  // namespace hlsc
