// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "host/scene/check_file.h"
#include "host/scene/text_lines.h"
#include "host/scene/wording.h"

namespace dynrt::host {

namespace {

// Bytes of each of the format's types, by both of its names; whether it is read as an integer.
struct Type {
  unsigned bytes;
  bool is_signed, is_float;
};
const std::map<std::string_view, Type> kTypes = {
    {"char", {1, true, false}},    {"int8", {1, true, false}},    {"uchar", {1, false, false}},
    {"uint8", {1, false, false}},  {"short", {2, true, false}},   {"int16", {2, true, false}},
    {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, true, false}},
    {"int32", {4, true, false}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
    {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
    {"float64", {8, true, true}}};

struct Property {
  Type type;
  bool is_list = false;
  Type count{};  // of a list
  bool is_vertex_index = false;
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

class PlyCheck {
 public:
  PlyCheck(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  void run() {
    header();
    for (const Element& element : elements_) {
      if (element.properties.empty()) wording::fail(wording::kPlyNoProperty, path_, element.name);
      for (long long i = 0; i < element.count; ++i) {
        const bool whole = ascii_ ? line_element(element, i) : binary_element(element, i);
        if (!whole) wording::fail(wording::kPlyCutOff, path_, element.count, element.name, i);
      }
    }
  }

 private:
  std::string_view next_line() {
    ++line_;
    return trim(take_until(text_, '\n'));
  }

  void header() {
    if (next_line() != "ply") wording::fail(wording::kPlyMagic, path_);
    bool has_format = false;
    for (;;) {
      if (text_.empty()) wording::fail(wording::kPlyHeaderEnds, path_);
      const std::string_view line = next_line();
      std::string_view rest = line;
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") break;
      bool good = keyword.empty() || keyword == "comment" || keyword == "obj_info";
      if (keyword == "format") good = has_format = format(take_word(rest));
      if (keyword == "element") good = element(rest);
      if (keyword == "property" && !elements_.empty()) good = property(rest);
      if (!good) wording::fail(wording::kPlyHeader, path_, line_, line.substr(0, 60));
    }
    if (!has_format) wording::fail(wording::kPlyNoFormat, path_);
  }

  bool format(std::string_view name) {
    ascii_ = name == "ascii";
    swap_ = name == "binary_big_endian";
    return ascii_ || swap_ || name == "binary_little_endian";
  }

  bool element(std::string_view rest) {
    const std::string_view name = take_word(rest);
    const auto count = to_integer(take_word(rest));
    if (name.empty() || !count || *count < 0) return false;
    elements_.push_back({std::string(name), *count, {}});
    if (name == "vertex") vertices_ = *count;
    return true;
  }

  bool property(std::string_view rest) {
    Property property;
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.is_list = true;
      const auto count = kTypes.find(take_word(rest));
      if (count == kTypes.end() || count->second.is_float) return false;
      property.count = count->second;
      type = take_word(rest);
    }
    const auto found = kTypes.find(type);
    const std::string_view name = take_word(rest);
    if (found == kTypes.end() || name.empty()) return false;
    property.type = found->second;
    property.is_vertex_index =
        property.is_list && (name == "vertex_indices" || name == "vertex_index");
    elements_.back().properties.push_back(property);
    return true;
  }

  void check_index(double index, long long face) const {
    if (!(index >= 0.0 && index < static_cast<double>(vertices_))) {
      wording::fail(wording::kPlyIndex, path_, face, index, vertices_);
    }
  }

  // One line, one element: how every writer does it and Assimp expects it. False at the file's end.
  bool line_element(const Element& element, long long i) {
    std::string_view line;
    do {
      if (text_.empty()) return false;
      line = next_line();
    } while (line.empty());
    for (const Property& property : element.properties) {
      const double n = property.is_list ? word(line, element) : 1.0;
      for (double k = 0; k < n; ++k) {
        const double value = word(line, element);
        if (property.is_vertex_index) check_index(value, i);
      }
    }
    return true;
  }

  double word(std::string_view& line, const Element& element) const {
    const std::string_view text = take_word(line);
    const auto number = to_number(text);
    if (!number) wording::fail(wording::kPlyNumber, path_, line_, text.substr(0, 40), element.name);
    return *number;
  }

  bool binary_element(const Element& element, long long i) {
    for (const Property& property : element.properties) {
      double n = 1.0;
      if (property.is_list && !binary(property.count, n)) return false;
      for (double k = 0; k < n; ++k) {
        double value = 0.0;
        if (!binary(property.type, value)) return false;
        if (property.is_vertex_index) check_index(value, i);
      }
    }
    return true;
  }

  bool binary(Type type, double& value) {
    if (text_.size() < type.bytes) return false;
    uint64_t bits = 0;
    for (unsigned b = 0; b < type.bytes; ++b) {
      const unsigned place = swap_ ? type.bytes - 1 - b : b;
      bits |= static_cast<uint64_t>(static_cast<unsigned char>(text_[b])) << (8 * place);
    }
    text_.remove_prefix(type.bytes);
    if (type.is_float) {
      value = type.bytes == 4 ? std::bit_cast<float>(static_cast<uint32_t>(bits))
                              : std::bit_cast<double>(bits);
    } else {
      const unsigned spare = 64 - 8 * type.bytes;
      value = type.is_signed ? static_cast<double>(static_cast<int64_t>(bits << spare) >> spare)
                             : static_cast<double>(bits);
    }
    return true;
  }

  std::string_view text_;
  const std::string& path_;
  long line_ = 0;
  bool ascii_ = false, swap_ = false;
  long long vertices_ = 0;
  std::vector<Element> elements_;
};

}  // namespace

void check_ply(std::string_view text, const std::string& path) { PlyCheck(text, path).run(); }

}  // namespace dynrt::host
