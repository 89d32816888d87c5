// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace dynrt::host {
namespace {

Json a_request() {
  return {{"type", "frame"}, {"position", {1, 2, 3}},  {"look_at", {0, 0, 0.5}},
          {"up", {0, 1, 0}}, {"field_of_view", 40.25}, {"time", 0},
          {"width", 64},     {"height", 48},           {"moving", true}};
}

TEST(Answer, IsItsLengthItsTextAndItsWords) {
  const Answer answer{.head = {{"a", 1}}, .words = {0x00332211, 7}};
  const std::string bytes = answer.bytes();
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data(), 4);
  EXPECT_EQ(length % 4, 0u);
  EXPECT_EQ(Json::parse(bytes.substr(4, length)), answer.head);
  ASSERT_EQ(bytes.size(), 4 + length + 8);
  EXPECT_EQ(bytes.substr(4 + length), std::string("\x11\x22\x33\x00\x07\x00\x00\x00", 8));
}

TEST(Question, HasAType) {
  EXPECT_EQ(question_of(R"({"type": "start"})")["type"], "start");
  for (const char* text : {"", "{", "[]", "3", "{}", R"({"type": 3})"}) {
    EXPECT_THROW(question_of(text), NotOurs) << text;
  }
}

TEST(PictureRequest, IsReadAsItIs) {
  const PictureRequest request = picture_request_of(a_request());
  EXPECT_EQ(request.from.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(request.from.look_at, glm::dvec3(0, 0, 0.5));
  EXPECT_EQ(request.from.field_of_view, 40.25);
  EXPECT_EQ(request.width, 64u);
  EXPECT_EQ(request.height, 48u);
  EXPECT_TRUE(request.moving);
}

TEST(PictureRequest, LacksNoFieldAndHasNoOtherType) {
  const Json whole = a_request();
  for (const auto& [name, value] : whole.items()) {
    if (name == "type") continue;
    Json without = a_request();
    without.erase(name);
    EXPECT_THROW(picture_request_of(without), NotOurs) << name;
    Json other = a_request();
    other[name] = "x";
    EXPECT_THROW(picture_request_of(other), NotOurs) << name;
  }
  Json large = a_request();
  large["width"] = 5000;
  EXPECT_THROW(picture_request_of(large), UserError);
}

TEST(Choices, GoThereAndBack) {
  const ViewChoices choices{.configuration = "fast",
                            .lights = {"1,2,3"},
                            .mirrors = {},
                            .mantissa_bits = 12,
                            .packets = {},
                            .lines = 64,
                            .reflections = {}};
  EXPECT_EQ(choices_of(json_of(choices)), choices);
  Json other = json_of(choices);
  other["lights"] = {1};
  EXPECT_THROW(choices_of(other), NotOurs);
}

}  // namespace
}  // namespace dynrt::host
