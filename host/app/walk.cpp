// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/walk.h"

#include <fmt/format.h>

#include <chrono>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

#include "host/error.h"
#include "host/scene/animation.h"

namespace dynrt::host {

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned kMostFrames = 9999;  ///< that their names have digits for
constexpr double kOrbitSeconds = 10;    ///< once round

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::uint64_t count(const std::vector<MemoryRun>& runs) {
  std::uint64_t words = 0;
  for (const MemoryRun& run : runs) words += run.words.size();
  return words;
}

Camera turned(const Camera& camera, const glm::dvec3& centre, const glm::dvec3& axis,
              double angle) {
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, axis));
  return {centre + turn * (camera.position - centre), turn * camera.right, turn * camera.up,
          turn * camera.forward};
}

}  // namespace

WalkPlan::WalkPlan(const Scene& scene, unsigned frames, std::optional<double> from,
                   std::optional<double> to) {
  if (frames == 0 || frames > kMostFrames) {
    refuse("--frames {}: a walk has 1 to {} frames", frames, kMostFrames);
  }
  const double last = duration(scene);
  orbit = !(last > 0);
  const double begin = from.value_or(0);
  const double end = to.value_or(orbit ? kOrbitSeconds : last);
  if (begin < 0 || !(end > begin)) {
    refuse(
        "--from {} and --to {}: the walk must begin at 0 seconds or later and end after it begins",
        begin, end);
  }
  seconds = end - begin;
  if (orbit) {
    const Box box = bounds(scene);
    centre_ = (box.low + box.high) / 2.0;
  }
  // Once round ends where it begins.
  const unsigned steps = orbit || frames == 1 ? frames : frames - 1;
  for (unsigned i = 0; i < frames; ++i) times.push_back(begin + seconds * i / steps);
}

Camera WalkPlan::camera(const Scene& scene, const CameraOverrides& flags, double time,
                        unsigned width, unsigned height) const {
  const Camera camera =
      choose_camera(scene, flags, static_cast<int>(width), static_cast<int>(height));
  if (!orbit) return camera;
  return turned(camera, centre_, flags.up.value_or(scene.path_up),
                2 * std::numbers::pi * time / kOrbitSeconds);
}

Tree instances_at(MemoryImage& image, const WalkPlan& plan, unsigned frame) {
  if (!plan.orbit) move_to(image.scene, plan.times.at(frame));
  return instances_of(image);
}

Walker::Walker(Board& board, const FrameOptions& options, MemoryImage& image,
               const CameraOverrides& camera, WalkPlan plan)
    : board_(board),
      options_(options),
      image_(image),
      camera_(moved_into(image.space, camera)),
      plan_(std::move(plan)),
      needs_(image.needs()) {
  check_laid_out_for(image, board.core());
}

Walker::Result Walker::render_frame(unsigned frame, const PixelProgress& progress) {
  if (!held_) upload_scene();
  if (frame > 0 && held_ != frame - 1) {
    Step before = step_to(frame - 1);
    if (!before.excess) {  // else another board has rendered it
      write(changed_runs(on_board_, before.runs, bus_words()));
      on_board_ = std::move(before.runs);
    }
  }
  Step step = step_to(frame);
  if (step.excess) {
    refuse_excess(*step.excess, image_.core(),
                  fmt::format("frame {} of {}", frame, plan_.times.size()));
  }
  const auto begin = Clock::now();
  const std::vector<MemoryRun> changed = changed_runs(on_board_, step.runs, bus_words());

  Result result;
  WalkRecord& record = result.record;
  record.pack_seconds = step.pack_seconds + seconds_since(begin);
  record.frame = frame;
  record.time = plan_.times.at(frame);
  record.tree_seconds = step.tree_seconds;
  record.words = count(step.runs);
  record.nodes = step.frame.memory.nodes.size();
  record.entries = step.frame.memory.entries.size();

  FrameOptions options = options_;
  options.buffer = frame % kFrameBuffers;
  held_.reset();  // unknown while an error may interrupt the upload
  result.frame = render(board_, options, step.frame, changed, progress);
  record.cycles = result.frame.run.cycles;
  record.simulation_seconds = result.frame.run.seconds;
  record.upload = result.frame.upload;
  on_board_ = std::move(step.runs);
  held_ = frame;
  return result;
}

Walker::Step Walker::step_to(unsigned frame) {
  const auto begin = Clock::now();
  const Tree top = instances_at(image_, plan_, frame);
  Step step;
  step.tree_seconds = seconds_since(begin);
  step.excess = excess_of_frame(image_, needs_, top);
  if (step.excess) return step;
  const auto built = Clock::now();
  const Camera camera =
      plan_.camera(image_.scene, camera_, plan_.times.at(frame), options_.width, options_.height);
  step.frame = frame_of(image_, top, camera);
  step.runs = step.frame.memory.runs();
  step.pack_seconds = seconds_since(built);
  return step;
}

void Walker::upload_scene() {
  const BusTraffic before = board_.traffic();
  write(image_.objects.memory.runs());
  board_.finish_writes();
  scene_upload_ = board_.traffic() - before;
  on_board_.clear();
}

void Walker::write(const std::vector<MemoryRun>& runs) {
  for (const MemoryRun& run : runs) board_.write(run.bank, run.address, run.words);
}

}  // namespace dynrt::host
