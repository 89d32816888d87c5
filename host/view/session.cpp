// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "host/render/figures.h"
#include "host/view/view_messages.h"

namespace dynrt::host {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Rows `first` to `first + rows` of a camera's picture.
Camera part_of(const Camera& camera, double first, double rows) {
  Camera part = camera;
  part.up = camera.up * rows;
  part.forward = camera.forward + camera.up * (0.5 - first - rows / 2);
  return part;
}

}  // namespace

Answer Session::answer(const Json& question) {
  const std::string type = question.at("type");
  if (type == "open") return open(choices_of(question));
  if (type == "start") return open(room_ ? room_->choices : studio_.choices);
  if (type == "frame") return frame(shot_of(question));
  throw NotOurs(fmt::format(messages::kNotOurMessage, "its type is unknown"));
}

Session::Room& Session::room() {
  if (!room_) open(studio_.choices);
  return *room_;
}

Answer Session::open(const ViewChoices& choices) {
  if (!room_ || room_->choices != choices) {
    auto first = studio_.board("model", choices);
    auto second = studio_.board("model", choices);
    MemoryImage image = studio_.prepare(choices, first->core());
    room_ = std::make_unique<Room>(Room{
        choices, {Easel(std::move(first)), Easel(std::move(second))}, Scenery(std::move(image))});
  }
  const Scenery& scenery = room_->scenery;
  const MemoryImage& image = scenery.image();
  const Box box = bounds(image.scene);
  Answer answer;
  answer.head = {{"scene", studio_.scene},
                 {"width", studio_.width},
                 {"height", studio_.height},
                 {"choices", json_of(room_->choices)},
                 {"first", json_of(scenery.first())},
                 {"seconds", scenery.seconds()},
                 {"low", json_of(image.space.outside(box.low))},
                 {"high", json_of(image.space.outside(box.high))},
                 {"notes", image.scene.notes},
                 {"clock", studio_.clock(scenery.core())}};
  return answer;
}

FrameOptions Session::options_of(const Shot& shot) const {
  return {.width = shot.width,
          .height = shot.height,
          .packets = room_->choices.packets,
          .lines = room_->choices.lines,
          .reflections = room_->choices.reflections,
          .hits = !shot.moving};
}

Answer Session::frame(const Shot& shot) {
  const auto begin = Clock::now();
  room().scenery.move(shot.from.time);
  Frame frame = shot.moving ? in_two_parts(shot) : whole(shot);
  Answer answer;
  answer.head = {{"width", shot.width},
                 {"height", shot.height},
                 {"moving", shot.moving},
                 {"seconds", seconds_since(begin)},
                 {"hits", shot.moving ? Json() : Json(frame.hit_count())}};
  answer.words = std::move(frame.pixels);
  return answer;
}

Frame Session::whole(const Shot& shot) {
  const Scenery& scenery = room_->scenery;
  const Camera camera = scenery.camera(shot.from, shot.width, shot.height);
  return room_->easels[0].render(scenery, scenery.frame(camera, shot.width, shot.height),
                                 options_of(shot));
}

Frame Session::in_two_parts(const Shot& shot) {
  constexpr unsigned kRowsOfPackets = 4;
  const auto upper =
      static_cast<unsigned>(std::lround(upper_ * shot.height / kRowsOfPackets)) * kRowsOfPackets;
  if (upper == 0 || upper >= shot.height) return whole(shot);
  const Scenery& scenery = room_->scenery;
  const Camera camera = scenery.camera(shot.from, shot.width, shot.height);
  std::array<Frame, 2> parts;
  std::array<double, 2> seconds{};
  std::exception_ptr failed;
  const auto draw = [&](std::size_t i) {
    const auto begin = Clock::now();
    FrameOptions options = options_of(shot);
    options.height = i == 0 ? upper : shot.height - upper;
    const Camera part = part_of(camera, i == 0 ? 0 : static_cast<double>(upper) / shot.height,
                                static_cast<double>(options.height) / shot.height);
    parts[i] = room_->easels[i].render(scenery, scenery.frame(part, options.width, options.height),
                                       options);
    seconds[i] = seconds_since(begin);
  };
  std::thread second([&] {
    try {
      draw(1);
    } catch (...) {
      failed = std::current_exception();
    }
  });
  try {
    draw(0);
  } catch (...) {
    second.join();
    throw;
  }
  second.join();
  if (failed) std::rethrow_exception(failed);
  const double balance = (seconds[1] - seconds[0]) / (seconds[0] + seconds[1]);
  upper_ = std::clamp(upper_ + 0.25 * balance, 0.1, 0.9);
  parts[0].pixels.insert(parts[0].pixels.end(), parts[1].pixels.begin(), parts[1].pixels.end());
  return std::move(parts[0]);
}

}  // namespace dynrt::host
