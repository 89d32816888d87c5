// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/walk_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>

#include "hls/json_text.h"
#include "host/error.h"
#include "host/picture/gif.h"
#include "host/picture/output_file.h"
#include "host/picture/write_image.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kManifest[] = "walk.json";
/// walk.json grows with the walk, so it is rewritten only after this many times the time that
/// writing takes. If the walk is killed, the frames that it does not list are rendered again.
constexpr int kSavedSeldom = 10;

std::string frame_name(unsigned frame) { return fmt::format("frame_{:04}.png", frame); }

WalkRecord record_of(const Json& json) {
  WalkRecord record;
  json.at("frame").get_to(record.frame);
  json.at("time").get_to(record.time);
  if (!json.at("cycles").is_null()) record.cycles = json.at("cycles").get<std::uint64_t>();
  json.at("simulation_seconds").get_to(record.simulation_seconds);
  json.at("tree_seconds").get_to(record.tree_seconds);
  json.at("pack_seconds").get_to(record.pack_seconds);
  const Json& upload = json.at("upload");
  upload.at("transactions").get_to(record.upload.transactions);
  upload.at("bus_clocks").get_to(record.upload.bus_clocks);
  upload.at("bus_clock_hz").get_to(record.upload.clock_hz);
  record.upload.bytes_written = 4 * upload.at("words").get<std::uint64_t>();
  json.at("words").get_to(record.words);
  json.at("nodes").get_to(record.nodes);
  json.at("list_entries").get_to(record.entries);
  record.general = json.value("general", false);
  return record;
}

bool is_frame_or_manifest(const std::string& name) {
  static const std::regex pattern(R"(frame_\d{4}\.png|walk\.json)");
  return std::regex_match(name, pattern);
}

bool is_abandoned(const fs::path& path) { return is_frame_or_manifest(abandoned(path)); }

bool is_ours(const fs::path& path) {
  return is_frame_or_manifest(path.filename().string()) || is_abandoned(path);
}

}  // namespace

Json json_of(const WalkRecord& record) {
  return {{"frame", record.frame},
          {"time", record.time},
          {"cycles", record.cycles ? Json(*record.cycles) : Json()},
          {"simulation_seconds", record.simulation_seconds},
          {"tree_seconds", record.tree_seconds},
          {"pack_seconds", record.pack_seconds},
          {"upload",
           {{"words", record.uploaded_words()},
            {"transactions", record.upload.transactions},
            {"bus_clocks", record.upload.bus_clocks},
            {"bus_clock_hz", record.upload.clock_hz},
            {"seconds", record.upload_seconds()}}},
          {"words", record.words},
          {"nodes", record.nodes},
          {"list_entries", record.entries},
          {"general", record.general}};
}

void check_walk_folder(const std::string& folder) {
  std::error_code unreachable;
  // "frames/" and "frames" are one folder.
  const std::string path = (fs::path(folder) / "").parent_path().string();
  if (!fs::exists(path, unreachable)) return check_output_path(path);
  if (!fs::is_directory(path, unreachable)) cannot_write(path, std::strerror(ENOTDIR));
  check_output_path(fs::path(path) / kManifest);
}

WalkFolder::WalkFolder(std::string path, WalkSettings settings, bool again)
    : path_(std::move(path)), settings_(std::move(settings)) {
  if (!fs::exists(path_)) return;
  if (!again) read();
  remove_files([&](const fs::path& file) { return again ? is_ours(file) : is_abandoned(file); });
}

std::vector<fs::path> WalkFolder::files() const {
  std::vector<fs::path> found;
  std::error_code error;
  fs::directory_iterator at(path_, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code gone;
    if (at->is_regular_file(gone)) found.push_back(at->path());
  }
  if (error) {
    refuse("{}: cannot list the files of this folder: {}; name another --out", path_,
           error.message());
  }
  return found;
}

void WalkFolder::remove_files(const std::function<bool(const fs::path&)>& which) const {
  for (const fs::path& file : files()) {
    std::error_code error;
    if (which(file) && !fs::remove(file, error) && error) {
      refuse("{}: cannot remove this file: {}; name another --out", file.string(), error.message());
    }
  }
}

void WalkFolder::read() {
  const fs::path manifest = fs::path(path_) / kManifest;
  if (!fs::exists(manifest)) {
    for (const fs::path& file : files()) {
      const std::string name = file.filename().string();
      if (is_ours(file) && name[0] != '.') {
        refuse(
            "{}: the folder has a {} but no {}, so dynrt did not write it as a walk; name another "
            "--out, or give --again to replace its frames",
            path_, name, kManifest);
      }
    }
    return;
  }
  std::vector<std::string> before;
  try {
    std::ifstream file(manifest);
    if (!file) {
      refuse("{}: cannot read this file: {}; name another --out", manifest.string(),
             std::strerror(errno));
    }
    const Json json = Json::parse(file);
    for (const auto& [name, value] : settings_) {
      // A walk of an earlier dynrt may lack one, which makes it another walk.
      before.push_back(json.at("settings").value(name, std::string()));
    }
    for (const auto& [name, record] : json.at("frames").items()) {
      records_[name] = json_of(record_of(record));
    }
  } catch (const Json::exception& error) {
    refuse(
        "{}: a walk did not write this file ({}); name another --out, or give --again to start "
        "again",
        manifest.string(), error.what());
  }
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    const auto& [name, value] = settings_[i];
    if (before[i] == value) continue;
    if (name == kSceneContent) {
      refuse(
          "{}: the folder holds frames of an older version of the scene; name another --out, or "
          "give --again to replace them",
          path_);
    }
    refuse(
        "{}: the folder holds frames of another walk, with {} '{}' where this walk has '{}'; name "
        "another --out, or give --again to replace them",
        path_, name, before[i], value);
  }
}

std::optional<WalkRecord> WalkFolder::kept(unsigned frame, unsigned width, unsigned height) const {
  const auto found = records_.find(frame_name(frame));
  if (found == records_.end() || !is_whole_picture(name(frame), width, height)) return std::nullopt;
  return record_of(*found);
}

void WalkFolder::write(const Frame& frame, const WalkRecord& record) {
  fs::create_directory(path_);
  // walk.json must exist before the first picture, to identify the walk, and must not list a
  // picture before the picture exists.
  if (records_.empty()) save();
  write_image(name(record.frame), frame);
  records_[frame_name(record.frame)] = json_of(record);
  if (Clock::now() - saved_ >= kSavedSeldom * save_takes_) save();
}

void WalkFolder::save() {
  const auto begin = Clock::now();
  Json settings = Json::object();
  for (const auto& [name, value] : settings_) settings[name] = value;
  const Json json = {
      {"about", "frames of a walk of dynrt; the same command renders those that are missing"},
      {"settings", settings},
      {"frames", records_}};
  write_text(fs::path(path_) / kManifest, hls::json_text(json, 1));
  saved_ = Clock::now();
  save_takes_ = saved_ - begin;
}

std::string WalkFolder::name(unsigned frame) const { return fs::path(path_) / frame_name(frame); }

void WalkFolder::remove() const {
  remove_files(is_ours);
  std::error_code not_empty;
  fs::remove(path_, not_empty);
}

}  // namespace dynrt::host
