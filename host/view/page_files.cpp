// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/page_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/error.h"
#include "host/program_part.h"

namespace dynrt::host {

namespace {

constexpr char kNoPageFile[] = "{}: the page of the window needs this file; {}";

namespace fs = std::filesystem;

constexpr char kLibrary[] = "/usr/share/nodejs/d3/dist/d3.min.js";  // Debian's node-d3

std::string text_of(const fs::path& path, const char* advice) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(kNoPageFile, path.string(), std::string(advice));
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string type_of(const fs::path& path) {
  if (path.extension() == ".html") return "text/html; charset=utf-8";
  if (path.extension() == ".css") return "text/css; charset=utf-8";
  return "text/javascript; charset=utf-8";
}

}  // namespace

std::map<std::string, PageFile> page_files() {
  constexpr char kAdvice[] = "install dynrt again, or keep the folder that it was built from";
  const fs::path folder = program_part(DYNRT_PAGE_FOLDER, "share/dynrt/view");
  std::map<std::string, PageFile> files;
  std::error_code missing;
  for (const auto& file : fs::directory_iterator(folder, missing)) {
    const fs::path& path = file.path();
    if (path.extension() != ".html" && path.extension() != ".css" && path.extension() != ".js") {
      continue;
    }
    files["/" + path.filename().string()] = {type_of(path), text_of(path, kAdvice)};
  }
  if (!files.contains("/index.html")) {
    refuse(kNoPageFile, (folder / "index.html").string(), std::string(kAdvice));
  }
  files["/"] = files["/index.html"];
  files["/d3.js"] = {type_of(kLibrary), text_of(kLibrary, "install Debian's package node-d3")};
  return files;
}

}  // namespace dynrt::host
