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

#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/render/compare.h"
#include "host/render/hit_json.h"
#include "host/view/machine.h"
#include "host/view/maps.h"
#include "host/view/pixel.h"
#include "host/view/recording.h"

namespace dynrt::host {

namespace {

using Clock = std::chrono::steady_clock;

/// A frame fails after so many clocks without a pixel or an interrupt.
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
  if (type == "start") return open(setup_ ? setup_->choices : services_.choices);
  if (type == "frame") return frame(picture_request_of(question));
  if (type == "examine") return examine(question);
  if (type == "pixel") return pixel(question);
  if (type == "map") return map(question);
  if (type == "csv") return csv(question);
  if (type == "path") return on_path(question);
  throw NotOurs("its type is unknown");
}

Session::Setup& Session::setup() {
  if (!setup_) open(services_.choices);
  return *setup_;
}

Answer Session::open(const ViewChoices& choices) {
  if (!setup_ || setup_->choices != choices) {
    auto first = services_.board(ViewBoard::kModel, choices);
    auto second = services_.board(ViewBoard::kModel, choices);
    MemoryImage image = services_.prepare(choices, first->core());
    setup_ = std::make_unique<Setup>(
        Setup{.choices = choices,
              .renderers = {Renderer(std::move(first)), Renderer(std::move(second))},
              .clocked = nullptr,
              .schedules = {},
              .loaded = LoadedScene(std::move(image)),
              .truth = nullptr,
              .truth_time = {},
              .picture = {}});
    ++opened_;
  }
  const LoadedScene& loaded = setup_->loaded;
  const MemoryImage& image = loaded.image();
  const Box box = bounds(image.scene);
  Answer answer;
  answer.head = {{"scene", services_.scene},
                 {"width", services_.width},
                 {"height", services_.height},
                 {"choices", json_of(setup_->choices)},
                 {"opened", opened_},
                 {"first", json_of(loaded.first())},
                 {"seconds", loaded.seconds()},
                 {"has_path", loaded.on_path(0).has_value()},
                 {"low", json_of(image.space.outside(box.low))},
                 {"high", json_of(image.space.outside(box.high))},
                 {"notes", image.scene.notes},
                 {"maps", maps_json()},
                 {"offers", services_.offers},
                 {"core", json_of(static_cast<const CoreConfiguration&>(loaded.core()))},
                 {"least_lines", loaded.core().least_lines()},
                 {"scene_lights", scene_lights(image)},
                 {"materials", materials(image.scene)},
                 {"clock", services_.clock(loaded.core())}};
  return answer;
}

FrameOptions Session::options_of(const PictureRequest& request) const {
  return {.width = request.width,
          .height = request.height,
          .packets = setup_->choices.packets,
          .lines = setup_->choices.lines,
          .reflections = setup_->choices.reflections,
          .hits = !request.moving};
}

Answer Session::frame(const PictureRequest& request) {
  const auto begin = Clock::now();
  setup().loaded.move(request.from.time);
  const Frame frame = request.moving ? in_two_parts(request) : whole(request);
  if (!request.moving) keep_picture(request, frame);
  Answer answer;
  answer.head = {{"width", request.width},
                 {"height", request.height},
                 {"moving", request.moving},
                 {"seconds", seconds_since(begin)},
                 {"hits", request.moving ? Json() : Json(frame.hit_count())},
                 {"number", pictures_},
                 {"opened", opened_}};
  answer.words = frame.pixels;
  return answer;
}

Frame Session::whole(const PictureRequest& request) {
  const LoadedScene& loaded = setup_->loaded;
  const Camera camera = loaded.camera(request.from, request.width, request.height);
  return setup_->renderers[0].render(loaded, loaded.frame(camera, request.width, request.height),
                                     options_of(request));
}

void Session::keep_picture(const PictureRequest& request, const Frame& frame) {
  const LoadedScene& loaded = setup_->loaded;
  const MemoryImage& memory = loaded.image();
  const Camera camera = loaded.camera(request.from, request.width, request.height);
  FrameImage image = loaded.frame(camera, request.width, request.height);
  MatrixOwners owners(memory.scene, memory.objects, image);
  setup_->picture.emplace(FullPicture{.number = ++pictures_,
                                      .request = request,
                                      .camera = camera,
                                      .image = std::move(image),
                                      .frame = frame,
                                      .owners = std::move(owners)});
}

FullPicture& Session::picture() {
  // Coarse pictures of another moment may have moved the scene since.
  if (!setup().picture) refuse("the window has no full picture yet");
  setup_->loaded.move(setup_->picture->request.from.time);
  return *setup_->picture;
}

void Session::find_truth() {
  FullPicture& now = picture();
  if (setup_->truth_time != now.request.from.time) {
    setup_->truth = ViewTruth::of(setup_->loaded.image().scene);
    setup_->truth_time = now.request.from.time;
  }
  now.truth = setup_->truth;
}

FullPicture& Session::picture(const Json& question) {
  FullPicture& now = picture();
  if (count_of(question, "number") != now.number) {
    refuse(
        "another page of this window has drawn another picture since; walk a step to draw this one "
        "again");
  }
  return now;
}

Renderer& Session::clocked(FullPicture& now) {
  if (std::string schedules = services_.schedules(setup_->choices);
      setup_->schedules != schedules) {
    setup_->schedules = std::move(schedules);
    setup_->clocked = nullptr;
    now.watch.reset();
  }
  if (!setup_->clocked) {
    setup_->clocked =
        std::make_unique<Renderer>(services_.board(ViewBoard::kClocked, setup_->choices));
  }
  return *setup_->clocked;
}

Answer Session::examine(const Json& question) {
  FullPicture& now = picture(question);
  try {
    Renderer& renderer = clocked(now);
    if (now.watch) return {.head = machine_json(now, services_.clock(setup_->loaded.core()))};
    return {.head = watch(now, renderer)};
  } catch (const UserError&) {
    // The schedules were made from other sources, so the clocks are not known.
    setup_->clocked =
        std::make_unique<Renderer>(services_.board(ViewBoard::kModel, setup_->choices));
    return {.head = watch(now, *setup_->clocked)};
  }
}

Json Session::watch(FullPicture& now, Renderer& renderer) {
  constexpr unsigned kParts = 256;
  FrameWatch watch{.ways = true, .parts = kParts, .stop = &urgent_};
  renderer.board().observe(&watch);
  try {
    Frame frame = renderer.render(setup_->loaded, now.image, options_of(now.request));
    renderer.board().observe(nullptr);
    now.keep(std::move(watch), std::move(frame));
  } catch (const FrameStopped&) {
    renderer.board().observe(nullptr);
    return {{"stopped", true}};
  } catch (...) {
    renderer.board().observe(nullptr);
    throw;
  }
  return machine_json(now, services_.clock(setup_->loaded.core()));
}

Answer Session::pixel(const Json& question) {
  const unsigned x = count_of(question, "x"), y = count_of(question, "y");
  const FullPicture& now = picture(question);
  if (x >= now.request.width || y >= now.request.height) {
    refuse("there is no pixel {}, {} in a picture of {}x{}", x, y, now.request.width,
           now.request.height);
  }
  find_truth();
  return {.head = pixel_json(setup_->loaded, now, x, y)};
}

Answer Session::map(const Json& question) {
  const std::string name = text_of(question, "name");
  const FullPicture& now = picture(question);
  if (name == "wrong") find_truth();
  return map_of(setup_->loaded, now, name);
}

Answer Session::on_path(const Json& question) {
  const auto from = setup().loaded.on_path(number_of(question, "time"));
  return {.head = {{"from", from ? json_of(*from) : Json()}}};
}

Answer Session::csv(const Json& question) {
  const FullPicture& now = picture(question);
  return {.head = {{"number", now.number}, {"csv", hit_table(now.frame)}}};
}

std::string Session::record(const std::map<std::string, PageFile>& files) {
  check_recorded_size(services_.width, services_.height);
  const Json start = open(services_.choices).head;
  const PictureRequest request{setup_->loaded.first(), services_.width, services_.height, false};
  const Json frame_head = frame(request).head;
  if (services_.schedules(services_.choices).empty()) {
    try {
      services_.lower(services_.choices, [](const std::string&) {});
    } catch (const UserError&) {
      // The frame is recorded without clocks.
    }
  }
  const Json machine = examine({{"number", pictures_}}).head;
  find_truth();
  return recorded_page(files, setup_->loaded, picture(), start, frame_head, machine);
}

JobRunner::Job Session::comparison(const Json& question) {
  const FullPicture& now = picture(question);
  struct Task {
    ViewChoices choices;
    std::vector<MemoryRun> memory;
    FrameImage image;
    FrameOptions options;
    Frame model;
    unsigned number;
  };
  auto task =
      std::make_shared<Task>(Task{setup_->choices, setup_->loaded.image().objects.memory.runs(),
                                  now.image, options_of(now.request), now.frame, now.number});
  std::ranges::move(now.image.memory.runs(), std::back_inserter(task->memory));
  task->options.timeout = kPatience;
  return [task, board_of = services_.board](const JobRunner::Tell& tell) -> Json {
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

Frame Session::in_two_parts(const PictureRequest& request) {
  constexpr unsigned kRowsOfPackets = 4;
  const auto upper =
      static_cast<unsigned>(std::lround(upper_ * request.height / kRowsOfPackets)) * kRowsOfPackets;
  if (upper == 0 || upper >= request.height) return whole(request);
  const LoadedScene& loaded = setup_->loaded;
  const Camera camera = loaded.camera(request.from, request.width, request.height);
  std::array<Frame, 2> parts;
  std::array<double, 2> seconds{};
  std::exception_ptr failed;
  const auto draw = [&](std::size_t i) {
    const auto begin = Clock::now();
    FrameOptions options = options_of(request);
    options.height = i == 0 ? upper : request.height - upper;
    const Camera part = part_of(camera, i == 0 ? 0 : static_cast<double>(upper) / request.height,
                                static_cast<double>(options.height) / request.height);
    parts[i] = setup_->renderers[i].render(
        loaded, loaded.frame(part, options.width, options.height), options);
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
