// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Reads the keys of one JSON object and says exactly where something is missing, misspelt or of
// another type: "office.json: objects[0].parts[3]: 'position' must be three numbers".
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.h"

namespace dynrt::host {

/// Throws UserError with the line if the text of the file is not valid JSON, is no object or is
/// nested too deeply.
nlohmann::json parse_json(std::string_view text, const std::string& path);

class JsonReader {
 public:
  static JsonReader from_file(const std::string& path);

  /// Throws UserError if the object has any other key.
  void only(std::initializer_list<const char*> keys) const;

  bool has(const std::string& key) const { return json_.contains(key); }
  std::string text(const std::string& key) const;
  double number(const std::string& key) const;
  bool flag(const std::string& key, bool otherwise) const;
  double positive(const std::string& key) const;
  int integer(const std::string& key, int low, int high) const;
  std::vector<double> numbers(const std::string& key, std::size_t count) const;
  glm::dvec3 vector(const std::string& key) const;
  glm::dvec2 pair(const std::string& key) const;                  ///< [a, b]
  std::vector<glm::dvec3> vectors(const std::string& key) const;  ///< [[a, b, c], ...]
  std::vector<std::string> texts(const std::string& key) const;
  JsonReader object(const std::string& key) const;
  std::vector<JsonReader> objects(const std::string& key) const;  ///< of an array
  std::vector<std::string> keys() const;

  /// The same, with a default for a missing key.
  std::string text(const std::string& key, const std::string& otherwise) const;
  double number(const std::string& key, double otherwise) const;
  glm::dvec3 vector(const std::string& key, const glm::dvec3& otherwise) const;

  /// Throws UserError with the place of this object.
  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> message, Args&&... args) const {
    host::refuse("{}: {}: {}", file_, where_, fmt::format(message, std::forward<Args>(args)...));
  }

  const std::string& file() const { return file_; }
  const std::string& where() const { return where_; }
  bool is_text(const std::string& key) const { return json_.at(key).is_string(); }

 private:
  JsonReader(std::string file, std::string where, nlohmann::json json)
      : file_(std::move(file)), where_(std::move(where)), json_(std::move(json)) {}

  const nlohmann::json& at(const std::string& key) const;
  [[noreturn]] void wrong_type(const std::string& key, const std::string& right) const;
  std::string below(const std::string& key) const;

  std::string file_, where_;
  nlohmann::json json_;
};

}  // namespace dynrt::host
