// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "host/scene/load.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

constexpr char kMoving[] = R"({
  "objects": [{"name": "b", "parts": [{"generate": "box", "from": [0, 0, 0], "to": [1, 1, 1], "colour": [1, 1, 1]}]}],
  "instances": [
    {"object": "b", "name": "still", "position": [9, 0, 0]},
    {"object": "b", "name": "rolls", "position": [1, 2, 3], "turn": 90, "scale": [2, 2, 2],
     "motion": {"keys": [{"time": 1}, {"time": 3, "position": [5, 2, 3]},
                         {"time": 4, "turn": 810, "scale": [4, 2, 2]}]}},
    {"object": "b", "name": "sways", "position": [0, 0, -5],
     "motion": {"repeat": true,
                "keys": [{"time": 0}, {"time": 1, "rotate": {"axis": [0, 0, 2], "degrees": 10}},
                         {"time": 2, "rotate": {"axis": [0, 0, 2], "degrees": 0}}]}}
  ],
  "camera": {"position": [0, 0, 20], "look_at": [0, 0, 0], "field_of_view": 40},
  "path": [{"time": 0, "position": [0, 0, 20], "look_at": [0, 0, 0]},
           {"time": 5, "position": [10, 0, 20], "look_at": [10, 0, 0]},
           {"time": 10, "position": [20, 0, 20], "look_at": [20, 0, 0]}]
})";

Scene moving() {
  const TestFolder folder;
  return load_scene(folder.write("m.json", kMoving));
}

glm::dmat4 placed(const glm::dvec3& position, double turn, const glm::dvec3& scale) {
  const glm::dmat4 m = glm::translate(glm::dmat4(1.0), position);
  return glm::scale(glm::rotate(m, glm::radians(turn), {0, 1, 0}), scale);
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    }
  }
  return largest;
}

TEST(Animation, LastsUntilTheLastKey) {
  EXPECT_EQ(duration(moving()), 10.0);
  EXPECT_EQ(duration(load_scene("blocks")), 0.0);
}

TEST(Animation, StandsStillOutsideItsKeysAndGoesEvenlyBetween) {
  const Scene scene = moving();
  const auto at = [&](double time) { return transforms_at(scene, time).at(1); };
  const glm::dvec3 two(2);
  EXPECT_LT(difference(at(0), placed({1, 2, 3}, 90, two)), 1e-12);
  EXPECT_LT(difference(scene.instances[1].transform, at(0)), 1e-12);
  EXPECT_LT(difference(at(1), placed({1, 2, 3}, 90, two)), 1e-12);
  EXPECT_LT(difference(at(1.5), placed({2, 2, 3}, 90, two)), 1e-12);
  EXPECT_LT(difference(at(3), placed({5, 2, 3}, 90, two)), 1e-12);
  EXPECT_LT(difference(at(4), placed({5, 2, 3}, 810, {4, 2, 2})), 1e-12);
  EXPECT_LT(difference(at(99), placed({5, 2, 3}, 90, {4, 2, 2})), 1e-12);
  EXPECT_EQ(transforms_at(scene, 2)[0], scene.instances[0].transform);
}

TEST(Animation, TurnsTwiceRoundWhereToldTo) {
  const Scene scene = moving();
  for (double part = 0; part < 1; part += 1.0 / 64) {
    const glm::dmat4 expected = placed({5, 2, 3}, 90 + 720 * part, {2 + 2 * part, 2, 2});
    EXPECT_LT(difference(transforms_at(scene, 3 + part)[1], expected), 1e-12) << part;
  }
}

TEST(Animation, RepeatsWhatRepeats) {
  const Scene scene = moving();
  const auto at = [&](double time) { return transforms_at(scene, time).at(2); };
  const glm::dvec4 top(0, 1, 0, 1);
  EXPECT_NEAR((at(1) * top).x, -std::sin(glm::radians(10.0)), 1e-12);
  EXPECT_NEAR((at(0.5) * top).x, -std::sin(glm::radians(5.0)), 1e-12);
  for (const double time : {0.3, 1.0, 1.7}) {
    EXPECT_LT(difference(at(time), at(time + 6)), 1e-12);
    EXPECT_GT(difference(at(time), at(0)), 1e-2);
  }
}

TEST(Animation, CameraGoesThroughThePathsKeysSmoothly) {
  const Scene scene = moving();
  for (const double time : {0.0, 2.5, 5.0, 7.0, 10.0}) {
    const auto camera = camera_at(scene, time);
    ASSERT_TRUE(camera);
    EXPECT_LT(glm::length(camera->position - glm::dvec3(2 * time, 0, 20)), 1e-12);
    EXPECT_LT(glm::length(camera->forward - glm::dvec3(0, 0, -1)), 1e-12);
    EXPECT_NEAR(glm::length(camera->up), 2 * std::tan(glm::radians(20.0)), 1e-12);
  }
  EXPECT_EQ(camera_at(scene, 11)->position, glm::dvec3(20, 0, 20));
  // Round a bend: no jump of the speed at the key.
  Scene bend = moving();
  bend.path[2].position = {10, 0, 10};
  const auto position = [&](double time) { return camera_at(bend, time)->position; };
  const double h = 1e-4;
  const glm::dvec3 before = (position(5) - position(5 - h)) / h;
  const glm::dvec3 after = (position(5 + h) - position(5)) / h;
  EXPECT_LT(glm::length(before - after), 1e-2);
  EXPECT_LT(glm::length(before - glm::dvec3(1, 0, -1)), 1e-2);
}

TEST(Animation, MovesTheSceneInPlace) {
  Scene scene = moving();
  move_to(scene, 3.5);
  EXPECT_EQ(scene.instances[1].transform, transforms_at(scene, 3.5)[1]);
  EXPECT_NEAR(scene.camera->position.x, 7.0, 1e-12);
  move_to(scene, 0);
  EXPECT_LT(difference(scene.instances[1].transform, moving().instances[1].transform), 1e-12);
}

TEST(Animation, ChildrenMoveWithTheirParents) {
  Scene scene = moving();
  MotionNode child;
  child.parent = 0;
  child.transform = placed({1, 0, 0}, 0, glm::dvec3(1));
  scene.motion.push_back(child);
  scene.instances[0].motion = 2;
  scene.path.clear();
  scene.camera_motion = 2;
  const auto at = transforms_at(scene, 1);
  EXPECT_LT(glm::length(glm::dvec3(at[0][3]) - glm::dvec3(1, 2, 1)), 1e-12);
  EXPECT_LT(glm::length(camera_at(scene, 1)->position - glm::dvec3(1, 2, 1)), 1e-12);
  EXPECT_LT(glm::length(camera_at(scene, 1)->forward - glm::dvec3(-1, 0, 0)), 1e-12);
}

TEST(Animation, NamesWhatAndWhenWhenSomethingGoesWrong) {
  Scene scene = moving();
  scene.motion[0].scale.back().value = {0, 2, 2};
  EXPECT_EQ(user_error([&] { move_to(scene, 4.5); }),
            "m, after 4.5 seconds: node 'rolls': its transform has no inverse; its three axes must "
            "not be zero and must not lie in one plane");
  scene = moving();
  scene.path[2].look_at = scene.path[2].position;
  EXPECT_EQ(user_error([&] { camera_at(scene, 10); }),
            "m, after 10 seconds: the camera's position and the point that it looks at are the "
            "same (20, 0, 20); move one of the two");
}

struct Mistake {
  const char* what;
  const char* with;
  const char* sentence;  // behind the path
};

class MotionMistake : public testing::TestWithParam<Mistake> {};

TEST_P(MotionMistake, IsNamed) {
  const TestFolder folder;
  const Mistake& mistake = GetParam();
  const std::string path = folder.write("m.json", replaced(kMoving, mistake.what, mistake.with));
  EXPECT_EQ(user_error([&] { load_scene(path); }), path + mistake.sentence);
}

INSTANTIATE_TEST_SUITE_P(
    All, MotionMistake,
    testing::Values(
        Mistake{"\"keys\": [{\"time\": 1},", "\"keys\": [], \"k\": [",
                ": instances[1].motion: there is no key 'k' here; the keys are keys, repeat"},
        Mistake{"{\"keys\": [{\"time\": 1}, {\"time\": 3, \"position\": [5, 2, 3]},\n"
                "                         {\"time\": 4, \"turn\": 810, \"scale\": [4, 2, 2]}]}",
                "{\"keys\": []}",
                ": instances[1].motion: 'keys' has no keys; it needs at least one"},
        Mistake{"{\"time\": 3, \"position\": [5, 2, 3]}", "{\"time\": 1}",
                ": instances[1].motion.keys[1]: 'time' must be at least 0 and above the time of "
                "the previous key"},
        Mistake{"{\"time\": 1},", "{\"time\": -1},",
                ": instances[1].motion.keys[0]: 'time' must be at least 0 and above the time of "
                "the previous key"},
        Mistake{"{\"time\": 1},", "{\"time\": 1, \"size\": 2},",
                ": instances[1].motion.keys[0]: there is no key 'size' here; the keys are time, "
                "position, turn, rotate, scale"},
        Mistake{"\"turn\": 810", "\"turn\": 1e9",
                ": instances[1].motion.keys[2]: 'turn' may change by at most 36000 degrees from "
                "the previous key"},
        Mistake{"[4, 2, 2]", "[4, -2, 2]",
                ": instances[1].motion.keys[2]: 'scale' must not be zero, and on each axis it must "
                "have the sign of the instance's scale"},
        Mistake{
            "{\"time\": 0}, {\"time\": 1, \"rotate\": {\"axis\": [0, 0, 2], \"degrees\": 10}},\n"
            "                         {\"time\": 2, \"rotate\": {\"axis\": [0, 0, 2], "
            "\"degrees\": 0}}",
            "{\"time\": 0}", ": instances[2].motion: 'repeat' needs a key later than at time 0"},
        Mistake{"\"position\": [1, 2, 3], \"turn\": 90, \"scale\": [2, 2, 2]",
                "\"matrix\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]",
                ": instances[1]: an instance with a 'motion' cannot have a 'matrix'; give "
                "position, turn, rotate and scale"},
        Mistake{"\"camera\": {\"position\": [0, 0, 20], \"look_at\": [0, 0, 0], "
                "\"field_of_view\": 40},",
                "",
                ": the file: a 'path' needs a 'camera', which gives its field of view and its up "
                "direction"},
        Mistake{"{\"time\": 5, \"position\": [10, 0, 20], \"look_at\": [10, 0, 0]}",
                "{\"time\": 5, \"position\": [10, 0, 20]}",
                ": path[1]: the key 'look_at' is missing"}));

}  // namespace
}  // namespace dynrt::host
