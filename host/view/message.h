// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The questions of the page and their answers. A question is JSON, {"type": .., ..}. An answer is
// JSON too; large arrays, such as pixels, follow it as words of 32 bits.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/view/loaded_scene.h"
#include "host/view/view_services.h"

namespace dynrt::host {

using Json = nlohmann::ordered_json;

/// A question that no page of ours asks.
struct NotOurs : std::runtime_error {
  explicit NotOurs(const std::string& reason)
      : runtime_error("this is no message of the window: " + reason) {}
};

struct Answer {
  Json head = Json::object();
  std::vector<std::uint32_t> words{};

  /// The answer as bytes, all little-endian: the length of the head's text, this text with spaces
  /// to fill its last word, the words.
  std::string bytes() const;
};

/// A picture that the page asks for.
struct PictureRequest {
  Viewpoint from;
  unsigned width = 0, height = 0;
  bool moving = false;  ///< a coarse picture, which needs no hit records
};

/// Throws NotOurs for text that is no object with a "type".
Json question_of(const std::string& text);
/// Throw NotOurs for a field that is missing or has another type.
PictureRequest picture_request_of(const Json& question);
ViewChoices choices_of(const Json& question);
double number_of(const Json& question, const char* field);
std::string text_of(const Json& question, const char* field);
unsigned count_of(const Json& question, const char* field);

Json json_of(const glm::dvec3& v);
Json json_of(const Viewpoint& from);
Json json_of(const ViewChoices& choices);

}  // namespace dynrt::host
