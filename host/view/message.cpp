// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/message.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace dynrt::host {

namespace {

const Json& field_of(const Json& question, const char* field) {
  const auto found = question.find(field);
  if (found == question.end()) throw NotOurs(fmt::format("it has no \"{}\"", field));
  return *found;
}

double number_in(const Json& value, const char* field) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw NotOurs(fmt::format("\"{}\" is no number", field));
  }
  return value.get<double>();
}

glm::dvec3 vector_of(const Json& question, const char* field) {
  const Json& value = field_of(question, field);
  if (!value.is_array() || value.size() != 3) {
    throw NotOurs(fmt::format("\"{}\" is not three numbers", field));
  }
  return {number_in(value[0], field), number_in(value[1], field), number_in(value[2], field)};
}

std::vector<std::string> texts_of(const Json& question, const char* field) {
  const Json& value = field_of(question, field);
  if (!value.is_array()) throw NotOurs(fmt::format("\"{}\" is no list", field));
  std::vector<std::string> texts;
  for (const Json& text : value) {
    if (!text.is_string()) {
      throw NotOurs(fmt::format("\"{}\" holds something else than text", field));
    }
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::optional<unsigned> optional_count(const Json& question, const char* field) {
  if (field_of(question, field).is_null()) return std::nullopt;
  return count_of(question, field);
}

Json or_null(const std::optional<unsigned>& count) { return count ? Json(*count) : Json(); }

}  // namespace

static_assert(std::endian::native == std::endian::little);

std::string Answer::bytes() const {
  constexpr std::size_t kWord = sizeof(std::uint32_t);
  std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + kWord - 1) / kWord * kWord, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string all(kWord + text.size() + kWord * words.size(), '\0');
  std::memcpy(all.data(), &length, kWord);
  std::memcpy(all.data() + kWord, text.data(), text.size());
  if (!words.empty()) {
    std::memcpy(all.data() + kWord + text.size(), words.data(), kWord * words.size());
  }
  return all;
}

Json question_of(const std::string& text) {
  Json question = Json::parse(text, nullptr, false);
  if (!question.is_object()) throw NotOurs("it is no JSON object");
  text_of(question, "type");
  return question;
}

double number_of(const Json& question, const char* field) {
  return number_in(field_of(question, field), field);
}

std::string text_of(const Json& question, const char* field) {
  const Json& value = field_of(question, field);
  if (!value.is_string()) throw NotOurs(fmt::format("\"{}\" is no text", field));
  return value.get<std::string>();
}

unsigned count_of(const Json& question, const char* field) {
  const Json& value = field_of(question, field);
  constexpr std::int64_t kMost = 1 << 30;
  if (!value.is_number_integer() || value < 0 || value.get<std::uint64_t>() > kMost) {
    throw NotOurs(fmt::format("\"{}\" is no count", field));
  }
  return value.get<unsigned>();
}

PictureRequest picture_request_of(const Json& question) {
  PictureRequest request;
  request.from.position = vector_of(question, "position");
  request.from.look_at = vector_of(question, "look_at");
  request.from.up = vector_of(question, "up");
  request.from.field_of_view = number_of(question, "field_of_view");
  request.from.time = number_of(question, "time");
  request.width = count_of(question, "width");
  request.height = count_of(question, "height");
  if (!field_of(question, "moving").is_boolean()) {
    throw NotOurs("\"moving\" is neither true nor false");
  }
  request.moving = question["moving"].get<bool>();
  check_size(request.width, request.height);
  return request;
}

ViewChoices choices_of(const Json& question) {
  return {.configuration = text_of(question, "configuration"),
          .lights = texts_of(question, "lights"),
          .mirrors = texts_of(question, "mirrors"),
          .mantissa_bits = optional_count(question, "mantissa_bits"),
          .packets = optional_count(question, "packets"),
          .lines = optional_count(question, "lines"),
          .reflections = optional_count(question, "reflections")};
}

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const Viewpoint& from) {
  return {{"position", json_of(from.position)},
          {"look_at", json_of(from.look_at)},
          {"up", json_of(from.up)},
          {"field_of_view", from.field_of_view},
          {"time", from.time}};
}

Json json_of(const ViewChoices& choices) {
  return {{"configuration", choices.configuration},
          {"lights", choices.lights},
          {"mirrors", choices.mirrors},
          {"mantissa_bits", or_null(choices.mantissa_bits)},
          {"packets", or_null(choices.packets)},
          {"lines", or_null(choices.lines)},
          {"reflections", or_null(choices.reflections)}};
}

}  // namespace dynrt::host
