// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include "host/error.h"
#include "host/scene/check_file.h"
#include "host/scene/text_lines.h"

namespace dynrt::host {

namespace {

class ObjCheck {
 public:
  ObjCheck(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  std::vector<std::string> run() {
    while (!text_.empty()) statement(next_line());
    return std::move(material_files_);
  }

 private:
  /// A line, with those that it goes on in after a backslash at its end.
  std::string_view next_line() {
    line_ = next_line_++;
    std::string_view line = trim(take_until(text_, '\n'));
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    for (; line.ends_with('\\'); ++next_line_) {
      joined_ += std::string(line.substr(0, line.size() - 1)) + ' ';
      line = trim(take_until(text_, '\n'));
    }
    return joined_ += line;
  }

  void statement(std::string_view line) {
    const std::string_view keyword = take_word(line);
    if (keyword == "v") {
      vertex(line);
    } else if (keyword == "f" || keyword == "fo") {
      face(line);
    } else if (keyword == "mtllib") {
      material_files_.emplace_back(trim(line));
    }
  }

  void vertex(std::string_view line) const {
    const std::string_view all = trim(line);
    for (int k = 0; k < 3; ++k) {
      if (!to_number(take_word(line))) {
        refuse("{}:{}: a vertex needs three numbers, not '{}'", path_, line_, printable(all));
      }
    }
  }

  void face(std::string_view line) const {
    int corners = 0;
    for (auto word = take_word(line); !word.empty() && word[0] != '#'; word = take_word(line)) {
      ++corners;
    }
    if (corners < 3) {
      refuse("{}:{}: a face needs at least three vertices, but this one has {}", path_, line_,
             corners);
    }
  }

  static std::string printable(std::string_view word) {
    std::string text(word.substr(0, 40));
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
    return text;
  }

  std::string_view text_;
  const std::string& path_;
  std::string joined_;
  long line_ = 0, next_line_ = 1;
  std::vector<std::string> material_files_;
};

}  // namespace

std::vector<std::string> check_obj(std::string_view text, const std::string& path) {
  return ObjCheck(text, path).run();
}

}  // namespace dynrt::host
