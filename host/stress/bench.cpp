// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/stress/bench.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "host/error.h"
#include "host/image/form_trees.h"
#include "host/image/image.h"
#include "host/render/render.h"
#include "host/truth/measures.h"

namespace dynrt::host::stress {

namespace {

/// Clocks without a pixel after which the RTL is given up.
constexpr std::uint64_t kTimeout = 10'000'000;
/// Another triangle's hit is as good as the nearest's where it lies no farther apart than this many
/// steps of the mantissa: the neighbour at an edge.
constexpr double kSameSteps = 16;
constexpr char kDroppedPushes[] = "stack_full.tokens";

std::vector<BankWords> words_of(std::span<const MemoryRun> runs) {
  std::vector<BankWords> words;
  for (const MemoryRun& run : runs) words.push_back({run.bank, run.address, run.words});
  return words;
}

}  // namespace

std::uint64_t dropped_pushes(const Frame& frame) {
  for (const Counter& counter : frame.counters) {
    if (counter.name == kDroppedPushes) return counter.value;
  }
  return 0;  // a core without the counter tells of none
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
    throw NoBoard(error.what());
  }
  return *board;
}

std::string Bench::with_secondary_rays() {
  return board().info().triangle_test == TriangleTest::kWatertight ? "whitted_watertight"
                                                                   : "whitted";
}

Rendered Bench::render(const Trial& trial) {
  const Scene& scene = trial.scene;
  Board& board = trial.configuration.empty() ? boards_.get() : boards_.get(trial.configuration);
  const ImageForm form{board.info().format, board.info().triangle_matrix,
                       board.info().clips_to_cube, board.info().triangle_test};
  SceneTrees trees;
  if (trial.trees) {
    trees = *trial.trees;
  } else {
    const glm::dvec3 eye = trial.shots.empty() ? glm::dvec3(0.0) : trial.shots[0].camera.position;
    trees = trees_for(scene, eye, form, trial.tree_options);
  }
  const ObjectImage objects(scene, trees.objects, form);
  if (!trial.trees) {
    BoxTreeOptions options = trial.instance_options;
    options.grid = Grid(*form.format);
    trees.instances = build_instance_tree(scene, objects.boxes(), options);
  }
  Rendered rendered;
  const auto owners = std::make_shared<std::vector<MatrixOwners>>();
  rendered.primitive_of = [owners](std::size_t frame, const HitRecord& hit) {
    return owners->at(frame).of(hit.object, hit.triangle);
  };
  std::vector<MemoryRun> runs = objects.memory.runs();
  for (const Shot& shot : trial.shots) {
    const auto [width, height] = std::pair(shot.options.width, shot.options.height);
    const FrameImage image(scene, objects, trees.instances, shot.camera, width, height);
    std::ranges::move(image.memory.runs(), std::back_inserter(runs));
    FrameOptions options = shot.options;
    options.timeout = kTimeout;
    const SceneAddresses addresses{.start_node = image.start_node,
                                   .camera_matrix = image.camera_matrix,
                                   .light_matrix = image.light_matrix,
                                   .lights = static_cast<unsigned>(scene.lights.size()),
                                   .colour = image.colour,
                                   .object = image.first_instance};
    Frame frame = host::render(board, options, addresses, words_of(runs), {});
    runs.clear();  // the objects' part lies there from now on
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
    owners->emplace_back(scene, objects, image, form);
    rendered.frames.push_back(std::move(frame));
  }
  return rendered;
}

Rendered Bench::check(const Trial& trial) {
  Rendered rendered = render(trial);
  judge(trial, rendered);
  return rendered;
}

void Bench::judge(const Trial& trial, const Rendered& rendered) {
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

void Bench::judge_hit(const Truth& truth, const TruthRay& ray, const TruthHit& nearest,
                      std::optional<PrimitiveId> id, double t) {
  double expected = nearest.t;
  if (!id || !nearest.tied_with(*id)) {
    const auto meeting = id ? truth.meet(ray, *id) : std::nullopt;
    const double near = kSameSteps * step_of(numbers()) * nearest.t;
    if (!meeting || !(std::abs(meeting->t - nearest.t) <= near)) {
      ++outcome_[Fault::kWrong];
      return;
    }
    expected = meeting->t;
  }
  outcome_.distance = std::max(outcome_.distance, std::abs(t - expected) / expected);
}

void Bench::expect_same(const Rendered& rendered, const Rendered& expected,
                        const std::function<HitRecord(HitRecord)>& change) {
  if (rendered.frames.size() != expected.frames.size()) {
    throw std::logic_error("frames to be compared are not as many");
  }
  for (std::size_t k = 0; k < rendered.frames.size(); ++k) {
    const std::vector<HitRecord>& hits = rendered.frames[k].hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const HitRecord& other = expected.frames[k].hits.at(i);
      if (hits[i] != (change && other.hit ? change(other) : other)) ++outcome_[Fault::kDifferent];
    }
  }
}

void Bench::expect_refusal(const Trial& trial, const std::string& words) {
  std::uint64_t rays = 0;
  for (const Shot& shot : trial.shots) {
    rays += std::uint64_t{shot.options.width} * shot.options.height;
  }
  outcome_.refusal_expected = true;
  try {
    render(trial);
    outcome_[Fault::kAccepted] += rays;
  } catch (const NoBoard&) {
    throw;
  } catch (const UserError& error) {
    outcome_.rays += rays;
    outcome_.refusal = error.what();
    if (outcome_.refusal.find(words) == std::string::npos) outcome_[Fault::kAccepted] += rays;
  }
}

}  // namespace dynrt::host::stress
