// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/placement.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};
constexpr double kLargestStep = 60.0;   // degrees between two keys, well below half a turn
constexpr double kLargestTurn = 36000;  // degrees between two keys of the file

// Reads "time" of each key; they rise from at least 0.
std::vector<JsonReader> keys_of(const JsonReader& at, const char* name) {
  std::vector<JsonReader> keys = at.objects(name);
  if (keys.empty()) at.refuse("'{}' has no keys; it needs at least one", name);
  double before = -1.0;
  for (const JsonReader& key : keys) {
    const double time = key.number("time");
    if (!(time >= 0.0 && time > before)) {
      key.refuse("'time' must be at least 0 and above the time of the previous key");
    }
    before = time;
  }
  return keys;
}

glm::dquat tilt(const Placement& p) { return glm::angleAxis(glm::radians(p.degrees), p.axis); }

glm::dquat turned(const glm::dquat& tilt, double turn) {
  return glm::normalize(tilt * glm::angleAxis(glm::radians(turn), kUp));
}

// Between rotations the way is the shortest one, so that a long turn needs keys between.
void add_turn(MotionNode& node, const JsonReader& key, const Placement& before,
              const Placement& after, double time_before, double time) {
  const double turn = after.turn - before.turn;
  if (!(std::abs(turn) <= kLargestTurn)) {
    key.refuse("'turn' may change by at most {} degrees from the previous key", kLargestTurn);
  }
  const int steps = static_cast<int>(std::abs(turn) / kLargestStep) + 1;
  for (int step = 1; step <= steps; ++step) {
    const double part = static_cast<double>(step) / steps;
    node.rotation.push_back(
        {glm::mix(time_before, time, part), turned(glm::slerp(tilt(before), tilt(after), part),
                                                   glm::mix(before.turn, after.turn, part))});
  }
}

}  // namespace

glm::dmat4 Placement::matrix() const {
  glm::dmat4 m = glm::translate(glm::dmat4(1.0), position);
  m = glm::rotate(m, glm::radians(degrees), axis);
  m = glm::rotate(m, glm::radians(turn), kUp);
  return glm::scale(m, scale);
}

Placement read_placement(const JsonReader& at, const Placement& otherwise) {
  Placement placement = otherwise;
  placement.position = at.vector("position", otherwise.position);
  placement.turn = at.number("turn", otherwise.turn);
  placement.scale = at.vector("scale", otherwise.scale);
  if (at.has("rotate")) {
    const JsonReader rotate = at.object("rotate");
    rotate.only({"axis", "degrees"});
    const glm::dvec3 axis = rotate.vector("axis");
    if (!(glm::length(axis) > 0.0)) rotate.refuse("'axis' must not be zero");
    placement.axis = glm::normalize(axis);
    placement.degrees = rotate.number("degrees");
  }
  return placement;
}

MotionNode read_motion(const JsonReader& motion, const Placement& start) {
  motion.only({"keys", "repeat"});
  MotionNode node;
  Placement before = start;
  double time_before = 0.0;
  for (const JsonReader& key : keys_of(motion, "keys")) {
    key.only({"time", "position", "turn", "rotate", "scale"});
    const double time = key.number("time");
    const Placement placement = read_placement(key, before);
    if (!glm::all(glm::greaterThan(placement.scale * start.scale, glm::dvec3(0.0)))) {
      key.refuse(
          "'scale' must not be zero, and on each axis it must have the sign of the instance's "
          "scale");
    }
    if (node.position.empty()) {
      node.rotation.push_back({time, turned(tilt(placement), placement.turn)});
    } else {
      add_turn(node, key, before, placement, time_before, time);
    }
    node.position.push_back({time, placement.position});
    node.scale.push_back({time, placement.scale});
    before = placement;
    time_before = time;
  }
  node.repeats = motion.flag("repeat", false);
  if (node.repeats && !(time_before > 0.0))
    motion.refuse("'repeat' needs a key later than at time 0");
  return node;
}

std::vector<PathKey> read_path(const JsonReader& file) {
  std::vector<PathKey> path;
  for (const JsonReader& key : keys_of(file, "path")) {
    key.only({"time", "position", "look_at"});
    path.push_back({key.number("time"), key.vector("position"), key.vector("look_at")});
  }
  return path;
}

}  // namespace dynrt::host
