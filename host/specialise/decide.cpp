// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/decide.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

// The least that each key may be, whatever the scene (hls/configs/generate).
constexpr int kLeastStack = 1;
constexpr unsigned kLeastAddressBits = 4, kLeastMatrixBits = 2;

std::string count(std::size_t number, const std::string& what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

/// " in any of 24 frames", where there is more than one.
std::string in_frames(const SceneNeeds& needs) {
  return needs.frames > 1 ? fmt::format(" in any of {} frames", needs.frames) : "";
}

/// So many that every number below `end` is one.
unsigned bits_for(std::size_t end) {
  return static_cast<unsigned>(std::bit_width(std::max<std::size_t>(end, 1) - 1));
}

/// Whether the scene is rendered with one tree alone, and the general core's parts allow it
/// (hls/configs/generate).
bool has_one_level(const SceneNeeds& needs, const BoardInfo& general) {
  return needs.one_level && !general.clips_to_cube &&
         general.triangle_test == TriangleTest::kUnitTriangle;
}

Decision levels(const SceneNeeds& needs, const BoardInfo& general) {
  if (needs.one_level && !has_one_level(needs, general)) {
    return {"levels", 2,
            fmt::format("configuration {} prepares rays where they enter an object",
                        general.configuration)};
  }
  if (needs.one_level) {
    return {"levels", 1,
            "the scene is one object that stands where it is, so its tree is the only one"};
  }
  if (needs.objects == 1 && needs.instances == 1) {
    return {"levels", 2, "the one object is moved, turned or scaled by its instance"};
  }
  return {"levels", 2,
          fmt::format("{} of {} need a tree over them", count(needs.instances, "instance"),
                      count(needs.objects, "object"))};
}

Decision top_stack(const SceneNeeds& needs, bool one_level) {
  const int pushes = needs.top_stack.pushes;
  const std::string why =
      one_level ? "there is no tree over the objects"
                : fmt::format("the tree over {} pushes at most {}{}",
                              count(needs.instances, "instance"), pushes, in_frames(needs));
  return {"top_stack_depth", one_level ? kLeastStack : std::max(kLeastStack, pushes), why};
}

Decision object_stack(const SceneNeeds& needs) {
  return {"stack_depth", std::max(kLeastStack, needs.object_stack.pushes),
          fmt::format("the deepest object tree, '{}', pushes at most {}", needs.object_stack.tree,
                      needs.object_stack.pushes)};
}

/// With as many slots as there are items none is ever lost, so more would never be used.
Decision slots(const char* key, const SceneNeeds::Repeats& repeats, const std::string& where,
               const char* item, bool every) {
  if (every) {
    return {key, repeats.items,
            fmt::format("packets are split and traverse {} once for every group, so each of {} "
                        "comes again",
                        where, count(repeats.items, item))};
  }
  if (repeats.repeated == 0) {
    return {key, 0, fmt::format("no {} is listed in two leaves of {}", item, where)};
  }
  return {key, repeats.items,
          fmt::format("{} of {} {} listed in two or more leaves of {}", repeats.repeated,
                      count(repeats.items, item), repeats.repeated == 1 ? "is" : "are", where)};
}

Decision object_slots(const SceneNeeds& needs, bool splits, bool one_level) {
  if (one_level) return {"object_slots", 0, "there is one object, and no tree over it"};
  return slots("object_slots", needs.instance_repeats, "the tree over them", "instance", splits);
}

Decision triangle_slots(const SceneNeeds& needs, bool splits) {
  return slots("triangle_slots", needs.primitive_repeats,
               fmt::format("the tree of '{}'", needs.primitive_repeats.tree), "primitive", splits);
}

Decision lights(const SceneNeeds& needs, const BoardInfo& general) {
  if (needs.lights == 0) return {"lights", 0, "the scene has no lights: it is lit from the eye"};
  const std::size_t used = std::min<std::size_t>(needs.lights, general.lights);
  if (used < needs.lights) {
    return {"lights", used,
            fmt::format("the scene has {}, of which configuration {} lets {} shine",
                        count(needs.lights, "light"), general.configuration, used)};
  }
  return {"lights", used, fmt::format("the scene has {}", count(needs.lights, "light"))};
}

unsigned bounces(const SceneNeeds& needs, const BoardInfo& general, const FrameWishes& wishes) {
  return needs.mirror.empty() ? 0 : std::min(wishes.reflections, general.reflections);
}

Decision reflections(const SceneNeeds& needs, const BoardInfo& general, const FrameWishes& wishes) {
  const unsigned used = bounces(needs, general, wishes);
  if (needs.mirror.empty()) return {"reflections", 0, "no surface is a mirror"};
  if (used == 0) {
    return {"reflections", 0,
            fmt::format("'{}' is a mirror, but no bounces are asked for", needs.mirror)};
  }
  return {"reflections", used,
          fmt::format("'{}' is a mirror, and {} of a ray are asked for", needs.mirror,
                      count(used, "bounce"))};
}

Decision primitives(const SceneNeeds& needs) {
  Json kinds = Json::array();
  std::string has, lacks;
  const auto add = [&](std::size_t number, const char* kind) {
    std::string& list = number > 0 ? has : lacks;
    if (number > 0) kinds.push_back(kind);
    list += (list.empty() ? "" : " and ") +
            (number > 0 ? count(number, kind) : std::string(kind) + "s");
  };
  add(needs.primitives.triangles, "triangle");
  add(needs.primitives.spheres, "sphere");
  add(needs.primitives.rectangles, "rectangle");
  return {"primitives", kinds,
          fmt::format("the scene is made of {}{}", has,
                      lacks.empty() ? "" : fmt::format("; there are no {}", lacks))};
}

Decision addresses(const SceneNeeds& needs) {
  const std::size_t end = std::max(needs.places.nodes, needs.places.entries);
  return {
      "address_bits", std::max(kLeastAddressBits, bits_for(end)),
      fmt::format("the trees take {} and {}{}", count(needs.places.nodes, "node"),
                  needs.places.entries == 1 ? "1 list entry"
                                            : fmt::format("{} list entries", needs.places.entries),
                  in_frames(needs))};
}

Decision matrices(const SceneNeeds& needs) {
  return {"matrix_bits", std::max(kLeastMatrixBits, bits_for(needs.places.matrices)),
          fmt::format("primitives, instances, lights and camera take the numbers 0 to {}{}",
                      needs.places.matrices - 1, in_frames(needs))};
}

Decision colours(const SceneNeeds& needs) {
  if (needs.colours.size() == 1) {
    return {"one_colour", true,
            fmt::format("every surface has the colour {:#08x}", *needs.colours.begin())};
  }
  return {"one_colour", false,
          fmt::format("the surfaces have {}", count(needs.colours.size(), "colour"))};
}

Decision uncompressed(const FrameWishes& wishes) {
  if (wishes.uncompressed) return {"uncompressed", true, "it was asked for with --uncompressed"};
  return {
      "uncompressed", false,
      "every packet's primary rays have one origin, the eye, and the others are sent ray by ray"};
}

}  // namespace

std::vector<Decision> decide(const SceneNeeds& needs, const BoardInfo& general,
                             const FrameWishes& wishes) {
  const bool reflects = bounces(needs, general, wishes) > 0;
  const bool splits = reflects && general.crossing == Crossing::kSplit;
  const bool one_level = has_one_level(needs, general);
  std::vector<Decision> decisions{levels(needs, general),
                                  top_stack(needs, one_level),
                                  object_stack(needs),
                                  object_slots(needs, splits, one_level),
                                  triangle_slots(needs, splits),
                                  addresses(needs),
                                  matrices(needs),
                                  lights(needs, general),
                                  reflections(needs, general, wishes),
                                  primitives(needs),
                                  colours(needs),
                                  uncompressed(wishes)};
  if (!reflects) {
    decisions.push_back({"crossing", "none", "no rays of a packet cross, as none is reflected"});
  }
  return decisions;
}

Json json_of(const std::vector<Decision>& decisions) {
  Json json = Json::object();
  for (const Decision& decision : decisions) {
    json[decision.key] = {{"value", decision.value}, {"reason", decision.reason}};
  }
  return json;
}

Json json_of(const SceneNeeds& needs) {
  const auto stack = [](const SceneNeeds::Stack& s) {
    return Json{{"pushes", s.pushes}, {"tree", s.tree}};
  };
  const auto repeats = [](const SceneNeeds::Repeats& r) {
    return Json{{"items", r.items}, {"repeated", r.repeated}, {"tree", r.tree}};
  };
  return {{"scene", needs.scene},
          {"frames", needs.frames},
          {"objects", needs.objects},
          {"instances", needs.instances},
          {"one_level", needs.one_level},
          {"top_stack", stack(needs.top_stack)},
          {"object_stack", stack(needs.object_stack)},
          {"instance_repeats", repeats(needs.instance_repeats)},
          {"primitive_repeats", repeats(needs.primitive_repeats)},
          {"triangles", needs.primitives.triangles},
          {"rectangles", needs.primitives.rectangles},
          {"spheres", needs.primitives.spheres},
          {"lights", needs.lights},
          {"mirror", needs.mirror},
          {"colours", needs.colours.size()},
          {"nodes", needs.places.nodes},
          {"list_entries", needs.places.entries},
          {"matrices", needs.places.matrices}};
}

}  // namespace dynrt::host
