// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A packet whose stack keeps a few entries visits every leaf that it visits with a whole stack. The
// units of the loop walk random trees; rays that enter children at random, have ended behind a hit
// and lose children behind it stand in for the slices.
#include "units/restart_trail.h"

#include <array>
#include <limits>
#include <set>
#include <vector>

#include "units/list.h"
#include "units/node_fetch.h"
#include "units/packet_decision.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

constexpr unsigned kDepth = 12;

/// With whole stacks, as the rays of a packet may have origins of their own.
struct Whole : test::Fast<test::Config<8, 512, kDepth>> {};
template <class General, unsigned Entries>
struct Short : General {};

}  // namespace
template <class General, unsigned Entries>
inline constexpr unsigned kStackEntries<Short<General, Entries>> = Entries;
namespace {

struct TestNode {
  bool is_leaf = false;
  bool left_first = false;
  unsigned child[2] = {};          ///< left and right; 0: empty
  unsigned begin = 0, middle = 0;  ///< places of its first leaf and of the far child's, near first
  bool enters[kRays<Whole>][2] = {};  ///< by ray: the near and the far child
  unsigned hit[kRays<Whole>] = {};    ///< of a leaf, by ray: the place of its hit
};

/// Nodes from number 2 on, an even number for each, as lists have where pointers lead to them.
class RandomTree {
 public:
  RandomTree(std::uint64_t seed, unsigned hits) : random_(seed), hits_(hits) { add(kDepth); }

  static constexpr unsigned kRoot = 2;
  const TestNode& node(unsigned number) const { return nodes_.at(number / 2 - 1); }

 private:
  unsigned add(unsigned forks) {
    const unsigned number = 2 * (static_cast<unsigned>(nodes_.size()) + 1);
    nodes_.emplace_back();
    TestNode node;
    node.begin = places_;
    node.is_leaf = forks == 0 || (nodes_.size() > 8 && test::chance(random_, 20));
    node.left_first = test::chance(random_, 50);
    for (unsigned ray = 0; ray < kRays<Whole>; ++ray) {
      node.enters[ray][0] = test::chance(random_, 80);
      node.enters[ray][1] = test::chance(random_, 70) || !node.enters[ray][0];
      node.hit[ray] = test::chance(random_, hits_) ? places_ + test::below(random_, 9)
                                                   : std::numeric_limits<unsigned>::max();
    }
    if (node.is_leaf) {
      ++places_;
    } else {
      const bool is_fork = test::chance(random_, 85);
      const unsigned near = node.left_first ? 0 : 1;
      const bool has_near = is_fork || test::chance(random_, 50);
      if (has_near) node.child[near] = add(is_fork ? forks - 1 : forks - (nodes_.size() > 4000));
      node.middle = places_;
      if (is_fork || !has_near)
        node.child[1 - near] = add(forks - (is_fork || nodes_.size() > 4000));
    }
    nodes_[number / 2 - 1] = node;
    return number;
  }

  test::Random random_;
  unsigned hits_;
  unsigned places_ = 0;
  std::vector<TestNode> nodes_;
};

struct Visit {
  unsigned leaf, ray;
  friend auto operator<=>(const Visit&, const Visit&) = default;
};
struct Walked {
  std::vector<Visit> visits;
  std::array<unsigned, kRays<Whole>> hit;
  unsigned restarts = 0, dropped = 0;
};

/// The way of a packet through the loop of node fetch, decision and list.
template <class C>
class Walk {
 public:
  explicit Walk(const RandomTree& tree, unsigned level = 0) : tree_(tree), level_(level) {
    walked_.hit.fill(std::numeric_limits<unsigned>::max());
    TraversalEvent<C> enter;
    enter.packet = 3;
    enter.level = Level::from(level_);
    enter.kind = TraversalKind::kEnter;
    enter.next = NodeAddress<C>::from(RandomTree::kRoot);
    enter.active = RayMask<C>::ones();
    event(enter);
  }
  Walked walked() {
    for (unsigned steps = 0; !done_ && steps < 200'000; ++steps) event(next_);
    EXPECT_TRUE(done_) << "the traversal does not end";
    return walked_;
  }

 private:
  void event(const TraversalEvent<C>& e) {
    fetch_.feed(fetch_.unit.event, e);
    fetch_.run();
    walked_.dropped += fetch_.take(fetch_.unit.dropped).size();
    for (const TraversalEvent<C>& again : fetch_.take(fetch_.unit.again)) next_ = again;
    done_ =
        fetch_.take(fetch_.unit.top_done).size() + fetch_.take(fetch_.unit.object_done).size() > 0;
    for (const auto& request : fetch_.take(fetch_.unit.request)) {
      step(request.context, request.address);
      entered_ = true;
    }
  }
  void step(const StepContext<C>& context, NodeAddress<C> address) {
    const unsigned number =
        static_cast<unsigned>((is_list<C>(address) ? list_address<C>(address) : address).to_u64());
    const TestNode& node = tree_.node(number);
    if (entered_ && context.update == IntervalUpdate::kInit) ++walked_.restarts;
    Step<C> s;
    s.context = context;
    s.node.kind = node.is_leaf ? NodeKind::kLeaf : NodeKind::kSplitX;
    s.node.left = node.is_leaf ? NodeAddress<C>::from(number) : pointer(node.child[0]);
    s.node.right = pointer(node.child[1]);
    decision_.feed(decision_.unit.step_in, s);
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      decision_.feed(decision_.unit.slice[ray], of_ray(node, ray, context.update));
    }
    decision_.run();
    for (const TraversalEvent<C>& e : decision_.take(decision_.unit.event)) next_ = e;
    for (const ListJob<C>& job : decision_.take(decision_.unit.leaf)) leaf(job);
  }
  NodeAddress<C> pointer(unsigned child) const {
    const bool list = child != 0 && tree_.node(child).is_leaf;
    return list ? NodeAddress<C>::from((1u << (C::kAddressBits - 1)) | (child / 2))
                : NodeAddress<C>::from(child);
  }
  SliceDecision of_ray(const TestNode& node, unsigned ray, IntervalUpdate update) const {
    const unsigned hit = walked_.hit[ray];
    const bool near = node.enters[ray][0];
    const bool far = node.enters[ray][1] && hit >= node.middle;
    return {node.left_first, node.left_first ? near : far, node.left_first ? far : near,
            update != IntervalUpdate::kInit && hit < node.begin};
  }
  void leaf(const ListJob<C>& job) {
    const unsigned number = static_cast<unsigned>(job.address.to_u64());
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      if (!job.active.get().bit(ray)) continue;
      walked_.visits.push_back({number, ray});
      walked_.hit[ray] = std::min(walked_.hit[ray], tree_.node(number).hit[ray]);
    }
    const std::size_t row = 8 * level_ + 3;
    list_.rows(list_.unit.last)[row] = true;
    list_.rows(list_.unit.after)[row] = decision_.rows(decision_.unit.after)[row];
    ListJob<C> at_end;
    at_end.packet = 3;
    at_end.level = Level::from(level_);
    list_.feed(list_.unit.job, at_end);
    list_.run();
    next_ = list_.take_one(list_.unit.finished);
  }

  const RandomTree& tree_;
  unsigned level_;
  test::UnitBench<NodeFetch<C>> fetch_;
  test::UnitBench<PacketDecision<C>> decision_;
  test::UnitBench<List<C>> list_;
  TraversalEvent<C> next_;
  bool entered_ = false, done_ = false;
  Walked walked_;
};

template <class General, unsigned Entries>
void expect_the_visits_of_a_whole_stack(unsigned hits, unsigned level = 0) {
  unsigned restarts = 0;
  std::size_t visits = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RandomTree tree(seed, hits);
    const Walked whole = Walk<General>(tree, level).walked();
    const Walked few = Walk<Short<General, Entries>>(tree, level).walked();
    ASSERT_EQ(whole.restarts + whole.dropped + few.dropped, 0u);
    restarts += few.restarts;
    visits += whole.visits.size();
    if (hits == 0) {
      ASSERT_EQ(few.visits, whole.visits) << "tree " << seed << ": no leaf is visited again";
    }
    ASSERT_EQ(few.hit, whole.hit) << "tree " << seed;
    const std::set<Visit> visited(few.visits.begin(), few.visits.end());
    for (const Visit& visit : whole.visits) {
      ASSERT_TRUE(visited.contains(visit))
          << "tree " << seed << ": ray " << visit.ray << " misses leaf " << visit.leaf;
    }
  }
  EXPECT_GT(restarts, 200u);
  EXPECT_GT(visits, 2000u);
}

TEST(RestartTrail, APacketVisitsTheLeavesThatItVisitsWithAWholeStack) {
  for (const unsigned hits : {0, 5, 30}) {
    expect_the_visits_of_a_whole_stack<Whole, 2>(hits);
    expect_the_visits_of_a_whole_stack<Whole, 4>(hits);
  }
}

TEST(RestartTrail, AndInAnObject) { expect_the_visits_of_a_whole_stack<Whole, 2>(5, 1); }

struct Shallow : Whole {
  static constexpr unsigned kStackDepth = 5;
};

TEST(RestartTrail, ATreeThatIsTooDeepDropsPushesAndComesToItsEnd) {
  unsigned dropped = 0, restarts = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RandomTree tree(seed, 5);
    for (const unsigned level : {0, 1}) {
      const Walked walked = Walk<Short<Shallow, 2>>(tree, level).walked();
      dropped += walked.dropped;
      restarts += walked.restarts;
    }
  }
  EXPECT_GT(dropped, 200u);
  EXPECT_GT(restarts, 200u);
}

}  // namespace
}  // namespace dynrt
