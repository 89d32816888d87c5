// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/analyst.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "host/error.h"
#include "host/render/figures.h"
#include "host/render/frame_refused.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kScene = "scene";  ///< begins the line about it

/// The first line of the text, without its title.
std::string about(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  return line.substr(line.find_first_not_of(' ', kScene.size()));
}

}  // namespace

CostMeter::CostMeter(SceneFile& file, const AnalysedFrames& frames) : file_(file) {
  frame_.reflections = frames.reflections;
  frame_.uncompressed = frames.uncompressed;
  frame_.memory = frames.memory;
}

FrameCosts CostMeter::count(const std::string& configuration, const std::string& schedules,
                            unsigned packets, unsigned lines) {
  FrameOptions options = frame_.options(file_.arguments());
  options.packets = packets;
  options.lines = lines;
  // A new board, as the caches of another hold what its last frame left there.
  const auto board = open_board({"model", configuration, "", schedules}, options);
  if (configuration_ != configuration) {
    prepared_ = prepare(file_, &board->core());
    configuration_ = configuration;
  }
  const Frame frame = render_on(*board, options, *prepared_);
  if (!frame.run.cycles) throw std::logic_error("the model counted no clocks by " + schedules);
  return {*frame.run.cycles, bytes_per_ray(frame)};
}

Analyst::Analyst(SceneFile& file, AnalysedFrames frames)
    : file_(file), frames_(std::move(frames)), meter_(file, frames_) {}

std::string Analyst::answer(const std::string& question) {
  try {
    return answered(Json::parse(question)).dump();
  } catch (const FrameRefused& refused) {
    return Json{{"refused", fmt::format("--{}: {}", refused.option, refused.what())}}.dump();
  } catch (const UserError& error) {
    return Json{{"refused", error.what()}}.dump();
  }
}

Json Analyst::answered(const Json& question) {
  const auto configuration = question.value("configuration", std::string());
  if (question.at("ask") == "needs") {
    const SceneAnalysis analysis = analyse(file_, configuration, frames_);
    Json json = analysis.json();
    json["about"] = about(analysis.text);
    return json;
  }
  const FrameCosts costs =
      meter_.count(configuration, question.at("schedules").get<std::string>(),
                   question.at("packets").get<unsigned>(), question.at("lines").get<unsigned>());
  return {{"clocks", costs.clocks},
          {"bytes_per_ray", costs.bytes_per_ray ? Json(*costs.bytes_per_ray) : Json()}};
}

}  // namespace dynrt::host
