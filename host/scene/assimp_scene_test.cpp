// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// glTF files that move, shine and reflect; import_test.cpp has the rest of what Assimp gives.
#include "host/scene/assimp_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "host/scene/animation.h"
#include "host/scene/load.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

// A base at x = 10 carries an arm that turns about y by 90 degrees in 2 seconds, which carries a
// hand (a triangle), the camera and a lamp; beside it a sled slides to x = 4 within a second.
constexpr char kFile[] = R"({
  "asset": {"version": "2.0"},
  "extensionsUsed": ["KHR_lights_punctual"],
  "extensions": {"KHR_lights_punctual": {"lights": [
    {"name": "lamp", "type": "point", "color": [1, 0.5, 0.25], "intensity": 8}]}},
  "scene": 0,
  "scenes": [{"nodes": [0, 3]}],
  "nodes": [
    {"name": "base", "translation": [10, 0, 0], "children": [1]},
    {"name": "arm", "children": [2, 4, 5]},
    {"name": "hand", "mesh": 0, "translation": [0, 0, 3]},
    {"name": "sled", "mesh": 0, "scale": [2, 2, 2]},
    {"name": "eye", "camera": 0, "translation": [0, 1, 0]},
    {"name": "lamp", "translation": [0, 5, 0],
     "extensions": {"KHR_lights_punctual": {"light": 0}}}],
  "cameras": [{"name": "eye", "type": "perspective",
               "perspective": {"yfov": 1, "znear": 0.1, "aspectRatio": 1}}],
  "meshes": [{"primitives": [
    {"attributes": {"POSITION": 0}, "material": 0}, {"attributes": {"POSITION": 0}, "material": 1},
    {"attributes": {"POSITION": 0}, "material": 2}, {"attributes": {"POSITION": 0}, "material": 3}]}],
  "materials": [
    {"name": "chrome", "pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.1}},
    {"name": "iron", "pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.9}},
    {"name": "glaze", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.1}},
    {"name": "plain", "pbrMetallicRoughness": {}}],
  "animations": [{"name": "work",
    "samplers": [{"input": 1, "output": 2}, {"input": 3, "output": 4}],
    "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}},
                 {"sampler": 1, "target": {"node": 3, "path": "translation"}}]}],
  "buffers": [{"uri": "a.bin", "byteLength": 108}],
  "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                  {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                  {"buffer": 0, "byteOffset": 44, "byteLength": 32},
                  {"buffer": 0, "byteOffset": 76, "byteLength": 8},
                  {"buffer": 0, "byteOffset": 84, "byteLength": 24}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR"},
    {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC4"},
    {"bufferView": 3, "componentType": 5126, "count": 2, "type": "SCALAR"},
    {"bufferView": 4, "componentType": 5126, "count": 2, "type": "VEC3"}]
})";

class MovingGltf : public testing::Test {
 protected:
  enum Offset : std::size_t { kTurnTimes = 9, kTurns = 11, kSlideTimes = 19, kSlides = 21 };

  Scene load(const std::string& text = kFile) {
    folder_.write("a.bin", {reinterpret_cast<const char*>(numbers_.data()), 4 * numbers_.size()});
    return load_scene(folder_.write("a.gltf", text));
  }
  std::string error(const std::string& text = kFile) {
    return user_error([&] { load(text); }).substr(folder_.path("a.gltf").size());
  }

  const TestFolder folder_;
  std::vector<float> numbers_ = {0, 0,
                                 0, 1,
                                 0, 0,
                                 0, 1,
                                 0,     // a triangle
                                 0, 2,  // seconds
                                 0, 0,
                                 0, 1,
                                 0, std::numbers::sqrt2_v<float> / 2,
                                 0, std::numbers::sqrt2_v<float> / 2,  // x y z w
                                 0, 1,                                 // seconds
                                 0, 0,
                                 0, 4,
                                 0, 0};
};

TEST_F(MovingGltf, MovesInstancesAndCameraWithTheirNodes) {
  Scene scene = load();
  EXPECT_NEAR(duration(scene), 2.0, 1e-6);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name, "hand");
  const auto hand = [&](double time) { return glm::dvec3(transforms_at(scene, time)[0][3]); };
  const auto sled = [&](double time) { return transforms_at(scene, time)[1]; };
  EXPECT_LT(glm::length(hand(0) - glm::dvec3(10, 0, 3)), 1e-6);
  EXPECT_LT(glm::length(hand(1) - glm::dvec3(10 + 3 * std::sqrt(0.5), 0, 3 * std::sqrt(0.5))),
            1e-6);
  EXPECT_LT(glm::length(hand(2) - glm::dvec3(13, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(glm::dvec3(sled(0.25)[3]) - glm::dvec3(1, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(glm::dvec3(sled(0.25)[0]) - glm::dvec3(2, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(glm::dvec3(sled(2)[3]) - glm::dvec3(4, 0, 0)), 1e-6);
  ASSERT_TRUE(scene.camera);
  EXPECT_LT(glm::length(scene.camera->forward - glm::dvec3(0, 0, -1)), 1e-6);
  EXPECT_LT(glm::length(camera_at(scene, 2)->forward - glm::dvec3(-1, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(camera_at(scene, 2)->position - glm::dvec3(10, 1, 0)), 1e-6);
  EXPECT_NEAR(glm::length(camera_at(scene, 2)->up), 2 * std::tan(0.5), 1e-6);
}

TEST_F(MovingGltf, KeepsPointLights) {
  const Scene scene = load();
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].name, "lamp");
  EXPECT_LT(glm::length(scene.lights[0].position - glm::dvec3(10, 5, 0)), 1e-6);
  EXPECT_LT(glm::length(scene.lights[0].colour - glm::dvec3(8, 4, 2)), 1e-6);
  EXPECT_TRUE(scene.notes.empty());
}

TEST_F(MovingGltf, NotesOtherLights) {
  const Scene scene = load(replaced(kFile, "\"point\"", "\"directional\""));
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.distant_lights, std::vector<std::string>{"lamp"});
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            folder_.path("a.gltf") + ": light 'lamp' is not a point light, so dynrt leaves it out");
}

TEST_F(MovingGltf, PolishedMetalIsAMirror) {
  const Scene scene = load();
  ASSERT_GE(scene.materials.size(), 4u);
  for (const Material& material : scene.materials) {
    EXPECT_EQ(material.mirror, material.name == "chrome" ? kMirrorShare : 0.0) << material.name;
  }
}

TEST_F(MovingGltf, NamesLightsThatCannotShine) {
  const std::string sentence =
      ": light 'lamp': its position and its colour must be finite, and the colour must not be "
      "negative";
  EXPECT_EQ(error(replaced(kFile, "[1, 0.5, 0.25]", "[1, -0.5, 0.25]")), sentence);
  EXPECT_EQ(error(replaced(kFile, "\"intensity\": 8", "\"intensity\": 1e200")), sentence);
  EXPECT_EQ(error(replaced(kFile, "\"translation\": [0, 5, 0]", "\"translation\": [0, 1e200, 0]")),
            sentence);
}

TEST_F(MovingGltf, NamesKeyframesThatCannotBeUsed) {
  const auto sentence = [](const char* node, int key, const char* time) {
    return std::string(": node '") + node + "': keyframe " + std::to_string(key) +
           " of its animation, at " + time +
           " seconds, cannot be used; times must not be negative and must rise, values must be "
           "finite, rotations must not be zero";
  };
  const std::vector<float> good = numbers_;
  numbers_[kSlideTimes + 1] = 0;
  EXPECT_EQ(error(), sentence("sled", 1, "0"));
  numbers_ = good;
  numbers_[kTurnTimes] = -0.5f;
  EXPECT_EQ(error(), sentence("arm", 0, "-0.5"));
  numbers_ = good;
  numbers_[kSlides + 4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(error(), sentence("sled", 1, "1"));
  numbers_ = good;
  for (std::size_t i = 0; i < 4; ++i) numbers_[kTurns + 4 + i] = 0;
  EXPECT_EQ(error(), sentence("arm", 1, "2"));
}

/// The file with other channels of its animation.
std::string with_channels(const std::string& channels) {
  std::string text = kFile;
  const auto begin = text.find("[{\"sampler\": 0"), end = text.find("}],\n  \"buffers\"");
  return text.replace(begin, end - begin, channels);
}

TEST_F(MovingGltf, RendersAtRestWhatMovesNoNode) {
  const Scene scene = load(with_channels("[]"));
  EXPECT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(duration(scene), 0.0);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0], folder_.path("a.gltf") +
                                ": the animation 'work' moves no node, only parts that dynrt does "
                                "not know, so dynrt renders the scene at rest");
}

TEST_F(MovingGltf, RendersMorphTargetsAtRest) {
  std::string text =
      with_channels("[{\"sampler\": 0, \"target\": {\"node\": 2, \"path\": \"weights\"}}]");
  text = replaced(text, "\"output\": 2}", "\"output\": 3}");  // a weight at either time
  text = replaced(text, "{\"attributes\": {\"POSITION\": 0}, \"material\": 0}",
                  "{\"attributes\": {\"POSITION\": 0}, \"material\": 0, "
                  "\"targets\": [{\"POSITION\": 0}]}");
  const Scene scene = load(text);
  EXPECT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(duration(scene), 0.0);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0], folder_.path("a.gltf") +
                                ": the animation 'work' moves no node, only morph targets, so "
                                "dynrt renders the scene at rest");
}

// The arm and the base are the joints of the sled's mesh.
TEST_F(MovingGltf, RendersSkinsAtRest) {
  std::string text = replaced(kFile, "\"scale\": [2, 2, 2]", "\"scale\": [2, 2, 2], \"skin\": 0");
  text = replaced(text, "\"mesh\": 0, \"translation\": [0, 0, 3]", "\"translation\": [0, 0, 3]");
  text = replaced(text, "\"camera\": 0, \"translation\"", "\"translation\"");
  text = replaced(text, "{\"sampler\": 1, \"target\": {\"node\": 3, \"path\": \"translation\"}}",
                  "{\"sampler\": 0, \"target\": {\"node\": 1, \"path\": \"rotation\"}}");
  text = replaced(text, "\"cameras\":",
                  "\"skins\": [{\"joints\": [1], \"inverseBindMatrices\": 7}], \"cameras\":");
  for (int primitive = 0; primitive < 4; ++primitive) {
    text = replaced(text, "{\"POSITION\": 0}, \"material\"",
                    "{\"POSITION\": 0, \"JOINTS_0\": 5, \"WEIGHTS_0\": 6}, \"material\"");
  }
  text = replaced(text, "\"type\": \"VEC3\"}]\n",
                  "\"type\": \"VEC3\"},\n"
                  "    {\"bufferView\": 5, \"componentType\": 5121, \"count\": 3, \"type\": "
                  "\"VEC4\"},\n"
                  "    {\"bufferView\": 6, \"componentType\": 5126, \"count\": 3, \"type\": "
                  "\"VEC4\"},\n"
                  "    {\"bufferView\": 7, \"componentType\": 5126, \"count\": 1, \"type\": "
                  "\"MAT4\"}]\n");
  text = replaced(text, "\"byteOffset\": 84, \"byteLength\": 24}]",
                  "\"byteOffset\": 84, \"byteLength\": 24},\n"
                  "                  {\"buffer\": 0, \"byteOffset\": 108, \"byteLength\": 12},\n"
                  "                  {\"buffer\": 0, \"byteOffset\": 120, \"byteLength\": 48},\n"
                  "                  {\"buffer\": 0, \"byteOffset\": 168, \"byteLength\": 64}]");
  text = replaced(text, "\"byteLength\": 108", "\"byteLength\": 232");
  numbers_.resize(30, 0.0f);  // joint 0 of each vertex
  for (int vertex = 0; vertex < 3; ++vertex) numbers_.insert(numbers_.end(), {1, 0, 0, 0});
  for (int i = 0; i < 16; ++i) numbers_.push_back(i % 5 == 0 ? 1.0f : 0.0f);
  const Scene scene = load(text);
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(duration(scene), 0.0);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            folder_.path("a.gltf") +
                ": 4 meshes with skins cannot follow the animation of bones, so dynrt "
                "renders them at rest");

  // The format allows a skin without matrices.
  const Scene bare = load(replaced(text, ", \"inverseBindMatrices\": 7", ""));
  EXPECT_EQ(bare.instances.size(), 1u);
  EXPECT_EQ(duration(bare), 0.0);
  ASSERT_EQ(bare.notes.size(), 1u);
  EXPECT_EQ(bare.notes[0], folder_.path("a.gltf") +
                               ": dynrt leaves out 1 skin without 'inverseBindMatrices' and "
                               "renders its meshes at rest");
}

TEST_F(MovingGltf, NamesTheNodeWhoseAnimationHasNoFrames) {
  std::string text = kFile;
  for (auto at = text.find("\"count\": 2,"); at != text.npos; at = text.find("\"count\": 2,", at)) {
    text.replace(at, 11, "\"count\": 0,");
  }
  EXPECT_EQ(error(text),
            ": node 'arm': its animation has no keyframes; add a keyframe or remove the animation");
}

TEST_F(MovingGltf, NotesMoreThanOneAnimation) {
  const std::string second = R"("animations": [{"name": "work",
    "samplers": [{"input": 1, "output": 2}],
    "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}, {"name": "work")";
  const Scene scene = load(replaced(kFile, "\"animations\": [{\"name\": \"work\"", second));
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            folder_.path("a.gltf") + ": the file has 2 animations; dynrt uses only 'work'");
}

}  // namespace
}  // namespace dynrt::host
