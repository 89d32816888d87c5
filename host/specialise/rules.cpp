// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

std::string count(std::size_t number, const std::string& what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

/// " in any of 24 frames", where there is more than one.
std::string in_frames(const SceneNeeds& needs) {
  return needs.frames > 1 ? fmt::format(" in any of {} frames", needs.frames) : "";
}

/// The bits that hold every number below `end`.
unsigned bits_for(std::size_t end) {
  return static_cast<unsigned>(std::bit_width(std::max<std::size_t>(end, 1) - 1));
}

/// Whether the scene is rendered with one tree alone, and no key of the general core needs two.
bool has_one_level(const RuleContext& c) {
  if (!c.needs.one_level || c.two_levels) return false;
  if (c.general == nullptr) return true;
  CoreConfiguration one = *c.general;
  one.levels = 1;
  return broken_rule(one).empty();
}

unsigned bounces(const RuleContext& c) {
  return c.needs.mirror.empty() ? 0 : std::min(c.demands.reflections, c.general->reflections);
}

/// Packets are split where rays are reflected.
bool splits(const RuleContext& c) {
  return bounces(c) > 0 && c.general->crossing == Crossing::kSplit;
}

Need levels(const RuleContext& c) {
  if (has_one_level(c)) {
    return {1, "the scene is one object that stands where it is, so its tree is the only one"};
  }
  if (c.two_levels) return {2, "the core already has two levels"};
  if (c.needs.one_level) {
    return {2, fmt::format("configuration {} prepares rays where they enter an object",
                           c.general->name)};
  }
  if (c.needs.objects == 1 && c.needs.instances == 1) {
    return {2, "the one object is moved, turned or scaled by its instance"};
  }
  return {2, fmt::format("{} of {} need a tree over them", count(c.needs.instances, "instance"),
                         count(c.needs.objects, "object"))};
}

Need stack(const RuleContext& c) {
  const SceneNeeds::Stack& stack = c.needs.object_stack;
  const int top = c.needs.top_stack.pushes;
  if (!has_one_level(c) && top > stack.pushes) {
    return {top, fmt::format("the tree over {} pushes at most {}{}",
                             count(c.needs.instances, "instance"), top, in_frames(c.needs))};
  }
  return {stack.pushes, fmt::format("the deepest object tree, '{}', pushes at most {}", stack.tree,
                                    stack.pushes)};
}

/// With as many slots as there are items none is ever lost, so more would never be used.
Need slots(const SceneNeeds::Repeats& repeats, const std::string& where, const char* item,
           bool every) {
  if (every) {
    return {repeats.items,
            fmt::format("packets are split and traverse {} once for every group, so each of {} "
                        "comes again",
                        where, count(repeats.items, item))};
  }
  if (repeats.repeated == 0)
    return {0, fmt::format("no {} is listed in two leaves of {}", item, where)};
  return {repeats.items,
          fmt::format("{} of {} {} listed in two or more leaves of {}", repeats.repeated,
                      count(repeats.items, item), repeats.repeated == 1 ? "is" : "are", where)};
}

Need object_slots(const RuleContext& c) {
  if (has_one_level(c)) return {0, "there is one object, and no tree over it"};
  return slots(c.needs.instance_repeats, "the tree over them", "instance", splits(c));
}

Need triangle_slots(const RuleContext& c) {
  return slots(c.needs.primitive_repeats,
               fmt::format("the tree of '{}'", c.needs.primitive_repeats.tree), "primitive",
               splits(c));
}

Need lights(const RuleContext& c) {
  if (c.needs.lights == 0) return {0, "the scene has no lights: it is lit from the eye"};
  const std::size_t most =
      c.general == nullptr ? std::numeric_limits<std::size_t>::max() : c.general->lights;
  const std::size_t used = std::min(c.needs.lights, most);
  if (used < c.needs.lights) {
    return {used, fmt::format("the scene has {}, but configuration {} uses only {}",
                              count(c.needs.lights, "light"), c.general->name, used)};
  }
  return {used, fmt::format("the scene has {}", count(c.needs.lights, "light"))};
}

Need reflections(const RuleContext& c) {
  const unsigned used = bounces(c);
  const std::string& mirror = c.needs.mirror;
  if (mirror.empty()) return {0, "no surface is a mirror"};
  if (used == 0)
    return {0, fmt::format("'{}' is a mirror, but the flags ask for no bounces", mirror)};
  return {used,
          fmt::format("'{}' is a mirror, and a ray may make {}", mirror, count(used, "bounce"))};
}

Need crossing(const RuleContext& c) {
  if (bounces(c) == 0) return {"none", "no rays of a packet cross, as none is reflected"};
  return {{}, fmt::format("as in {}: reflected rays may cross", c.general->name)};
}

Need primitives(const RuleContext& c) {
  Json kinds = Json::array();
  std::string has, lacks;
  const auto add = [&](std::size_t number, const char* kind) {
    std::string& list = number > 0 ? has : lacks;
    if (number > 0) kinds.push_back(kind);
    list += (list.empty() ? "" : " and ") +
            (number > 0 ? count(number, kind) : std::string(kind) + "s");
  };
  add(c.needs.primitives.triangles, "triangle");
  add(c.needs.primitives.spheres, "sphere");
  add(c.needs.primitives.rectangles, "rectangle");
  return {kinds, fmt::format("the scene is made of {}{}", has,
                             lacks.empty() ? "" : fmt::format("; there are no {}", lacks))};
}

Need addresses(const RuleContext& c) {
  const SceneNeeds::Places& places = c.needs.places;
  // A pointer to a list has a bit more than the nodes' addresses (units/packet.h).
  const unsigned mark = c.datapath == Datapath::kFast ? 1 : 0;
  return {std::max(bits_for(places.nodes) + mark, bits_for(places.entries)),
          fmt::format(
              "the trees take {} and {}{}", count(places.nodes, "node"),
              places.entries == 1 ? "1 list entry" : fmt::format("{} list entries", places.entries),
              in_frames(c.needs))};
}

Need matrices(const RuleContext& c) {
  return {bits_for(c.needs.places.matrices),
          fmt::format("primitives, instances, {}lights and camera take the numbers 0 to {}{}",
                      c.needs.boxes_of_instance > 0 ? "their boxes, " : "",
                      c.needs.places.matrices - 1, in_frames(c.needs))};
}

Need one_colour(const RuleContext& c) {
  if (c.needs.colours.size() == 1) {
    return {true, fmt::format("every surface has the colour {:#08x}", *c.needs.colours.begin())};
  }
  return {false, fmt::format("the surfaces have {}", count(c.needs.colours.size(), "colour"))};
}

Need uncompressed(const RuleContext& c) {
  if (c.demands.uncompressed) return {true, "the frames transform the origin of each ray"};
  return {false,
          "the primary rays of a packet share one origin, the eye; the core sends the other rays "
          "one by one"};
}

Need main_first(const RuleContext& c) {
  if (c.needs.main_first)
    return {{}, fmt::format("as in {}: one instance nearly fills the scene", c.general->name)};
  return {false, "no instance nearly fills the scene, so rays enter none before the others"};
}

Need counters(const RuleContext&) { return {false, "the picture does not depend on the counters"}; }

Need scan_out(const RuleContext&) { return {false, "the picture does not need the VGA display"}; }

constexpr Rule kRules[] = {
    {"levels", Holds::kFromNeedOn, levels},
    {"stack_depth", Holds::kFromNeedOn, stack},
    {"object_slots", Holds::kAlways, object_slots},
    {"triangle_slots", Holds::kAlways, triangle_slots},
    {"address_bits", Holds::kFromNeedOn, addresses},
    {"matrix_bits", Holds::kFromNeedOn, matrices},
    {"lights", Holds::kFromNeedOn, lights},
    {"reflections", Holds::kAlways, reflections},
    {"crossing", Holds::kAlways, crossing},
    {"primitives", Holds::kWithAll, primitives},
    {"one_colour", Holds::kUnlessSet, one_colour},
    {"uncompressed", Holds::kAlways, uncompressed},
    {"main_first", Holds::kAlways, main_first},
    {"counters", Holds::kAlways, counters},
    {"scan_out", Holds::kAlways, scan_out},
};

}  // namespace

std::span<const Rule> rules() { return kRules; }

const Rule* rule_of(std::string_view key) {
  const auto found =
      std::ranges::find(kRules, key, [](const Rule& rule) { return std::string_view(rule.key); });
  return found == std::end(kRules) ? nullptr : &*found;
}

}  // namespace dynrt::host
