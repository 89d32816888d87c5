// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/special_core.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "hls/json_text.h"
#include "host/app/cache.h"
#include "host/app/scene_flags.h"
#include "host/app/temporary_folder.h"
#include "host/board/load_configuration.h"
#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;
using Decisions = std::vector<Decision>;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Json points_of(const Curve& curve) {
  Json json = Json::object();
  for (const auto& [number, clocks] : curve) json[std::to_string(number)] = clocks;
  return json;
}

Json points_of(const Layouts& layouts) {
  Json json = Json::object();
  for (const auto& [nodes, costs] : layouts) {
    json[std::to_string(nodes)] = {
        {"clocks", costs.clocks},
        {"bytes_per_ray", costs.bytes_per_ray ? Json(*costs.bytes_per_ray) : Json()}};
  }
  return json;
}

/// Finds the decisions for one scene.
class Search {
 public:
  Search(SceneFile& file, const SpecialiseWishes& wishes, const SceneAnalysis& analysis,
         const CoreConfiguration& general)
      : wishes_(wishes),
        analysis_(analysis),
        general_(general),
        name_(core_name(file.arguments().scene)),
        kept_(kept(wishes.keep, general)),
        meter_(file, wishes.frames) {
    frame_ = fmt::format("a frame of {}x{}{}", file.arguments().width, file.arguments().height,
                         analysis.needs.frames > 1 ? " at time 0" : "");
  }

  struct Found {
    Json analysis;       ///< SpecialCore::analysis
    Json configuration;  ///< as its file has it
  };
  Found run() {
    const Decisions most = {{"packets", general_.packets, "being measured"},
                            {"lines", general_.lines, "being measured"}};
    std::string measured;  // the file of the core whose frames are measured
    Layouts layouts;
    Decisions found;
    if (const std::vector<unsigned> numbers = nodes_of_a_line(most); !numbers.empty()) {
      layouts = try_layouts(numbers, [&](unsigned nodes) {
        measured = written(fmt::format("{}_nodes", nodes), joined(most, being_measured(nodes)));
        return count(measured, general_.packets, general_.lines);
      });
      const unsigned nodes = best_layout(layouts);
      found = {{"line_nodes", nodes, layout_reason(layouts, nodes, frame_)}};
      measured = written(fmt::format("{}_nodes", nodes), joined(most, being_measured(nodes)));
    }
    CountSearch search{.packets = general_.packets, .lines = general_.lines, .frame = frame_};
    search.percent = wishes_.max_slowdown;
    search.search_packets = !is_kept("packets");
    search.search_lines = !is_kept("lines");
    if (search.search_lines) search.least_lines = least_lines(joined(most, found));
    if (measured.empty()) measured = written("whole", most);
    const Counts counts = choose_counts(search, [&](unsigned packets, unsigned lines) {
      return count(measured, packets, lines).clocks;
    });
    const Decisions decisions = decided(joined(found, counts.decisions));
    return {
        {{"general", analysis_.general},
         {"needs", json_of(analysis_.needs)},
         {"layouts", points_of(layouts)},
         {"curves", {{"packets", points_of(counts.packets)}, {"lines", points_of(counts.lines)}}},
         {"left_out", left_out(decisions, general_)},
         {"configuration", json_of(decisions)}},
        configuration_json(decisions, name_, general_, analysis_.general)};
  }

 private:
  static Decisions joined(Decisions first, const Decisions& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }
  bool is_kept(const char* key) const {
    return std::ranges::find(kept_, key, &Decision::key) != kept_.end();
  }
  /// Every key, with these that were measured; of two for one key, the second.
  Decisions decided(const Decisions& measured) const {
    Decisions all = analysis_.decisions;
    for (const Decision& one : measured) all = replaced(std::move(all), {one});
    return replaced(replaced(std::move(all), wishes_.formats), kept_);
  }
  /// The file of a core that is not the last.
  std::string written(const std::string& folder, const Decisions& measured) const {
    fs::create_directories(work_ / folder);
    const fs::path path = work_ / folder / (name_ + ".json");
    write_text(path.string(), hls::json_text(configuration_json(decided(measured), name_, general_,
                                                                analysis_.general)));
    return path.string();
  }
  FrameCosts count(const std::string& configuration, unsigned packets, unsigned lines) {
    auto& core = lowered_[configuration];
    if (core.verilog.empty()) core = lowered(configuration, wishes_.jobs);
    return meter_.count(core, packets, lines);
  }

  /// Its counters tell what it reads, and cost no clock.
  static Decisions being_measured(unsigned nodes) {
    return {{"line_nodes", nodes, "being measured"}, {"counters", true, "being measured"}};
  }
  /// The numbers to try; none where the memory or the user leaves no choice.
  std::vector<unsigned> nodes_of_a_line(const Decisions& most) const {
    std::vector<unsigned> numbers;
    if (general_.memory == MemoryPath::kBanks || is_kept("line_nodes")) return numbers;
    for (unsigned nodes = 1;; nodes *= 2) {
      if (!can_be_made(written("tried", joined(most, being_measured(nodes))))) return numbers;
      numbers.push_back(nodes);
    }
  }
  /// The fewest that the rules allow beside all that is decided.
  unsigned least_lines(const Decisions& found) const {
    unsigned lines = 1;
    while (lines < general_.lines &&
           !can_be_made(written("tried", joined(found, {{"lines", lines, "being measured"}})))) {
      lines *= 2;
    }
    return std::min(lines, general_.lines);
  }

  const SpecialiseWishes& wishes_;
  const SceneAnalysis& analysis_;
  const CoreConfiguration& general_;
  const std::string name_;
  const Decisions kept_;
  CostMeter meter_;
  std::string frame_;
  std::map<std::string, LoweredCore> lowered_;
  const TemporaryFolder work_;
};

/// Of all that the decisions depend on.
std::string key_of(const SceneFile& file, const SpecialiseWishes& wishes,
                   const SceneAnalysis& analysis, const CoreConfiguration& general) {
  const ThisBuild build = this_build();
  const std::string description = content_of(build.description);
  const Json said = {{"scene", core_name(file.arguments().scene)},
                     {"analysis", analysis.json()},
                     {"general", json_of(general)},
                     {"formats", json_of(wishes.formats)},
                     {"view", words_of(file.arguments())},
                     {"latency", wishes.frames.memory.latency.value_or(0)},
                     {"row_clocks", wishes.frames.memory.row_clocks.value_or(0)},
                     {"keep", wishes.keep},
                     {"slowdown", wishes.max_slowdown},
                     {"fingerprint", build.fingerprint},
                     {"build", description},
                     {"program", digest(content_of("/proc/self/exe"))},
                     {"hlsc", digest(content_of(Json::parse(description).value("hlsc", "")))}};
  return digest(said.dump()).substr(0, 40);
}

/// The configuration is written last, so where it is, the analysis is too.
struct Entry {
  fs::path configuration, analysis;

  Json read() const {
    const bool is_whole = Json::parse(std::ifstream(configuration), nullptr, false).is_object();
    Json kept = Json::parse(std::ifstream(analysis), nullptr, false);
    return is_whole && kept.is_object() ? kept : Json();
  }
};

fs::path folder_for(const std::string& key) {
  const fs::path cache = cache_folder();
  const fs::path folder = cache / ("specialised-" + key);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    refuse("the cache {} cannot be written ({}); let DYNRT_CACHE name a folder that can",
           cache.string(), error.message());
  return folder;
}

/// Writes a file of a configuration with other values for some keys.
std::string written(const CoreConfiguration& configuration, const Decisions& others,
                    const TemporaryFolder& folder) {
  Json keys = json_of(configuration);
  keys.erase("name");
  for (const Decision& other : others) keys[other.key] = other.value;
  const std::string path = (folder / (configuration.name + ".json")).string();
  write_text(path, hls::json_text(keys));
  return path;
}

}  // namespace

void require_whole_build() {
  const Json build = Json::parse(content_of(this_build().description), nullptr, false);
  if (build.is_object() && build.value("program_only", false))
    refuse(
        "specialising a core needs hlsc, and scripts/demo built this program without; "
        "scripts/test --build-only builds the whole program");
}

std::string core_name(const std::string& scene) {
  const std::size_t map = scene.find(':');  // of a file of several maps
  std::string name = fs::path(scene.substr(0, map)).stem().string();
  if (map != std::string::npos) name += "_" + scene.substr(map + 1);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '_';
  }
  return name;
}

LoweredCore lowered(const std::string& configuration, unsigned jobs) {
  if (is_configuration_file(configuration)) {
    LoweredCore core{configuration, make_schedules(configuration, {}, jobs)};
    make_configuration(configuration, false, {}, jobs);
    return core;
  }
  const TemporaryFolder folder;
  return {configuration,
          make_verilog(written(*listed_configuration(configuration), {}, folder), {}, jobs)};
}

SpecialCore special_core(SceneFile& scene, const SpecialiseWishes& wishes) {
  const TemporaryFolder folder;
  SpecialCore core;
  core.general = find_configuration(configurations(), wishes.general, false).core();
  core.general.name = fs::path(wishes.general).stem().string();
  kept(wishes.keep, core.general);  // to refuse what is no key before the scene is read
  SceneAnalysis analysis = analyse(
      scene,
      wishes.formats.empty() ? wishes.general : written(core.general, wishes.formats, folder),
      wishes.frames);
  const bool is_file = is_configuration_file(wishes.general);
  analysis.general = is_file ? fs::absolute(wishes.general).string() : wishes.general;
  const std::string name = core_name(scene.arguments().scene);
  core.about = analysis.about();
  const std::string key = key_of(scene, wishes, analysis, core.general);
  const fs::path place = folder_for(key);
  const Entry entry{place / (name + ".json"), place / (name + ".analysis")};
  const FileLock alone(place / "lock");
  core.analysis = entry.read();
  core.configuration = entry.configuration.string();
  if (!core.analysis.is_null()) return core;
  const Search::Found found = Search(scene, wishes, analysis, core.general).run();
  write_text(entry.analysis.string(), hls::json_text(found.analysis));
  write_text(core.configuration, hls::json_text(found.configuration));
  core.analysis = found.analysis;
  return core;
}

}  // namespace dynrt::host
