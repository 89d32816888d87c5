// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the page asks and what it gets. A question is JSON, {"type": .., ..}. An answer is JSON too,
// with numbers of 32 bits behind it where there are many, such as pixels.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/view/scenery.h"
#include "host/view/studio.h"

namespace dynrt::host {

using Json = nlohmann::ordered_json;

/// A question that no page of ours asks.
struct NotOurs : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Answer {
  Json head = Json::object();
  std::vector<std::uint32_t> words{};

  /// The length of the head's text, the text filled up with spaces to whole words, the words; all
  /// little-endian.
  std::string bytes() const;
};

/// A picture that the page asks for.
struct Shot {
  Viewpoint from;
  unsigned width = 0, height = 0;
  bool moving = false;  ///< another one follows: no hit records are needed
};

/// Throws NotOurs for text that is no object with a "type".
Json question_of(const std::string& text);
/// Throw NotOurs for fields that lack or have another type.
Shot shot_of(const Json& question);
ViewChoices choices_of(const Json& question);
double number_of(const Json& question, const char* field);
std::string text_of(const Json& question, const char* field);
unsigned count_of(const Json& question, const char* field);

Json json_of(const glm::dvec3& v);
Json json_of(const Viewpoint& from);
Json json_of(const ViewChoices& choices);

}  // namespace dynrt::host
