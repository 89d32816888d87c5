// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/load.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "host/scene/description.h"
#include "host/scene/import.h"
#include "host/scene/wording.h"

namespace dynrt::host {

namespace fs = std::filesystem;

std::vector<std::string> built_in_scenes() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& file : fs::directory_iterator(DYNRT_SCENES_FOLDER, missing)) {
    if (file.path().extension() == ".json") names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scene load_scene(const std::string& name_or_path) {
  const std::vector<std::string> names = built_in_scenes();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return load_description((fs::path(DYNRT_SCENES_FOLDER) / (name_or_path + ".json")).string());
  }
  std::error_code unreachable;
  if (!fs::exists(name_or_path, unreachable)) {
    wording::fail(wording::kUnknownScene, name_or_path, fmt::format("{}", fmt::join(names, ", ")));
  }
  if (fs::path(name_or_path).extension() == ".json") return load_description(name_or_path);
  return import_file(name_or_path);
}

}  // namespace dynrt::host
