// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

#include "host/error.h"
#include "host/scene/check_file.h"
#include "host/scene/text_lines.h"

namespace dynrt::host {

namespace {

constexpr char kPlyShort[] = "{}:{}: the line has fewer numbers than element '{}' has properties";

/// Bytes of each of the format's types, by both of its names.
const std::map<std::string_view, unsigned> kBytes = {
    {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
    {"uint16", 2}, {"ushort", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
    {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};

struct Property {
  unsigned bytes = 0;
  unsigned count_bytes = 0;  // of the number that begins a list; 0: no list
};

struct Element {
  std::string_view name;
  long long count = 0;
  std::vector<Property> properties;
};

class PlyCheck {
 public:
  PlyCheck(std::string_view text, const std::string& path)
      : text_(text), rest_(text), path_(path) {}

  /// Where the data begin.
  std::size_t run() {
    header();
    const std::size_t data = text_.size() - rest_.size();
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      for (long long i = 0; i < element.count; ++i) {
        const bool whole = ascii_ ? line_of(element) : bytes_of(element);
        if (!whole) {
          refuse(
              "{}: the PLY header announces {} of element '{}', but the file ends after {}; it "
              "seems cut off",
              path_, element.count, element.name, i);
        }
      }
    }
    return data;
  }

  bool is_ascii() const { return ascii_; }

 private:
  std::string_view next_line() {
    ++line_;
    return trim(take_until(rest_, '\n'));
  }

  void header() {
    for (;;) {
      if (rest_.empty()) {
        refuse("{}: the PLY header has no 'end_header'; the file seems cut off", path_);
      }
      const std::string_view line = next_line();
      std::string_view words = line;
      const std::string_view keyword = take_word(words);
      if (keyword == "end_header") return;
      const bool good = keyword == "format"     ? format(take_word(words))
                        : keyword == "element"  ? element(words)
                        : keyword == "property" ? property(words)
                                                : true;
      if (!good) {
        refuse("{}:{}: '{}' is not a line of a PLY header", path_, line_, line.substr(0, 60));
      }
    }
  }

  bool format(std::string_view name) {
    ascii_ = name == "ascii";
    big_endian_ = name == "binary_big_endian";
    return ascii_ || big_endian_ || name == "binary_little_endian";
  }

  bool element(std::string_view words) {
    const std::string_view name = take_word(words);
    const auto count = to_integer(take_word(words));
    if (name.empty() || !count || *count < 0) return false;
    elements_.push_back({name, *count, {}});
    return true;
  }

  bool property(std::string_view words) {
    if (elements_.empty()) return false;
    Property property;
    std::string_view type = take_word(words);
    if (type == "list") {
      const std::string_view count = take_word(words);
      if (!kBytes.contains(count) || count.starts_with("float") || count == "double") return false;
      property.count_bytes = kBytes.at(count);
      type = take_word(words);
    }
    if (!kBytes.contains(type) || take_word(words).empty()) return false;
    property.bytes = kBytes.at(type);
    elements_.back().properties.push_back(property);
    return true;
  }

  /// One element is one line, as Assimp expects it. False at the file's end.
  bool line_of(const Element& element) {
    std::string_view line;
    do {
      if (rest_.empty()) return false;
      line = next_line();
    } while (line.empty());
    for (const Property& property : element.properties) {
      double numbers = 1.0;
      if (property.count_bytes > 0) {
        const auto count = to_number(take_word(line));
        if (!count) refuse(kPlyShort, path_, line_, element.name);
        numbers = *count;
      }
      for (double k = 0.0; k < numbers; ++k) {
        if (take_word(line).empty()) refuse(kPlyShort, path_, line_, element.name);
      }
    }
    return true;
  }

  bool bytes_of(const Element& element) {
    for (const Property& property : element.properties) {
      std::uint64_t numbers = 1;
      if (property.count_bytes > 0) {
        if (rest_.size() < property.count_bytes) return false;
        numbers = unsigned_number(property.count_bytes);
        rest_.remove_prefix(property.count_bytes);
      }
      if (numbers > rest_.size() / property.bytes) return false;
      rest_.remove_prefix(numbers * property.bytes);
    }
    return true;
  }

  std::uint64_t unsigned_number(unsigned bytes) const {
    std::uint64_t number = 0;
    for (unsigned b = 0; b < bytes; ++b) {
      const unsigned place = big_endian_ ? bytes - 1 - b : b;
      number |= static_cast<std::uint64_t>(static_cast<unsigned char>(rest_[b])) << (8 * place);
    }
    return number;
  }

  const std::string_view text_;
  std::string_view rest_;
  const std::string& path_;
  long line_ = 0;
  bool ascii_ = false, big_endian_ = false;
  std::vector<Element> elements_;
};

}  // namespace

std::string mended_ply(std::string text, const std::string& path) {
  PlyCheck check(text, path);
  const std::size_t data = check.run();
  const bool newline_alone = text[data - 1] == '\n' && text[data - 2] != '\r';
  if (newline_alone && !check.is_ascii()) text.insert(data - 1, 1, '\r');
  return text;
}

}  // namespace dynrt::host
