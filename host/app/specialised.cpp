// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/specialised.h"

#include <fmt/format.h>

#include "host/board/load_configuration.h"
#include "host/error.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

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
                                   const std::string& board, SpecialiseWishes wishes) const {
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
  require_whole_build();
  wishes.general = named ? frame.configuration : general_configuration(scene);
  wishes.frames.reflections = frame.reflections;
  wishes.frames.uncompressed = frame.uncompressed;
  wishes.frames.memory = frame.memory;
  return {special_core(scene, wishes).configuration, wishes.general};
}

void SpecialiseFlags::refuse_unless_general(const Exceeded& over) const {
  if (!general_if_exceeded) {
    throw Exceeded(fmt::format("{}, or add --general-if-exceeded to render it on the general core",
                               over.what()));
  }
}

}  // namespace dynrt::host
