// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/load.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "host/error.h"
#include "host/program_part.h"
#include "host/scene/check_file.h"
#include "host/scene/description.h"
#include "host/scene/import.h"
#include "host/scene/map.h"

namespace dynrt::host {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMapInPackage = ".pk3:";

const fs::path& scenes_folder() {
  static const fs::path folder = program_part(DYNRT_SCENES_FOLDER, "share/dynrt/scenes");
  return folder;
}

}  // namespace

std::vector<std::string> built_in_scenes() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& file : fs::directory_iterator(scenes_folder(), missing)) {
    if (file.path().extension() == ".json") names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scene load_scene(const std::string& name_or_path) {
  const std::vector<std::string> names = built_in_scenes();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return load_description((scenes_folder() / (name_or_path + ".json")).string());
  }
  if (const auto colon = name_or_path.rfind(kMapInPackage); colon != name_or_path.npos) {
    const auto name = colon + kMapInPackage.size();
    return load_map(name_or_path.substr(0, name - 1), name_or_path.substr(name));
  }
  std::error_code unreachable;
  if (!fs::exists(name_or_path, unreachable)) {
    refuse("there is no scene '{}': give a built-in name ({}) or the path of a file", name_or_path,
           fmt::format("{}", fmt::join(names, ", ")));
  }
  if (fs::is_directory(name_or_path, unreachable)) {
    refuse("{}: this is a folder, but a scene is a file; give the path of a file in it, such as {}",
           name_or_path, (fs::path(name_or_path) / "model.obj").string());
  }
  const std::string extension = fs::path(name_or_path).extension().string();
  if (extension == ".json") return load_description(name_or_path);
  if (extension == ".bsp") return map_scene(read_file(name_or_path), name_or_path);
  if (extension == ".pk3") return load_map(name_or_path, "");
  return import_file(name_or_path);
}

}  // namespace dynrt::host
