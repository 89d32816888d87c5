// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/json_reader.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "host/error.h"
#include "host/scene/check_file.h"

namespace dynrt::host {

namespace {

constexpr char kJson[] = "{}:{}: not valid JSON: {}";

constexpr char kTop[] = "the file";
constexpr int kDeepest = 64;

std::string what_is_wrong(
    const std::string& message) {  // without nlohmann's "[...] parse error at"
  const auto colon = message.find(": ");
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// The deepest nesting of braces and brackets outside of strings. The parser's own callback would
/// take time that grows with the square of the elements.
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& path) {
  if (depth_of(text) > kDeepest) {
    refuse("{}: not a valid file: its JSON is nested deeper than {} levels", path, kDeepest);
  }
  try {
    nlohmann::json json = nlohmann::json::parse(text);
    if (!json.is_object()) refuse(kJson, path, 1, "it must be an object, {...}");
    return json;
  } catch (const nlohmann::json::exception& error) {
    const auto* parse_error = dynamic_cast<const nlohmann::json::parse_error*>(&error);
    const std::size_t byte = parse_error == nullptr ? 0 : std::min(parse_error->byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + byte, '\n');
    refuse(kJson, path, line, what_is_wrong(error.what()));
  }
}

JsonReader JsonReader::from_file(const std::string& path) {
  return {path, kTop, parse_json(read_file(path), path)};
}

void JsonReader::only(std::initializer_list<const char*> keys) const {
  for (const auto& [key, value] : json_.items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      refuse("there is no key '{}' here; the keys are {}", key,
             fmt::format("{}", fmt::join(keys, ", ")));
    }
  }
}

const nlohmann::json& JsonReader::at(const std::string& key) const {
  const auto found = json_.find(key);
  if (found == json_.end()) refuse("the key '{}' is missing", key);
  return *found;
}

void JsonReader::wrong_type(const std::string& key, const std::string& right) const {
  refuse("'{}' must be {}", key, right);
}

std::string JsonReader::below(const std::string& key) const {
  return where_ == kTop ? key : where_ + "." + key;
}

std::string JsonReader::text(const std::string& key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_string()) wrong_type(key, "a text");
  return value.get<std::string>();
}

double JsonReader::number(const std::string& key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_number()) wrong_type(key, "a number");
  return value.get<double>();
}

bool JsonReader::flag(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const nlohmann::json& value = at(key);
  if (!value.is_boolean()) wrong_type(key, "true or false");
  return value.get<bool>();
}

double JsonReader::positive(const std::string& key) const {
  const double value = number(key);
  if (!(value > 0.0)) wrong_type(key, "a number above zero");
  return value;
}

int JsonReader::integer(const std::string& key, int low, int high) const {
  const nlohmann::json& value = at(key);
  if (!value.is_number_integer() || value.get<double>() < low || value.get<double>() > high) {
    wrong_type(key, fmt::format("a whole number from {} to {}", low, high));
  }
  return value.get<int>();
}

std::vector<double> JsonReader::numbers(const std::string& key, std::size_t count) const {
  const nlohmann::json& value = at(key);
  const bool good = value.is_array() && value.size() == count &&
                    std::all_of(value.begin(), value.end(),
                                [](const nlohmann::json& number) { return number.is_number(); });
  if (!good) wrong_type(key, fmt::format("a list of {} numbers", count));
  return value.get<std::vector<double>>();
}

glm::dvec3 JsonReader::vector(const std::string& key) const {
  const std::vector<double> v = numbers(key, 3);
  return {v[0], v[1], v[2]};
}

glm::dvec2 JsonReader::pair(const std::string& key) const {
  const std::vector<double> v = numbers(key, 2);
  return {v[0], v[1]};
}

std::vector<glm::dvec3> JsonReader::vectors(const std::string& key) const {
  const nlohmann::json& list = at(key);
  std::vector<glm::dvec3> vectors;
  const auto is_number = [](const nlohmann::json& number) { return number.is_number(); };
  const auto is_vector = [&](const nlohmann::json& v) {
    return v.is_array() && v.size() == 3 && std::all_of(v.begin(), v.end(), is_number);
  };
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_vector)) {
    wrong_type(key, "a list of lists of 3 numbers");
  }
  for (const nlohmann::json& v : list) vectors.emplace_back(v[0], v[1], v[2]);
  return vectors;
}

std::vector<std::string> JsonReader::texts(const std::string& key) const {
  const nlohmann::json& list = at(key);
  const auto is_text = [](const nlohmann::json& text) { return text.is_string(); };
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text)) {
    wrong_type(key, "a list of texts");
  }
  return list.get<std::vector<std::string>>();
}

JsonReader JsonReader::object(const std::string& key) const {
  if (!at(key).is_object()) wrong_type(key, "an object, {...}");
  return {file_, below(key), at(key)};
}

std::vector<JsonReader> JsonReader::objects(const std::string& key) const {
  const nlohmann::json& list = at(key);
  std::vector<JsonReader> readers;
  if (!list.is_array()) wrong_type(key, "a list of objects, [{...}, ...]");
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_object()) wrong_type(key, "a list of objects, [{...}, ...]");
    readers.push_back({file_, fmt::format("{}[{}]", below(key), i), list[i]});
  }
  return readers;
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json_.items()) keys.push_back(key);
  return keys;
}

std::string JsonReader::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

double JsonReader::number(const std::string& key, double otherwise) const {
  return has(key) ? number(key) : otherwise;
}

glm::dvec3 JsonReader::vector(const std::string& key, const glm::dvec3& otherwise) const {
  return has(key) ? vector(key) : otherwise;
}

}  // namespace dynrt::host
