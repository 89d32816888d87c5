// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/choose_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "host/app/temporary_folder.h"
#include "host/board/load_configuration.h"
#include "host/error.h"

namespace dynrt::host {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void FormatWish::add_to(CLI::App& command) {
  command
      .add_option(
          "--max-error", max_error,
          "choose the bits of the float too: the cheapest that keep the error of the frame "
          "below this, as `dynrt choose` does; without it, the bits are those of the general "
          "core")
      ->option_text("E");
  command.add_option("--measure", measure, "the error that --max-error bounds")
      ->option_text("KIND.NAME [primary.t_p99]");
}

void FormatWish::check() const {
  if (!max_error) {
    if (!measure.empty())
      refuse("--measure {}: there is no bound; --max-error says how large this error may be",
             measure);
    return;
  }
  if (!std::isfinite(*max_error) || *max_error <= 0)
    refuse("--max-error {:g}: must be a number above 0", *max_error);
}

std::vector<Decision> FormatWish::choose(const SceneArguments& scene, const std::string& general,
                                         const std::string& out, unsigned jobs) const {
  const fs::path formats =
      fs::path(this_build().scripts).parent_path() / "hls" / "configs" / "formats.json";
  const std::string frame = fmt::format("{}x{}", scene.width, scene.height);
  const TemporaryFolder folder;
  const std::string chosen = (folder / "chosen.json").string();
  std::vector<std::string> words = {fs::read_symlink("/proc/self/exe").string(),
                                    "choose",
                                    scene.scene,
                                    "--size=" + frame,
                                    "--config=" + general,
                                    fmt::format("--max-error={}", *max_error),
                                    "--variants=" + formats.string(),
                                    fmt::format("--out={}.formats", out),
                                    "--json=" + chosen};
  if (!measure.empty()) words.push_back("--measure=" + measure);
  if (jobs > 0) words.push_back(fmt::format("--jobs={}", jobs));
  if (output_of(words).code != 0)
    refuse("--max-error {:g}: no number format keeps it on this scene; allow more", *max_error);
  const Json best = Json::parse(std::ifstream(chosen));
  std::vector<Decision> decisions;
  for (const auto& [name, keys] : Json::parse(std::ifstream(formats)).items()) {
    for (const auto& [key, value] : keys.items()) {
      if (std::ranges::find(decisions, key, &Decision::key) != decisions.end()) continue;
      decisions.push_back(
          {key, best.at("configuration").at(key),
           fmt::format("of {} the cheapest that keeps {} within {:g} in a frame of {}",
                       formats.filename().string(), best.at("measure").get<std::string>(),
                       *max_error, frame)});
    }
  }
  return decisions;
}

}  // namespace dynrt::host
