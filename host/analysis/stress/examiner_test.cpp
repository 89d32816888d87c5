// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The judge is judged: a board that lies about its hits is found out, each lie by its name. And the
// table of cases: how many, named apart, told when asked for one that is not there.
#include "host/analysis/stress/examiner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/run.h"
#include "host/analysis/stress/shapes.h"
#include "host/board/configurations.h"
#include "units/memory_format.h"

namespace dynrt::host::stress {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr std::uint32_t kHitBit = 1u << 31;  ///< of the third word of a record in bank 4

/// Changes the words of a record as they are read back: bank 4's or 5's.
using Lie = std::function<void(unsigned bank, std::span<std::uint32_t> record)>;

class LyingBoard final : public Board {
 public:
  explicit LyingBoard(Lie lie)
      : LyingBoard(make_board(configurations(), {"model", "thesis", ""}), std::move(lie)) {}
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    board_->write(bank, address, words);
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    board_->read(bank, address, words);
    if (bank < kHitBank) return;
    for (std::size_t i = 0; i < words.size(); i += kHitWords) {
      lie_(bank, words.subspan(i, kHitWords));
    }
  }
  void configure(const FrameConfig& config) override { board_->configure(config); }
  void start() override { board_->start(); }
  FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) override {
    return board_->wait(timeout, progress);
  }
  std::vector<Counter> counters() override { return board_->counters(); }

 private:
  LyingBoard(std::unique_ptr<Board> board, Lie lie)
      : Board(board->name(), board->core()), board_(std::move(board)), lie_(std::move(lie)) {}

  std::unique_ptr<Board> board_;
  Lie lie_;
};

/// Two walls one behind the other, rays of which one half passes beside them.
Trial walls() {
  Mesh mesh = wall(2, 1.0, 1.0);
  add_quad(mesh, {-8, -8, 2}, {16, 0, 0}, {0, 8, 0});
  return {.scene = scene_of(mesh),
          .shots = {pencil({0, 0, 0}, {-0.75, 0.25, 1}, {0.25, 0, 0}, {0, 0.25, 0}, 7, 6)}};
}

Outcome outcome_of(const Lie& lie) {
  Boards boards([&](const std::string&) { return std::make_unique<LyingBoard>(lie); }, "thesis");
  Examiner examiner(boards);
  examiner.check(walls());
  return examiner.outcome();
}

constexpr std::uint64_t kRays = 42;
constexpr std::uint64_t kHits = 28;

TEST(Examiner, FindsNothingWrongWithTheModel) {
  const Outcome outcome = outcome_of([](unsigned, std::span<std::uint32_t>) {});
  EXPECT_EQ(outcome.rays, kRays);
  EXPECT_EQ(outcome.hits, kHits);
  EXPECT_TRUE(within(outcome, {.distance = 1e-9}));
  EXPECT_EQ(text_of(outcome, {}), "nothing wrong");
}

TEST(Examiner, FindsHitsLostAndInvented) {
  const Outcome outcome = outcome_of([](unsigned bank, std::span<std::uint32_t> record) {
    if (bank == kHitBank) record[2] ^= kHitBit;
  });
  EXPECT_EQ(outcome[Fault::kLost], kHits);
  EXPECT_EQ(outcome[Fault::kInvented], kRays - kHits);
  EXPECT_FALSE(within(outcome, {.lost = kHits, .invented = kRays - kHits - 1}));
  EXPECT_TRUE(within(outcome, {.lost = kHits, .invented = kRays - kHits}));
  EXPECT_EQ(text_of(outcome, {.lost = 3}), "lost 28 (of 3 allowed), invented 14 (of 0 allowed)");
}

TEST(Examiner, FindsTheTriangleBehind) {
  // Triangles 0 and 1 are the wall in front, 2 and 3 the one behind.
  const Outcome outcome = outcome_of([](unsigned bank, std::span<std::uint32_t> record) {
    if (bank == kHitBank + 1) record[2] += 2;
  });
  EXPECT_EQ(outcome[Fault::kWrong], kHits);
  EXPECT_EQ(outcome[Fault::kLost], 0u);
}

TEST(Examiner, FindsADistanceThatIsOff) {
  const Outcome outcome = outcome_of([](unsigned bank, std::span<std::uint32_t> record) {
    if (bank == kHitBank) record[0] += 1u << 10;  // 2^-6 of it
  });
  EXPECT_EQ(outcome.distance, 0x1p-6);
  EXPECT_FALSE(within(outcome, {}));
  EXPECT_TRUE(within(outcome, {.distance = 0x1p-6}));
}

TEST(Examiner, FindsOtherBits) {
  unsigned reads = 0;
  Boards boards(
      [&](const std::string&) {
        return std::make_unique<LyingBoard>([&](unsigned bank, std::span<std::uint32_t> record) {
          if (bank == kHitBank && ++reads == kRays + 1) record[1] ^= 1;
        });
      },
      "thesis");
  Examiner examiner(boards);
  const Rendered first = examiner.render(walls());
  examiner.expect_same(examiner.render(walls()), first);
  EXPECT_EQ(examiner.outcome()[Fault::kDifferent], 1u);
  EXPECT_FALSE(within(examiner.outcome(), {.lost = kRays}));
}

TEST(Examiner, CountsWhatTheHostShouldHaveRefused) {
  Boards boards([&](const std::string&) { return std::make_unique<LyingBoard>([](auto, auto) {}); },
                "thesis");
  Examiner examiner(boards);
  examiner.expect_refusal(walls(), "too many walls");
  EXPECT_EQ(examiner.outcome()[Fault::kAccepted], kRays);
}

/// Has the thesis's board alone; the others fail as the given function does.
Boards thesis_and(const OpenBoard& others) {
  return {[others](const std::string& name) {
            if (name != "thesis") return others(name);
            return make_board(configurations(), {"model", name, ""});
          },
          "thesis"};
}

TEST(Boards, OneThatCannotBeMadeIsNeitherLackingNorARefusal) {
  const std::vector<std::string> needs_whitted = {"ends/light_at_surface"};
  const Case& c = *find_cases(needs_whitted).at(0);
  Boards lacking = thesis_and([](const std::string&) { return nullptr; });
  EXPECT_THAT([&] { run_case(c, lacking); },
              ThrowsMessage<NoBoard>("this build's table of configurations lacks 'whitted'"));
  Boards broken = thesis_and([](const std::string& name) -> std::unique_ptr<Board> {
    throw UserError(name + ": the compiler failed");
  });
  try {
    run_case(c, broken);
    ADD_FAILURE() << "the failure is taken for a result";
  } catch (const NoBoard& error) {
    ADD_FAILURE() << "tests would skip: " << error.what();
  } catch (const BoardError& error) {
    EXPECT_STREQ(error.what(), "whitted: the compiler failed");
  }
}

TEST(Run, SaysWhereThereIsNoBound) {
  Result result{&cases()[0], {}, {}, ""};
  result.outcome.rays = 9;
  result.outcome[Fault::kLost] = 1;
  EXPECT_THAT(line_of(result), StartsWith("EXCEEDS "));
  result.allowed.stated = false;
  EXPECT_THAT(line_of(result), StartsWith("no bound "));
  EXPECT_THAT(
      summary_of({&result, 1}, 1),
      HasSubstr("none exceed what is allowed, 1 have no bound for lost, invented and wrong rays"));
  result.outcome[Fault::kDifferent] = 1;
  EXPECT_THAT(line_of(result), StartsWith("EXCEEDS "));
}

TEST(Cases, HaveBoundsForCoresThatWereMeasured) {
  const Case& c = cases()[0];
  CoreInfo core;
  EXPECT_TRUE(c.allowed(core).stated);
  core.datapath = Datapath::kFast;
  EXPECT_FALSE(c.allowed(core).stated) << "rays have origins of their own";
  core.origins = Origins::kCommon;
  EXPECT_TRUE(c.allowed(core).stated);
}

TEST(Cases, AreFortyAndMoreNamedApart) {
  std::set<std::string> names;
  for (const Case& c : cases()) {
    EXPECT_TRUE(names.insert(c.full_name()).second) << c.full_name();
    EXPECT_FALSE(c.about.empty()) << c.full_name();
    const Allowed& a = c.on_thesis;
    const bool some =
        a.lost + a.invented + a.wrong + a.twice > 0 || a.distance > Allowed{}.distance;
    EXPECT_EQ(some, !c.why.empty()) << c.full_name() << ": what is allowed has a reason";
  }
  EXPECT_GE(names.size(), 40u);
}

TEST(Cases, AreFoundByNameAndByGroup) {
  EXPECT_EQ(find_cases({}).size(), cases().size());
  const std::vector<std::string> one = {"edges/vertices"};
  ASSERT_EQ(find_cases(one).size(), 1u);
  EXPECT_EQ(find_cases(one)[0]->full_name(), one[0]);
  const std::vector<std::string> group = {"edges"};
  EXPECT_GT(find_cases(group).size(), 5u);
}

TEST(Cases, AreListedWhenOneIsUnknown) {
  const std::vector<std::string> names = {"edges/corners"};
  EXPECT_THAT([&] { find_cases(names); },
              ThrowsMessage<UserError>(
                  AllOf(HasSubstr("there is no stress case or group 'edges/corners'; give one of "
                                  "these, or the part before the slash: slivers/aspect_1e2, "),
                        HasSubstr("stacks/objects_tree_60"))));
}

}  // namespace
}  // namespace dynrt::host::stress
