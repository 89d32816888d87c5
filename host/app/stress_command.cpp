// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt stress: the stiff and extreme cases of host/analysis/stress on a board, a line each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include "hls/json_text.h"
#include "host/analysis/stress/run.h"
#include "host/app/arguments.h"
#include "host/app/command.h"
#include "host/app/progress.h"
#include "host/app/temporary_folder.h"
#include "host/app/text.h"
#include "host/board/load_configuration.h"
#include "host/error.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

struct Arguments {
  std::vector<std::string> cases;
  std::string board = "model";
  std::string configuration = "thesis";
  std::string format;
  std::string json;
  bool list = false;
  bool markdown = false;
};

/// Configurations in another number format: files that the program builds when they are loaded.
class OtherFormat {
 public:
  explicit OtherFormat(const std::string& format) : flag_("--format " + format) {
    const std::size_t comma = format.find(',');
    if (comma == std::string::npos || !parse(format.substr(0, comma), exponent_bits_) ||
        !parse(format.substr(comma + 1), mantissa_bits_)) {
      refuse("--format {}: write the bits of exponent and mantissa, for example 7,12", format);
    }
  }

  /// The file of a configuration of the table, with its format changed.
  std::string file(const std::string& configuration) const {
    if (is_configuration_file(configuration)) {
      refuse("--format: --config {} is a file, which has its own format; name a configuration",
             configuration);
    }
    if (listed_configuration(configuration) == nullptr) {
      refuse("--format: there is no configuration '{}'", configuration);
    }
    const nlohmann::ordered_json keys{{"like", configuration},
                                      {"exponent_bits", exponent_bits_},
                                      {"mantissa_bits", mantissa_bits_}};
    const auto path =
        folder_ / fmt::format("{}_{}_{}.json", configuration, exponent_bits_, mantissa_bits_);
    std::ofstream(path) << hls::json_text(keys);
    return path.string();
  }

  /// The mistake in such a file, reported for the flag that made it, as the user has not seen its
  /// lines.
  std::string of_flag(const std::string& sentence, const std::string& file) const {
    const std::string named = "configuration " + file + ": ";
    std::size_t at = sentence.find(named);
    if (at == std::string::npos) return sentence;
    at += named.size();
    if (sentence.compare(at, 5, "line ") == 0) at = sentence.find(": ", at) + 2;
    return flag_ + ": " + sentence.substr(at);
  }

 private:
  std::string flag_;
  unsigned exponent_bits_ = 0, mantissa_bits_ = 0;
  TemporaryFolder folder_;
};

std::unique_ptr<Board> open_board(const Arguments& arguments, const std::string& configuration,
                                  const std::optional<OtherFormat>& format) {
  const std::string file = format ? format->file(configuration) : configuration;
  try {
    return make_board(configurations(), {arguments.board, file, ""});
  } catch (const UserError& error) {
    if (!format) throw;
    throw UserError(format->of_flag(error.what(), file));
  }
}

std::vector<std::string> groups() {
  std::vector<std::string> names;
  for (const stress::Case& c : stress::cases()) {
    if (names.empty() || names.back() != c.group) names.push_back(c.group);
  }
  return names;
}

int list(std::span<const stress::Case* const> cases) {
  std::string text;
  for (const stress::Case* c : cases) {
    text += fmt::format("{:<36}{}\n", c->full_name(), c->about);
  }
  say(text);
  return kDone;
}

int run(const Arguments& arguments) {
  const std::vector<const stress::Case*> cases = stress::find_cases(arguments.cases);
  if (arguments.list) return list(cases);
  if (!arguments.json.empty()) check_output_path(arguments.json);
  std::optional<OtherFormat> format;
  if (!arguments.format.empty()) format.emplace(arguments.format);
  stress::Boards boards(
      [&](const std::string& configuration) {
        return open_board(arguments, configuration, format);
      },
      arguments.configuration);
  boards.get();  // its mistakes come first

  const auto begin = std::chrono::steady_clock::now();
  std::vector<stress::Result> results;
  for (const stress::Case* c : cases) {
    {
      Progress progress(
          fmt::format("{} ({} of {})", c->full_name(), results.size() + 1, cases.size()));
      results.push_back(stress::run_case(*c, boards));
    }
    if (!arguments.markdown) say(stress::line_of(results.back()) + "\n");
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (!arguments.json.empty()) {
    const auto json =
        stress::json_of(results, arguments.configuration, arguments.board, seconds.count());
    write_text(arguments.json, hls::json_text(json));
  }
  say(arguments.markdown ? stress::markdown_of(results)
                         : stress::summary_of(results, seconds.count()) + "\n");
  const bool all_within = std::ranges::all_of(results, &stress::Result::within);
  const bool any_rays =
      std::ranges::any_of(results, [](const stress::Result& r) { return r.outcome.rays > 0; });
  return all_within && any_rays ? kDone : kDifferent;
}

}  // namespace

Command add_stress_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "stress", "run hard and extreme cases, and compare the errors of each with its bound");
  command
      ->add_option("CASE", arguments->cases,
                   fmt::format("cases by name (group/name) or whole groups ({}); default: all",
                               fmt::join(groups(), ", ")))
      ->option_text(" ");
  command->add_flag("--list", arguments->list, "list the cases without running them");
  command->add_option("--board", arguments->board, "model or rtl")->option_text("BOARD [model]");
  add_configuration_flag(*command, arguments->configuration);
  command
      ->add_option("--format", arguments->format,
                   "build the configuration with these bits of exponent and mantissa instead of "
                   "its own; the cases then have no bound")
      ->option_text("E,M");
  command->add_flag("--markdown", arguments->markdown,
                    "print the results as the table of docs/results/stress.md");
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
