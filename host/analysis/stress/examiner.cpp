// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/examiner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "host/analysis/truth/measures.h"
#include "host/error.h"
#include "host/layout/lay_out.h"
#include "host/render/counter_names.h"
#include "host/render/figures.h"
#include "host/render/render.h"

namespace dynrt::host::stress {

namespace {

/// Clocks without a pixel after which the RTL is given up.
constexpr std::uint64_t kTimeout = 10'000'000;
/// Another triangle's hit is as good as the nearest's where it lies no farther apart than this many
/// steps of the mantissa: the neighbour at an edge.
constexpr double kSameSteps = 16;

View view_of(const Shot& shot) { return {shot.camera, shot.options.width, shot.options.height}; }

}  // namespace

std::uint64_t dropped_pushes(const Frame& frame) {
  return value_of(frame, counters::kDroppedPushes).value_or(0);  // of a core without counters none
}

std::uint64_t Rendered::dropped_pushes() const {
  std::uint64_t sum = 0;
  for (const Frame& frame : frames) sum += stress::dropped_pushes(frame);
  return sum;
}

Board& Boards::get(const std::string& configuration) {
  std::unique_ptr<Board>& board = boards_[configuration];
  if (board) return *board;
  try {
    board = open_(configuration);
  } catch (const UserError& error) {
    throw BoardError(error.what());
  }
  if (!board) {
    throw NoBoard(fmt::format("this build's table of configurations lacks '{}'", configuration));
  }
  return *board;
}

std::string Examiner::with_secondary_rays() {
  return board().core().is_watertight() ? "whitted_watertight" : "whitted";
}

Rendered Examiner::render(const Trial& trial) {
  Board& board = trial.configuration.empty() ? boards_.get() : boards_.get(trial.configuration);
  // A trial lies in the core's space, and its trees may ask too much of the stacks: that is tried.
  LayoutOptions layout{.fit = false,
                       .spare_stacks = false,
                       .trees = trial.tree_options,
                       .instances = trial.instance_options,
                       .built = trial.trees};
  const View first = trial.shots.empty() ? View{} : view_of(trial.shots[0]);
  const auto image =
      std::make_shared<MemoryImage>(lay_out(trial.scene, first, board.core(), layout));
  const auto owners = std::make_shared<std::vector<MatrixOwners>>();
  Rendered rendered;
  rendered.primitive_of = [image, owners](std::size_t frame, const HitRecord& hit) {
    return owners->at(frame).of(hit.object, hit.triangle);
  };
  std::vector<MemoryRun> runs = image->objects.memory.runs();
  for (const Shot& shot : trial.shots) {
    image->view = view_of(shot);
    image->frame = frame_of(*image, image->trees.instances, shot.camera);
    std::ranges::move(image->frame.memory.runs(), std::back_inserter(runs));
    FrameOptions options = shot.options;
    options.timeout = kTimeout;
    Frame frame = host::render(board, options, image->frame, runs);
    runs.clear();  // the objects' part lies there from now on
    take(frame);
    owners->emplace_back(image->scene, image->objects, image->frame);
    rendered.frames.push_back(std::move(frame));
  }
  return rendered;
}

void Examiner::take(const Frame& frame) {
  outcome_.rays += frame.hits.size();
  outcome_.hits += frame.hit_count();
  outcome_.dropped += dropped_pushes(frame);
  for (const HitRecord& hit : frame.hits) {
    for (const std::uint32_t word :
         {std::uint32_t{hit.hit}, hit.object, hit.triangle, hit.t, hit.u, hit.v, hit.cosine}) {
      outcome_.digest_word(word);
    }
  }
  for (const std::uint32_t pixel : frame.pixels) outcome_.digest_word(pixel);
  if (frames_ != nullptr) frames_->push_back(frame);
}

Rendered Examiner::check(const Trial& trial) {
  Rendered rendered = render(trial);
  judge(trial, rendered);
  return rendered;
}

void Examiner::judge(const Trial& trial, const Rendered& rendered) {
  const Truth truth(trial.scene);
  for (std::size_t k = 0; k < rendered.frames.size(); ++k) {
    const Frame& frame = rendered.frames[k];
    for (std::size_t p = 0; p < frame.hits.size(); ++p) {
      const HitRecord& hit = frame.hits[p];
      const auto x = static_cast<unsigned>(p % frame.width);
      const auto y = static_cast<unsigned>(p / frame.width);
      const TruthRay ray = ray_of(trial.shots[k], x, y, trial.rays, numbers());
      const std::optional<TruthHit> nearest = truth.nearest(ray);
      if (hit.hit && nearest) {
        judge_hit(truth, ray, *nearest, rendered.primitive_of(k, hit), numbers().number(hit.t));
      } else if (hit.hit) {
        ++outcome_[Fault::kInvented];
      } else if (nearest) {
        ++outcome_[Fault::kLost];
      }
    }
  }
}

void Examiner::judge_hit(const Truth& truth, const TruthRay& ray, const TruthHit& nearest,
                         std::optional<PrimitiveId> id, double t) {
  double expected = nearest.t;
  if (!id || !nearest.tied_with(*id)) {
    const auto intersection = id ? truth.intersect(ray, *id) : std::nullopt;
    const double near = kSameSteps * step_of(numbers()) * nearest.t;
    if (!intersection || !(std::abs(intersection->t - nearest.t) <= near)) {
      ++outcome_[Fault::kWrong];
      return;
    }
    expected = intersection->t;
  }
  outcome_.distance = std::max(outcome_.distance, std::abs(t - expected) / expected);
}

void Examiner::expect_same(const Rendered& rendered, const Rendered& expected,
                           const std::function<HitRecord(HitRecord)>& change) {
  if (rendered.frames.size() != expected.frames.size()) {
    throw std::logic_error("the two sides have different numbers of frames");
  }
  for (std::size_t k = 0; k < rendered.frames.size(); ++k) {
    const std::vector<HitRecord>& hits = rendered.frames[k].hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const HitRecord& other = expected.frames[k].hits.at(i);
      if (hits[i] != (change && other.hit ? change(other) : other)) ++outcome_[Fault::kDifferent];
    }
  }
}

void Examiner::expect_refusal(const Trial& trial, const std::string& words) {
  std::uint64_t rays = 0;
  for (const Shot& shot : trial.shots) {
    rays += std::uint64_t{shot.options.width} * shot.options.height;
  }
  outcome_.refusal_expected = true;
  try {
    render(trial);
    outcome_[Fault::kAccepted] += rays;
  } catch (const BoardError&) {
    throw;
  } catch (const Exceeded&) {
    throw;
  } catch (const UserError& error) {
    outcome_.rays += rays;
    outcome_.refusal = error.what();
    if (outcome_.refusal.find(words) == std::string::npos) outcome_[Fault::kAccepted] += rays;
  }
}

}  // namespace dynrt::host::stress
