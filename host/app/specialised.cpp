// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/specialised.h"

#include <fmt/format.h>

#include <filesystem>

#include "host/app/analyst.h"
#include "host/app/scene_flags.h"
#include "host/board/load_configuration.h"
#include "host/board/run_script.h"
#include "host/error.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

namespace {

template <class Value>
void add(std::vector<std::string>& words, const char* flag, const std::optional<Value>& value) {
  if (value) words.push_back(fmt::format("{}={}", flag, *value));
}

}  // namespace

void SpecialiseFlags::add_to(CLI::App& command, bool may_exceed) {
  command_ = &command;
  command.add_flag("--specialise", specialise,
                   "use a core made for the scene, without the parts that the scene does not need; "
                   "--config names the general core to start from");
  if (may_exceed) {
    command.add_flag("--general-if-exceeded", general_if_exceeded,
                     "if the core was made for another scene or other frames and cannot hold this "
                     "one, render it on a general core instead of refusing it");
  }
}

ChosenCore SpecialiseFlags::choose(SceneFile& scene, const FrameArguments& frame,
                                   const std::string& board, const SpecialiseWishes& wishes) const {
  const bool named = command_->get_option("--config")->count() > 0;
  if (!specialise) {
    return {named ? frame.configuration : "", general_of(frame.configuration)};
  }
  if (is_at_link(board)) {
    refuse(
        "board {} has the core of its bitstream and takes no other, so leave out --specialise, or "
        "take board rtl or model",
        board);
  }
  const std::string general = named ? frame.configuration : general_configuration(scene);
  std::vector<std::string> words = words_of(scene.arguments());
  words.push_back(scene.arguments().scene);
  words.push_back("--program=" + std::filesystem::read_symlink("/proc/self/exe").string());
  words.push_back("--config=" + general);
  add(words, "--reflections", frame.reflections);
  add(words, "--memory-latency", frame.memory.latency);
  add(words, "--row-clocks", frame.memory.row_clocks);
  if (frame.uncompressed) words.emplace_back("--uncompressed");
  for (const std::string& key : wishes.keep) words.push_back("--keep=" + key);
  Analyst analyst(
      scene, {frame.reflections, frame.uncompressed, wishes.frames, wishes.span, frame.memory});
  return {made_by_script("specialise", words, "--specialise",
                         [&](const std::string& question) { return analyst.answer(question); }),
          general};
}

void SpecialiseFlags::refuse_unless_general(const Exceeded& over) const {
  if (!general_if_exceeded) {
    throw Exceeded(fmt::format("{}, or add --general-if-exceeded to render it on the general core",
                               over.what()));
  }
}

}  // namespace dynrt::host
