// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/within.h"

#include <algorithm>
#include <bit>

#include "host/specialise/messages.h"

namespace dynrt::host {

std::optional<Excess> excess(const SceneNeeds& needs, const BoardInfo& board) {
  const auto pushes = [](const SceneNeeds::Stack& stack) {
    return static_cast<std::size_t>(stack.pushes);
  };
  const auto bits = [](std::size_t end) { return std::size_t(std::bit_width(end - 1)); };
  const std::size_t addresses = std::max(needs.places.nodes, needs.places.entries);
  const std::size_t shine = board.made_from ? board.made_from->lights : needs.lights;
  const std::size_t lights = std::min(needs.lights, shine);
  const Excess all[] = {{"levels", needs.one_level ? 1u : 2u, board.levels},
                        {"top_stack_depth", pushes(needs.top_stack), board.top_stack_depth},
                        {"stack_depth", pushes(needs.object_stack), board.stack_depth},
                        {"address_bits", bits(addresses), board.address_bits},
                        {"matrix_bits", bits(needs.places.matrices), board.matrix_bits},
                        {"lights", lights, board.lights}};
  for (const Excess& one : all) {
    if (one.needs > one.has) return one;
  }
  return std::nullopt;
}

void refuse_excess(const Excess& over, const BoardInfo& board, const std::string& frame) {
  throw Exceeded(fmt::format(messages::kExceeded, frame, over.key, over.needs, board.configuration,
                             board.made_for, over.has));
}

void check_within(const SceneNeeds& needs, const BoardInfo& board, const std::string& frame) {
  if (const auto over = excess(needs, board)) refuse_excess(*over, board, frame);
}

}  // namespace dynrt::host
