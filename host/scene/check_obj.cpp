// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

#include "host/scene/check_file.h"
#include "host/scene/text_lines.h"
#include "host/scene/wording.h"

namespace dynrt::host {

namespace {

// Every statement of the format's specification (version 3.0), superseded ones included.
constexpr std::array<std::string_view, 46> kStatements = {
    "v",      "vt",     "vn",         "vp",        "cstype",   "deg",   "bmat",   "step",
    "p",      "l",      "f",          "fo",        "curv",     "curv2", "surf",   "parm",
    "trim",   "hole",   "scrv",       "sp",        "end",      "con",   "g",      "s",
    "mg",     "o",      "bevel",      "c_interp",  "d_interp", "lod",   "maplib", "usemap",
    "usemtl", "mtllib", "shadow_obj", "trace_obj", "ctech",    "stech", "call",   "csh",
    "bsp",    "bzp",    "cdc",        "cdp",       "res",      "maplod"};

class ObjCheck {
 public:
  ObjCheck(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  std::vector<std::string> run() {
    while (!text_.empty()) statement(next_line());
    // A face may come before its vertices, so the largest index is judged at the end.
    if (largest_index_ > vertices_) {
      wording::fail(wording::kObjFaceRange, path_, largest_line_, largest_index_, vertices_);
    }
    return std::move(material_files_);
  }

 private:
  // A line, with those that it goes on in after a backslash at its end.
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
    if (keyword.empty() || keyword.starts_with('#')) return;
    if (keyword == "v") {
      vertex(line);
    } else if (keyword == "f" || keyword == "fo") {
      face(line);
    } else if (keyword == "mtllib") {
      material_files_.emplace_back(trim(line));
    } else if (std::find(kStatements.begin(), kStatements.end(), keyword) == kStatements.end()) {
      wording::fail(wording::kObjKeyword, path_, line_, printable(keyword));
    }
  }

  void vertex(std::string_view line) {
    const std::string_view all = trim(line);
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = take_word(line);
      const auto number = to_number(word);
      if (!number) wording::fail(wording::kObjVertex, path_, line_, printable(all));
      if (!(std::abs(*number) <= FLT_MAX)) {
        wording::fail(wording::kObjVertexNotFinite, path_, line_, vertices_ + 1, word);
      }
    }
    ++vertices_;
  }

  void face(std::string_view line) {
    int corners = 0;
    for (auto word = take_word(line); !word.empty() && word[0] != '#'; word = take_word(line)) {
      corner(word);
      ++corners;
    }
    if (corners < 3) wording::fail(wording::kObjFaceShort, path_, line_, corners);
  }

  void corner(std::string_view word) {
    const std::string_view all = word;
    const auto index = to_integer(take_until(word, '/'));
    if (!index || *index == 0) wording::fail(wording::kObjFaceIndex, path_, line_, printable(all));
    if (*index < -vertices_) {
      wording::fail(wording::kObjFaceRange, path_, line_, *index, vertices_);
    }
    if (*index > largest_index_) {
      largest_index_ = *index;
      largest_line_ = line_;
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
  long line_ = 0, next_line_ = 1, largest_line_ = 0;
  long long vertices_ = 0, largest_index_ = 0;
  std::vector<std::string> material_files_;
};

}  // namespace

std::vector<std::string> check_obj(std::string_view text, const std::string& path) {
  return ObjCheck(text, path).run();
}

}  // namespace dynrt::host
