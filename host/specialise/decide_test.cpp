// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Each key: there when it is needed, gone when it is not, and why.
#include "host/specialise/decide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/specialise/test_needs.h"

namespace dynrt::host {
namespace {

using testing::add_instance;
using ::testing::HasSubstr;
using testing::needs_of;
using testing::one_triangle;
using testing::room;
using testing::scene_of;
using Json = nlohmann::ordered_json;

/// One that has everything.
CoreConfiguration whitted() {
  CoreConfiguration general;
  general.name = "whitted";
  general.packets = 32;
  general.lines = 512;
  general.stack_depth = 31;
  general.triangle_slots = 32;
  general.object_slots = 32;
  general.lights = 8;
  general.reflections = 7;
  general.crossing = Crossing::kRemember;
  general.primitives = {true, true, true};
  general.scan_out = true;
  return general;
}

Decision decision(const std::string& key, const SceneNeeds& needs,
                  const FrameDemands& wishes = {.reflections = 7},
                  const CoreConfiguration& general = whitted()) {
  for (const Decision& one : decide(needs, general, wishes)) {
    if (one.key == key) return one;
  }
  return {key, nullptr, "not decided"};
}

void expect(const Decision& got, const Json& value, const std::string& reason) {
  EXPECT_EQ(got.value, value) << got.key;
  EXPECT_EQ(got.reason, reason) << got.key;
}

SceneNeeds of_one_triangle() { return needs_of(scene_of(one_triangle("sail"))); }

Scene many_sails() {
  Scene scene = scene_of(one_triangle("sail"));
  for (int i = 1; i < 9; ++i) add_instance(scene, 3.0 * i);
  return scene;
}

TEST(Decide, Levels) {
  expect(decision("levels", of_one_triangle()), 1,
         "the scene is one object that stands where it is, so its tree is the only one");
  expect(decision("levels", needs_of(many_sails())), 2,
         "9 instances of 1 object need a tree over them");
  CoreConfiguration watertight = whitted();
  watertight.triangle_test = TriangleTest::kWatertight;
  expect(decision("levels", of_one_triangle(), {}, watertight), 2,
         "configuration whitted prepares rays where they enter an object");
}

TEST(Decide, StacksAreAsDeepAsTheTreesPush) {
  expect(decision("stack_depth", of_one_triangle()), 1,
         "the deepest object tree, 'sail', pushes at most 0");
  SceneNeeds needs = of_one_triangle();
  needs.object_stack = {14, "chair"};
  expect(decision("stack_depth", needs), 14, "the deepest object tree, 'chair', pushes at most 14");
  needs = needs_of(many_sails());
  needs.frames = 24;
  needs.top_stack.pushes = 5;
  expect(decision("stack_depth", needs), 5,
         "the tree over 9 instances pushes at most 5 in any of 24 frames");
}

TEST(Decide, AMailboxIsWhereAnItemIsListedTwice) {
  SceneNeeds needs = needs_of(many_sails());
  expect(decision("object_slots", needs), 0,
         "no instance is listed in two leaves of the tree over them");
  needs.instance_repeats = {9, 2, "instances"};
  expect(decision("object_slots", needs), 9,
         "2 of 9 instances are listed in two or more leaves of the tree over them");
  expect(decision("triangle_slots", needs), 0,
         "no primitive is listed in two leaves of the tree of 'sail'");
  EXPECT_GT(decision("triangle_slots", needs_of(scene_of(room(1, 6, 6)))).value, 8);
}

TEST(Decide, AMainObjectIsMetFirstWhereThereIsOne) {
  SceneNeeds needs = needs_of(many_sails());
  expect(decision("main_first", needs), false,
         "no instance nearly fills the scene, so rays enter none before the others");
  needs.main_first = true;
  CoreConfiguration first = whitted();
  first.main_first = true;
  EXPECT_EQ(decision("main_first", needs, {}, first).value, true);
}

TEST(Decide, WhatChangesNoHitStays) {
  CoreConfiguration pair = whitted();
  pair.pipelines = 2;
  expect(decision("pipelines", of_one_triangle(), {}, pair), 2,
         "as in whitted: hits and pixels do not depend on it");
}

TEST(Decide, SplitPacketsComeToEveryLeafAgain) {
  SceneNeeds needs = needs_of(many_sails());
  needs.mirror = "chrome";
  CoreConfiguration splits = whitted();
  splits.crossing = Crossing::kSplit;
  EXPECT_EQ(decision("object_slots", needs, {.reflections = 1}, splits).value, 9);
  EXPECT_EQ(decision("object_slots", needs, {.reflections = 0}, splits).value, 0);
}

TEST(Decide, BitsOfAddressesAndMatrices) {
  SceneNeeds needs = of_one_triangle();
  needs.places.nodes = 16;
  expect(decision("address_bits", needs), 4, "the trees take 16 nodes and 2 list entries");
  needs.places.entries = 17;
  EXPECT_EQ(decision("address_bits", needs).value, 5);
  CoreConfiguration pointers = whitted();
  pointers.datapath = Datapath::kFast;
  needs.places.nodes = 17;
  EXPECT_EQ(decision("address_bits", needs, {}, pointers).value, 6) << "a bit marks lists";
  needs.places.entries = 65;
  EXPECT_EQ(decision("address_bits", needs, {}, pointers).value, 7);
  needs.places.matrices = 4096;
  expect(decision("matrix_bits", needs), 12,
         "primitives, instances, lights and camera take the numbers 0 to 4095");
  needs.places.matrices = 4097;
  EXPECT_EQ(decision("matrix_bits", needs).value, 13);
}

TEST(Decide, Lights) {
  SceneNeeds needs = of_one_triangle();
  expect(decision("lights", needs), 0, "the scene has no lights: it is lit from the eye");
  needs.lights = 3;
  expect(decision("lights", needs), 3, "the scene has 3 lights");
  needs.lights = 9;
  expect(decision("lights", needs), 8,
         "the scene has 9 lights, but configuration whitted uses only 8");
}

TEST(Decide, ReflectionsAndWhatCrosses) {
  SceneNeeds needs = of_one_triangle();
  expect(decision("reflections", needs), 0, "no surface is a mirror");
  expect(decision("crossing", needs), "none", "no rays of a packet cross, as none is reflected");
  needs.mirror = "chrome";
  expect(decision("reflections", needs, {.reflections = 2}), 2,
         "'chrome' is a mirror, and a ray may make 2 bounces");
  expect(decision("crossing", needs, {.reflections = 2}), "remember",
         "as in whitted: reflected rays may cross");
  expect(decision("reflections", needs, {.reflections = 0}), 0,
         "'chrome' is a mirror, but the flags ask for no bounces");
}

TEST(Decide, Primitives) {
  SceneNeeds needs = of_one_triangle();
  expect(decision("primitives", needs), Json::array({"triangle"}),
         "the scene is made of 1 triangle; there are no spheres and rectangles");
  needs.primitives = {0, 4, 2};
  expect(decision("primitives", needs), Json::array({"sphere", "rectangle"}),
         "the scene is made of 2 spheres and 4 rectangles; there are no triangles");
}

TEST(Decide, OneColour) {
  SceneNeeds needs = of_one_triangle();
  expect(decision("one_colour", needs), true, "every surface has the colour 0x808080");
  needs.colours.insert(0xff);
  expect(decision("one_colour", needs), false, "the surfaces have 2 colours");
}

TEST(Decide, UncompressedPacketsOnlyWhereAskedFor) {
  EXPECT_EQ(decision("uncompressed", of_one_triangle()).value, false);
  expect(decision("uncompressed", of_one_triangle(), {.uncompressed = true}), true,
         "the frames transform the origin of each ray");
}

TEST(Decide, NeverMoreThanTheGeneralCoreHasNorLessThanTheKeyMayBe) {
  SceneNeeds needs = of_one_triangle();
  needs.object_stack.pushes = 40;
  EXPECT_EQ(decision("stack_depth", needs).value, 31);
  EXPECT_EQ(decision("address_bits", of_one_triangle()).value, 4);
  EXPECT_EQ(decision("matrix_bits", of_one_triangle()).value, 2);
}

TEST(Decide, WhatNoSceneDecidesIsAsInTheGeneralCore) {
  const SceneNeeds needs = of_one_triangle();
  expect(decision("packets", needs), 32, "as in whitted: measurements decide this number");
  expect(decision("rounding", needs), "nearest_even",
         "as in whitted: another value would change the bits");
  expect(decision("memory_clocks", needs), 1, "as in whitted: the board decides it");
  expect(decision("counters", needs), false, "the picture does not depend on the counters");
  expect(decision("scan_out", needs), false, "the picture does not need the VGA display");
}

TEST(Decide, EveryKeyOfTheCoreInTheTablesOrder) {
  std::vector<std::string> keys, decided;
  const CoreConfiguration general = whitted();
  for_each_key(general, [&](const ConfigurationKey& key, const auto&) {
    if (key.of_core) keys.emplace_back(key.name);
  });
  for (const Decision& one : decide(of_one_triangle(), general, {})) decided.push_back(one.key);
  EXPECT_EQ(decided, keys);
  for (const Rule& rule : rules()) {
    EXPECT_EQ(std::ranges::count(keys, rule.key), 1) << rule.key << " is no key of a core";
  }
}

TEST(Decide, EveryDecisionHasAReason) {
  for (const Decision& one : decide(of_one_triangle(), whitted(), {})) {
    EXPECT_GT(one.reason.size(), 10u) << one.key;
    EXPECT_NE(one.reason.back(), '.') << one.key;
  }
}

TEST(Decide, KeysThatTheUserKeepsAreAsInTheGeneralCore) {
  const CoreConfiguration general = whitted();
  const auto keep = kept({"scan_out", "stack_depth"}, general);
  const auto decisions = replaced(decide(of_one_triangle(), general, {}), keep);
  const auto left = left_out(decisions, general);
  for (const char* key : {"scan_out", "stack_depth", "mantissa_bits"}) {
    EXPECT_EQ(std::ranges::count(left, key), 0) << key;
  }
  for (const char* key : {"counters", "lights"}) EXPECT_EQ(std::ranges::count(left, key), 1) << key;
  const auto depth = std::ranges::find(decisions, "stack_depth", &Decision::key);
  expect(*depth, 31, "as in whitted: it was asked for");
  EXPECT_THAT([&] { kept({"speed"}, general); },
              ::testing::ThrowsMessage<UserError>(
                  HasSubstr("there is no key 'speed' to keep; the keys are pipelines, packets, ")));
  EXPECT_THROW(kept({"about"}, general), UserError);
}

TEST(Decide, AConfigurationStatesItsReasons) {
  const CoreConfiguration general = whitted();
  const auto decisions = decide(of_one_triangle(), general, {});
  const Json json = configuration_json(decisions, "sail", general, "/folder/whitted.json");
  EXPECT_EQ(json.at("about"), "made for the scene sail, from the configuration whitted");
  EXPECT_EQ(json.at("lights").at("reason"), "the scene has no lights: it is lit from the eye");
  CoreConfiguration read = configuration_of(json);
  EXPECT_EQ(read.made_for, "sail");
  EXPECT_EQ(read.made_from, "/folder/whitted.json");
  EXPECT_EQ(read.packets, 32u);
  EXPECT_EQ(words_of(json.at("primitives").at("value")), "triangle");
  EXPECT_EQ(words_of(json.at("counters").at("value")), "no");
}

}  // namespace
}  // namespace dynrt::host
