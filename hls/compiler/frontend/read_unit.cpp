// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/read_unit.h"

#include <llvm/Support/raw_ostream.h>

#include "error.h"
#include "frontend/channels.h"
#include "frontend/flatten.h"
#include "frontend/indexing.h"
#include "frontend/llvm_passes.h"
#include "frontend/port_access.h"
#include "frontend/prepare.h"
#include "frontend/refusal_messages.h"
#include "frontend/retype_locals.h"
#include "frontend/transaction.h"
#include "frontend/translate.h"
#include "frontend/unroll.h"
#include "frontend/value_names.h"
#include "netlist/narrow.h"

namespace hlsc {
namespace {

// LLVM's passes between hlsc's own. The passes that are left out matter as much: no -O2 (SLP
// vectors, duplicated tails, serial select chains), no jump threading, no lookup tables.
constexpr char kInline[] = "always-inline,function(sroa,early-cse)";
constexpr char kFold[] =
    "simplifycfg<no-sink-common-insts>,instcombine<no-verify-fixpoint>,early-cse";
constexpr char kPromote[] = "sroa,early-cse";
constexpr char kSimplify[] =
    "sroa,early-cse,"
    "simplifycfg<speculate-unpredictables;hoist-common-insts;sink-common-insts;"
    "switch-range-to-icmp>,"
    "instcombine<no-verify-fixpoint>,gvn,instcombine<no-verify-fixpoint>,"
    "simplifycfg<speculate-unpredictables;hoist-common-insts;sink-common-insts;"
    "switch-range-to-icmp>,bdce,adce";
constexpr char kFlat[] =
    "instcombine<no-verify-fixpoint>,gvn,instcombine<no-verify-fixpoint>,bdce,early-cse,adce";

void refuse_no_effect(const Netlist& netlist) {
  bool effect = !netlist.token_writes.empty() || !netlist.row_writes.empty();
  for (const Register& state : netlist.registers) effect = effect || state.next != kNoNode;
  if (!effect) throw Error({netlist.source, 0}, messages::kNoEffect);
}

}  // namespace

const std::vector<std::string>& ir_passes() {
  static const std::vector<std::string> kPasses = {"inline",   "fold",     "unroll", "channels",
                                                   "indexing", "simplify", "names",  "flatten"};
  return kPasses;
}

UnitNetlist read_unit(const UnitSource& source) {
  Transaction t;
  t.context = std::make_unique<llvm::LLVMContext>();
  CompiledUnit compiled = compile_unit(source, *t.context);
  t.module = std::move(compiled.module);
  const SourceLines lines(source.folders);
  LlvmPasses passes;
  const auto after = [&source, &t](const char* pass) {
    if (source.print_after == pass) t.function->print(llvm::outs());
  };

  keep_annotations(*t.module);
  t.layout = read_layout(*t.module, lines);
  refuse_before_inlining(*t.module, lines);
  detach_from_target(*t.module);
  build_transaction(t);
  const auto resets = read_reset_values(t);
  passes.run(*t.module, kInline);
  after("inline");
  refuse_uninitialised(t, lines);
  passes.run(*t.function, kFold);
  after("fold");
  unroll_loops(t, passes, lines);
  after("unroll");
  refuse_after_inlining(t, lines);
  lower_channels(t, lines);
  passes.run(*t.function, kPromote);
  after("channels");
  while (expand_indexing(t, lines)) passes.run(*t.function, kPromote);
  after("indexing");
  passes.run(*t.function, kSimplify);
  // SROA would make bytes of them again before it promotes them.
  if (retype_locals(*t.function)) {
    passes.run(*t.function, "mem2reg");
    passes.run(*t.function, kSimplify);
  }
  after("simplify");
  name_values(*t.function, lines);
  hide_divisions(*t.function);
  drop_hints(*t.function);
  after("names");
  flatten(*t.function);
  passes.run(*t.function, kFlat);
  after("flatten");
  require_checks(t);

  UnitNetlist made{narrow(translate(t, resets, lines)), std::move(compiled.includes)};
  made.netlist.module = source.module;
  made.netlist.unit = source.unit;
  made.netlist.source = t.layout.source;
  check(made.netlist);
  refuse_no_effect(made.netlist);
  return made;
}

}  // namespace hlsc
