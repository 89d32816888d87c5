// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iterator>
#include <thread>
#include <utility>

#include "host/format/configuration_json.h"
#include "host/render/compare.h"
#include "host/view/hit_json.h"
#include "host/view/machine.h"
#include "host/view/maps.h"
#include "host/view/pixel.h"
#include "host/view/recording.h"
#include "host/view/view_messages.h"

namespace dynrt::host {

namespace {

using Clock = std::chrono::steady_clock;

/// Clocks without a pixel or an interrupt, after which a frame is given up.
constexpr std::uint64_t kPatience = 10'000'000;

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

Json scene_lights(const MemoryImage& image) {
  Json lights = Json::array();
  for (const PointLight& light : image.scene.lights) {
    lights.push_back(
        {{"name", light.name}, {"position", json_of(image.space.outside(light.position))}});
  }
  return lights;
}

Json materials(const Scene& scene) {
  Json names = Json::array();
  for (const Material& material : scene.materials) names.push_back(material.name);
  return names;
}

Json maps_json() {
  Json maps = Json::array();
  for (const MapDefinition& map : view_maps()) {
    maps.push_back(
        {{"name", map.name}, {"about", map.about}, {"kind", map.kind}, {"watched", map.watched}});
  }
  return maps;
}

}  // namespace

Answer Session::answer(const Json& question) {
  const std::string type = question.at("type");
  if (type == "open") return open(choices_of(question));
  if (type == "start") return open(room_ ? room_->choices : studio_.choices);
  if (type == "frame") return frame(shot_of(question));
  if (type == "examine") return examine(question);
  if (type == "pixel") return pixel(question);
  if (type == "map") return map(question);
  if (type == "csv") return csv(question);
  if (type == "path") return on_path(question);
  throw NotOurs(fmt::format(messages::kNotOurMessage, "its type is unknown"));
}

Session::Room& Session::room() {
  if (!room_) open(studio_.choices);
  return *room_;
}

Answer Session::open(const ViewChoices& choices) {
  if (!room_ || room_->choices != choices) {
    auto first = studio_.board(ViewBoard::kModel, choices);
    auto second = studio_.board(ViewBoard::kModel, choices);
    MemoryImage image = studio_.prepare(choices, first->core());
    room_ =
        std::make_unique<Room>(Room{.choices = choices,
                                    .easels = {Easel(std::move(first)), Easel(std::move(second))},
                                    .clocked = nullptr,
                                    .schedules = {},
                                    .scenery = Scenery(std::move(image)),
                                    .truth = nullptr,
                                    .truth_time = {},
                                    .still = {}});
    ++opened_;
  }
  const Scenery& scenery = room_->scenery;
  const MemoryImage& image = scenery.image();
  const Box box = bounds(image.scene);
  Answer answer;
  answer.head = {{"scene", studio_.scene},
                 {"width", studio_.width},
                 {"height", studio_.height},
                 {"choices", json_of(room_->choices)},
                 {"opened", opened_},
                 {"first", json_of(scenery.first())},
                 {"seconds", scenery.seconds()},
                 {"has_path", scenery.on_path(0).has_value()},
                 {"low", json_of(image.space.outside(box.low))},
                 {"high", json_of(image.space.outside(box.high))},
                 {"notes", image.scene.notes},
                 {"maps", maps_json()},
                 {"offers", studio_.offers},
                 {"core", json_of(static_cast<const CoreConfiguration&>(scenery.core()))},
                 {"least_lines", scenery.core().least_lines()},
                 {"scene_lights", scene_lights(image)},
                 {"materials", materials(image.scene)},
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
  const Frame frame = shot.moving ? in_two_parts(shot) : whole(shot);
  if (!shot.moving) keep_still(shot, frame);
  Answer answer;
  answer.head = {{"width", shot.width},
                 {"height", shot.height},
                 {"moving", shot.moving},
                 {"seconds", seconds_since(begin)},
                 {"hits", shot.moving ? Json() : Json(frame.hit_count())},
                 {"number", frames_},
                 {"opened", opened_}};
  answer.words = frame.pixels;
  return answer;
}

Frame Session::whole(const Shot& shot) {
  const Scenery& scenery = room_->scenery;
  const Camera camera = scenery.camera(shot.from, shot.width, shot.height);
  return room_->easels[0].render(scenery, scenery.frame(camera, shot.width, shot.height),
                                 options_of(shot));
}

void Session::keep_still(const Shot& shot, const Frame& frame) {
  const Scenery& scenery = room_->scenery;
  const MemoryImage& memory = scenery.image();
  const Camera camera = scenery.camera(shot.from, shot.width, shot.height);
  FrameImage image = scenery.frame(camera, shot.width, shot.height);
  MatrixOwners owners(memory.scene, memory.objects, image);
  room_->still.emplace(Still{.number = ++frames_,
                             .shot = shot,
                             .camera = camera,
                             .image = std::move(image),
                             .frame = frame,
                             .owners = std::move(owners)});
}

Still& Session::still() {
  // Coarse frames of another moment may have moved the scene since.
  if (!room().still) refuse(messages::kNoStill);
  room_->scenery.move(room_->still->shot.from.time);
  return *room_->still;
}

void Session::find_truth() {
  Still& now = still();
  if (room_->truth_time != now.shot.from.time) {
    room_->truth = ViewTruth::of(room_->scenery.image().scene);
    room_->truth_time = now.shot.from.time;
  }
  now.truth = room_->truth;
}

Still& Session::still(const Json& question) {
  Still& now = still();
  if (count_of(question, "number") != now.number) refuse(messages::kOtherStill);
  return now;
}

Easel& Session::clocked(Still& now) {
  if (std::string schedules = studio_.schedules(room_->choices); room_->schedules != schedules) {
    room_->schedules = std::move(schedules);
    room_->clocked = nullptr;
    now.watch.reset();
  }
  if (!room_->clocked) {
    room_->clocked = std::make_unique<Easel>(studio_.board(ViewBoard::kClocked, room_->choices));
  }
  return *room_->clocked;
}

Answer Session::examine(const Json& question) {
  Still& now = still(question);
  try {
    Easel& easel = clocked(now);
    if (now.watch) return {.head = machine_json(now, studio_.clock(room_->scenery.core()))};
    return {.head = watch(now, easel)};
  } catch (const UserError&) {
    // The schedules are those of other sources: then without clocks.
    room_->clocked = std::make_unique<Easel>(studio_.board(ViewBoard::kModel, room_->choices));
    return {.head = watch(now, *room_->clocked)};
  }
}

Json Session::watch(Still& now, Easel& easel) {
  constexpr unsigned kParts = 256;
  FrameWatch watch{.ways = true, .parts = kParts, .stop = &urgent_};
  easel.board().observe(&watch);
  try {
    Frame frame = easel.render(room_->scenery, now.image, options_of(now.shot));
    easel.board().observe(nullptr);
    now.keep(std::move(watch), std::move(frame));
  } catch (const FrameStopped&) {
    easel.board().observe(nullptr);
    return {{"stopped", true}};
  } catch (...) {
    easel.board().observe(nullptr);
    throw;
  }
  return machine_json(now, studio_.clock(room_->scenery.core()));
}

Answer Session::pixel(const Json& question) {
  const unsigned x = count_of(question, "x"), y = count_of(question, "y");
  const Still& now = still(question);
  if (x >= now.shot.width || y >= now.shot.height) {
    refuse(messages::kNoPixel, x, y, now.shot.width, now.shot.height);
  }
  find_truth();
  return {.head = pixel_json(room_->scenery, now, x, y)};
}

Answer Session::map(const Json& question) {
  const std::string name = text_of(question, "name");
  const Still& now = still(question);
  if (name == "wrong") find_truth();
  return map_of(room_->scenery, now, name);
}

Answer Session::on_path(const Json& question) {
  const auto from = room().scenery.on_path(number_of(question, "time"));
  return {.head = {{"from", from ? json_of(*from) : Json()}}};
}

Answer Session::csv(const Json& question) {
  const Still& now = still(question);
  return {.head = {{"number", now.number}, {"csv", hit_table(now.frame)}}};
}

std::string Session::record(const std::map<std::string, PageFile>& files) {
  check_recorded_size(studio_.width, studio_.height);
  const Json start = open(studio_.choices).head;
  const Shot shot{room_->scenery.first(), studio_.width, studio_.height, false};
  const Json frame_head = frame(shot).head;
  if (studio_.schedules(studio_.choices).empty()) {
    try {
      studio_.lower(studio_.choices, [](const std::string&) {});
    } catch (const UserError&) {
      // The frame is recorded without clocks.
    }
  }
  const Json machine = examine({{"number", frames_}}).head;
  find_truth();
  return recorded_page(files, room_->scenery, still(), start, frame_head, machine);
}

Workshop::Job Session::comparison(const Json& question) {
  const Still& now = still(question);
  struct Task {
    ViewChoices choices;
    std::vector<MemoryRun> memory;
    FrameImage image;
    FrameOptions options;
    Frame model;
    unsigned number;
  };
  auto task =
      std::make_shared<Task>(Task{room_->choices, room_->scenery.image().objects.memory.runs(),
                                  now.image, options_of(now.shot), now.frame, now.number});
  std::ranges::move(now.image.memory.runs(), std::back_inserter(task->memory));
  task->options.timeout = kPatience;
  return [task, board_of = studio_.board](const Workshop::Tell& tell) -> Json {
    tell("opening the board");
    const auto board = board_of(ViewBoard::kRtl, task->choices);
    const auto pixels = task->model.pixels.size();
    const Frame frame =
        render(*board, task->options, task->image, task->memory,
               [&](std::uint64_t done) { tell(fmt::format("{} of {} pixels", done, pixels)); });
    const Comparison comparison = compare(task->model, frame);
    return {{"number", task->number},
            {"identical", comparison.identical()},
            {"pixels", comparison.pixels},
            {"counters", comparison.counters},
            {"different_hits", comparison.different_hits},
            {"different_pixels", comparison.different_pixels},
            {"different_counters", comparison.different_counters},
            {"first", comparison.first ? Json(comparison.first->text("model", "rtl")) : Json()},
            {"cycles", frame.run.cycles ? Json(*frame.run.cycles) : Json()},
            {"seconds", frame.run.seconds}};
  };
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
