// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Register minimisation as a linear program over difference constraints. The variables are the
// stages of the cells and, for every group of bits that the same cells use, the last stage in which
// it is used; the cost is the sum over the groups of width times (last use - birth). Where a path
// from u to v takes longer than a stage, stage(v) >= stage(u) + 1. Its dual is a minimum-cost flow
// (C. Leiserson, J. Saxe, "Retiming Synchronous Circuitry", Algorithmica 6, 1991, whose registers
// shared by several users are our groups), solved by LEMON's network simplex (Z. Kiraly, P. Kovacs,
// "Efficient Implementations of Minimum-Cost Flow Algorithms", 2012). That scheduling is a system
// of difference constraints: J. Cong, Z. Zhang, "An Efficient and Versatile Scheduling Algorithm
// Based on SDC Formulation", DAC 2006. Such pairs are found beforehand for single paths. Packing
// and joining paths may violate others: timing the solution finds them, and they are added until
// there are none.
#include <lemon/list_graph.h>
#include <lemon/network_simplex.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "schedule/schedule.h"

namespace hlsc {
namespace {

struct Group {
  CellId of;
  std::vector<CellId> users;
  long width;
};

std::vector<Group> bit_groups(const Circuit& c) {
  std::vector<std::vector<CellId>> users(c.bits);
  for (CellId id = 0; id < c.cells.size(); ++id) {
    for (const auto& operand : c.cells[id].operands) {
      for (const BitRef& b : operand) {
        if (b.is_constant()) continue;
        auto& list = users[c.cells[b.cell].first_bit + b.bit];
        if (list.empty() || list.back() != id) list.push_back(id);
      }
    }
  }
  std::vector<Group> groups;
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const Cell& cell = c.cells[id];
    if (c.still[id]) continue;
    std::map<std::vector<CellId>, long> count;
    for (unsigned i = 0; i < cell.width; ++i) ++count[users[cell.first_bit + i]];
    for (const auto& [list, width] : count) {
      if (!list.empty()) groups.push_back({id, list, width});
    }
  }
  return groups;
}

class Minimiser {
 public:
  Minimiser(const Circuit& circuit, const DelayModel& delay, double clock_ns, const Schedule& asap)
      : c_(circuit),
        available_(clock_ns - delay.clock_overhead),
        timing_(circuit, delay),
        last_(asap.stages - 1),
        schedule_(asap),
        asap_(asap.stage),
        groups_(bit_groups(circuit)),
        apart_(circuit.cells.size()) {}

  Schedule run() {
    pairs_ = precedences(c_, timing_);
    find_long_paths();
    for (;;) {
      solve();
      if (!add_violations()) return schedule_;
    }
  }

 private:
  /// False if the first schedule has the two nearer to each other than these stages.
  bool keep_apart(CellId of, CellId user, int stages) {
    if (asap_[user] - asap_[of] < stages) return false;
    apart_[of].insert(user);
    pairs_.push_back({of, user, stages});
    return true;
  }

  /// For each cell, the nearest ones behind it that cannot share a stage with it; for a block,
  /// those too that cannot be in the stage behind it.
  void find_long_paths() {
    std::vector<int> stage(c_.cells.size(), kElsewhere);
    for (CellId id = 0; id < c_.cells.size(); ++id) timing_.evaluate(id, stage);
    for (CellId first = static_cast<CellId>(c_.cells.size()); first-- > 0;) {
      if (c_.still[first]) continue;
      find_long_paths(first, {first}, 1, stage);
      if (!timing_.is_block(first)) continue;
      stage[first] = 0;
      find_long_paths(first, {c_.users[first].begin(), c_.users[first].end()}, 2, stage);
      stage[first] = kElsewhere;
    }
  }

  /// In stage 1 are the `open` cells and what they lead to, as far as the clock allows. `stage` is
  /// as before at the end.
  void find_long_paths(CellId first, std::set<CellId> open, int stages, std::vector<int>& stage) {
    std::vector<CellId> cone;
    while (!open.empty()) {
      const CellId id = *open.begin();
      open.erase(open.begin());
      stage[id] = 1;
      cone.push_back(id);
      if (timing_.evaluate(id, stage) > available_ && id != first) {
        stage[id] = kElsewhere;
        if (stages > 1 || !implied(first, id)) keep_apart(first, id, stages);
        continue;
      }
      for (const CellId user : c_.users[id]) {
        if (timing_.separation(id, user) == 0) open.insert(user);
      }
    }
    for (const CellId id : cone) stage[id] = kElsewhere;
  }

  bool implied(CellId of, CellId user) const {
    for (const CellId next : c_.users[of]) {
      if (apart_[next].contains(user)) return true;
    }
    return false;
  }

  void solve() {
    using Graph = lemon::ListDigraph;
    Graph graph;
    std::vector<Graph::Node> variable;
    for (std::size_t i = 0; i < c_.cells.size(); ++i) variable.push_back(graph.addNode());
    const Graph::Node zero = graph.addNode();
    Graph::ArcMap<long> cost(graph);
    const auto at_least = [&](Graph::Node user, Graph::Node of, long distance) {
      cost[graph.addArc(of, user)] = -distance;
    };
    for (const Precedence& p : pairs_) at_least(variable[p.user], variable[p.of], p.distance);
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      const CellKind kind = c_.cells[id].kind;
      at_least(variable[id], zero, kind == CellKind::kTokenWrite ? last_ : 0);
      at_least(zero, variable[id], kind == CellKind::kToken || c_.still[id] ? 0 : -last_);
      if (!pinned_.contains(id) || c_.still[id]) continue;
      at_least(variable[id], zero, asap_[id]);
      at_least(zero, variable[id], -asap_[id]);
    }
    std::vector<Graph::Node> last_use;
    for (const Group& group : groups_) {
      const Graph::Node end = graph.addNode();
      last_use.push_back(end);
      at_least(end, variable[group.of], 0);
      for (const CellId user : group.users) at_least(end, variable[user], 0);
    }
    // Variables' weights in the objective are the flow that their nodes consume.
    Graph::NodeMap<long> supply(graph, 0);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      supply[last_use[i]] -= groups_[i].width;
      supply[variable[groups_[i].of]] += groups_[i].width;
    }
    lemon::NetworkSimplex<Graph, long> simplex(graph);
    simplex.costMap(cost).supplyMap(supply);
    if (simplex.run() != decltype(simplex)::OPTIMAL) {
      throw std::logic_error("schedule: the linear program has no solution");
    }
    const long origin = simplex.potential(zero);
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.still[id]) continue;
      schedule_.stage[id] = static_cast<int>(origin - simplex.potential(variable[id]));
    }
  }

  /// Keeps the ends of paths apart that do not fit the stages of the solution.
  bool add_violations() {
    bool found = false;
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.still[id]) continue;
      if (timing_.evaluate(id, schedule_.stage) <= available_) continue;
      const std::vector<CellId> path = critical_path(id);
      found = true;
      const int stages = schedule_.stage[path.front()] < schedule_.stage[id] ? 2 : 1;
      if (keep_apart(path.front(), id, stages)) continue;
      pin(path);
      return true;
    }
    return found;
  }

  /// The cells of this stage on the latest path to a cell, and the block in the stage before if the
  /// path starts at one.
  std::vector<CellId> critical_path(CellId id) const {
    std::vector<CellId> path{id};
    for (BitRef from = timing_.critical_input(id); !from.is_constant();
         from = timing_.critical_input(from)) {
      path.insert(path.begin(), from.cell);
      if (schedule_.stage[from.cell] < schedule_.stage[id]) break;
    }
    return path;
  }

  /// Where packing was luckier in the first schedule, its stages are kept.
  void pin(const std::vector<CellId>& path) {
    bool any = false;
    for (const CellId id : path) any = pinned_.insert(id).second || any;
    if (any) return;
    const int stage = asap_[path.back()];
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (asap_[id] != stage && schedule_.stage[id] != stage) continue;
      any = pinned_.insert(id).second || any;
    }
    if (!any) throw std::logic_error("schedule: the first schedule misses the clock");
  }

  const Circuit& c_;
  double available_;
  Timing timing_;
  int last_;
  Schedule schedule_;
  std::vector<int> asap_;
  std::vector<Group> groups_;
  std::vector<Precedence> pairs_;
  std::vector<std::set<CellId>> apart_;
  std::set<CellId> pinned_;
};

}  // namespace

Schedule minimise_registers(const Circuit& circuit, const DelayModel& delay, double clock_ns,
                            const Schedule& asap) {
  return Minimiser(circuit, delay, clock_ns, asap).run();
}

unsigned long register_bits(const Circuit& circuit, const Schedule& schedule) {
  unsigned long bits = 0;
  for (const Group& group : bit_groups(circuit)) {
    int last = schedule.stage[group.of];
    for (const CellId user : group.users) last = std::max(last, schedule.stage[user]);
    bits += static_cast<unsigned long>(group.width) *
            static_cast<unsigned long>(last - schedule.stage[group.of]);
  }
  return bits;
}

}  // namespace hlsc
