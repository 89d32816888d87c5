// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a stress case: renders trials on a board and compares the results with the truth or with
// other frames.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/analysis/stress/outcome.h"
#include "host/analysis/stress/trial.h"
#include "host/board/board.h"
#include "host/render/frame.h"

namespace dynrt::host::stress {

/// Opens the board of a configuration. Returns null if the table of configurations lacks it, and
/// throws UserError if its board cannot be made.
using OpenBoard = std::function<std::unique_ptr<Board>(const std::string& configuration)>;

/// The frames of a trial, and the meaning of the numbers in their records.
struct Rendered {
  std::vector<Frame> frames;  ///< one a shot
  /// The primitive that a hit of a frame's record names, if it belongs to the scene. The scene must
  /// still exist.
  std::function<std::optional<PrimitiveId>(std::size_t frame, const HitRecord& hit)> primitive_of;

  std::uint64_t dropped_pushes() const;
};

/// Tells from its counter whether the board's core has lost hits to a full stack.
std::uint64_t dropped_pushes(const Frame& frame);

/// A board that a case needs cannot be made: no fault of the case's, and no refusal of its scene.
struct BoardError : UserError {
  using UserError::UserError;
};
/// The table of configurations lacks the board's.
struct NoBoard : BoardError {
  using BoardError::BoardError;
};

/// The boards that were opened so far; cases share them. Throws BoardError.
class Boards {
 public:
  Boards(OpenBoard open, std::string configuration)
      : open_(std::move(open)), configuration_(std::move(configuration)) {}
  Board& get(const std::string& configuration);
  Board& get() { return get(configuration_); }
  const std::string& configuration() const { return configuration_; }

 private:
  OpenBoard open_;
  std::string configuration_;
  std::map<std::string, std::unique_ptr<Board>> boards_;
};

class Examiner {
 public:
  /// `frames`, if not null, gets every rendered frame, for comparing boards.
  explicit Examiner(Boards& boards, std::vector<Frame>* frames = nullptr)
      : boards_(boards), frames_(frames) {}

  /// Those of the core.
  const MemoryFormat& numbers() { return *board().core().format; }
  /// Of a cache of the core: one in each way.
  unsigned fewest_lines() { return board().core().ways; }

  Rendered render(const Trial& trial);
  /// Renders and compares with the truth.
  Rendered check(const Trial& trial);
  void judge(const Trial& trial, const Rendered& rendered);
  /// Counts the rays of `frames` whose hits differ from those of `expected`; `change`, if given,
  /// converts a hit to the expected one.
  void expect_same(const Rendered& rendered, const Rendered& expected,
                   const std::function<HitRecord(HitRecord)>& change = {});
  /// The host must refuse the trial with a message that contains these words.
  void expect_refusal(const Trial& trial, const std::string& words);
  void count(Fault fault, std::uint64_t rays) { outcome_[fault] += rays; }

  Board& board() { return boards_.get(); }
  /// The configuration with the board's core and light and reflection rays.
  std::string with_secondary_rays();
  const Outcome& outcome() const { return outcome_; }
  /// The host has refused a trial that it should accept.
  void refused(const std::string& sentence) { outcome_.refusal = sentence; }
  /// It has refused a trial that exceeds the board's specialised core.
  void exceeded(const std::string& sentence) {
    outcome_.refusal = sentence;
    outcome_.exceeds_core = true;
  }

 private:
  void take(const Frame& frame);
  void judge_hit(const Truth& truth, const TruthRay& ray, const TruthHit& nearest,
                 std::optional<PrimitiveId> id, double t);

  Boards& boards_;
  Outcome outcome_;
  std::vector<Frame>* frames_;
};

}  // namespace dynrt::host::stress
