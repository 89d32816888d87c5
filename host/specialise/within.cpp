// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/within.h"

#include <algorithm>
#include <bit>

#include "host/specialise/messages.h"

namespace dynrt::host {

namespace {

std::string names_of(const Primitives& some) {
  std::string names;
  const auto add = [&](bool there, const char* name) {
    if (there) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add(some.triangle, "triangle");
  add(some.sphere, "sphere");
  add(some.rectangle, "rectangle");
  return names;
}

std::optional<Excess> number_excess(const SceneNeeds& needs, const BoardInfo& board) {
  struct Number {
    const char* key;
    std::size_t needs, has;
  };
  const auto pushes = [](const SceneNeeds::Stack& stack) {
    return static_cast<std::size_t>(stack.pushes);
  };
  const auto bits = [](std::size_t end) { return std::size_t(std::bit_width(end - 1)); };
  const std::size_t addresses = std::max(needs.places.nodes, needs.places.entries);
  const std::size_t shine = board.made_from ? board.made_from->lights : needs.lights;
  const std::size_t lights = std::min(needs.lights, shine);
  const Number all[] = {{"levels", needs.one_level ? 1u : 2u, board.levels},
                        {"top_stack_depth", pushes(needs.top_stack), board.top_stack_depth},
                        {"stack_depth", pushes(needs.object_stack), board.stack_depth},
                        {"address_bits", bits(addresses), board.address_bits},
                        {"matrix_bits", bits(needs.places.matrices), board.matrix_bits},
                        {"lights", lights, board.lights}};
  for (const Number& one : all) {
    if (one.needs > one.has) {
      return Excess{one.key, std::to_string(one.needs), std::to_string(one.has)};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Excess> excess(const SceneNeeds& needs, const BoardInfo& board) {
  if (const auto over = number_excess(needs, board)) return over;
  const Primitives asked{.triangle = needs.primitives.triangles > 0,
                         .sphere = needs.primitives.spheres > 0,
                         .rectangle = needs.primitives.rectangles > 0};
  const Primitives& has = board.primitives;
  if ((asked.triangle && !has.triangle) || (asked.sphere && !has.sphere) ||
      (asked.rectangle && !has.rectangle)) {
    return Excess{"primitives", names_of(asked), names_of(has)};
  }
  if (board.one_colour && needs.colours.size() > 1) return Excess{"one_colour", "false", "true"};
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
